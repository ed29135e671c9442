#include "sim/guards_animate.h"

#include "sim/geometry.h"
#include "sim/guards.h"

namespace gh::sim {

namespace {

using world::ClipId;
using world::GuardState;
using world::kTickSeconds;

constexpr float kStandsBelow = 0.15f;      // m/s
constexpr float kRunsAbove = 2.6f;         // m/s
constexpr float kBlendPerTick = 1.0f / 14.0f;
constexpr float kReachDistance = 1.5f;     // metres at which a chasing guard stretches out a hand
constexpr float kLongest = 3600.0f;        // seconds, of a clip nobody knows the length of

bool looks_about(const world::Level& level, std::size_t g, const GuardState& guard) {
    if (guard.wait_ticks == 0) return false;
    if (guard.alert == world::Alert::Searching) return true;
    const auto& patrol = level.guards[g].patrol;
    return guard.alert == world::Alert::Calm && !patrol.empty() && patrol[guard.patrol_next].looks_round;
}

ClipId clip_for(const world::Level& level, const world::State& state, std::size_t g) {
    const GuardState& guard = state.guards[g];
    const float distance = flat_length(state.player.position - guard.position);
    const bool is_arrest = state.rules.outcome == world::Outcome::Caught && distance < 2.0f * kReachDistance;
    if (is_arrest || (guard.alert == world::Alert::Chasing && guard.seen_ticks > 0 && distance < kReachDistance)) {
        return ClipId::Reach;
    }
    const float speed = flat_length(guard.velocity);
    if (speed >= kRunsAbove) return ClipId::Run;
    if (speed >= kStandsBelow) return ClipId::Walk;
    return looks_about(level, g, guard) ? ClipId::Look : ClipId::Stand;
}

float duration_of(const world::Level& level, std::size_t g, ClipId clip) {
    const std::uint32_t model = level.guards[g].model;
    if (model == world::kNoIndex) return kLongest;
    const std::uint32_t index = level.models[model].clip[static_cast<std::size_t>(clip)];
    if (index == world::kNoIndex) return kLongest;
    const float duration = level.models[model].clips[index].duration;
    return duration > 0.0f ? duration : kLongest;
}

float playback_speed(ClipId clip, const glm::vec3& velocity) {
    const float speed = flat_length(velocity);
    if (clip == ClipId::Walk) return speed / kGuardWalkSpeed;
    if (clip == ClipId::Run) return speed / kGuardRunSpeed;
    return 1.0f;
}

float played(const world::Level& level, std::size_t g, ClipId clip, float time, float by) {
    const float duration = duration_of(level, g, clip);
    time += by;
    if (clip == ClipId::Reach) return std::min(time, duration);  // the hand stays out
    while (time >= duration) time -= duration;
    return time;
}

}  // namespace

void animate_guard(const world::Level& level, std::size_t g, world::State& state) {
    GuardState& guard = state.guards[g];
    const ClipId wanted = clip_for(level, state, g);
    // A blend is finished before the next begins: with two clips there is nothing to blend three from.
    if (wanted != guard.clip && guard.clip_blend >= 1.0f) {
        const bool keeps_step = (wanted == ClipId::Walk && guard.clip == ClipId::Run) ||
                                (wanted == ClipId::Run && guard.clip == ClipId::Walk);
        const float share = guard.clip_time / duration_of(level, g, guard.clip);
        guard.clip_before = guard.clip;
        guard.clip_before_time = guard.clip_time;
        guard.clip = wanted;
        guard.clip_time = keeps_step ? share * duration_of(level, g, wanted) : 0.0f;
        guard.clip_blend = 0.0f;
    }
    guard.clip_blend = std::min(guard.clip_blend + kBlendPerTick, 1.0f);
    guard.clip_time = played(level, g, guard.clip, guard.clip_time,
                             playback_speed(guard.clip, guard.velocity) * kTickSeconds);
    if (guard.clip_blend < 1.0f) {
        guard.clip_before_time = played(level, g, guard.clip_before, guard.clip_before_time,
                                        playback_speed(guard.clip_before, guard.velocity) * kTickSeconds);
    }
}

}  // namespace gh::sim
