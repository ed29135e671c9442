// What guards make of what they noticed: suspicion, alert states with their barks and cues, arrests.
#include <algorithm>

#include "base/det_math.h"
#include "raycore/query.h"
#include "sim/geometry.h"
#include "sim/guards.h"
#include "sim/noises.h"
#include "sim/player.h"
#include "sim/rules.h"
#include "world/eye.h"
#include "world/layers.h"

namespace gh::sim {

namespace {

using world::Alert;
using world::Bark;
using world::Cue;
using world::GuardState;

constexpr float kLookSeconds = 4.0f / 60.0f;       // between two looks
constexpr float kSightRate = 0.8f;                 // suspicion a second for each unit of stimulus
constexpr float kSightHeadroom = 12.0f;            // a faint sight alone saturates this far above itself
constexpr float kIndirectMost = kChasingAt - 1.0f;  // one indirect channel alone never starts a chase
constexpr float kHearingShare = 0.5f;              // suspicion for each dB above the hum
constexpr float kMostSuspicion = 40.0f;
constexpr float kTouchDistance = 0.75f;            // metres between feet: even in the dark one is felt
constexpr std::uint16_t kGraceTicks = 150;         // after the last stimulus, before suspicion fades
constexpr float kFadePerTick = 3.0f / 60.0f;
constexpr std::uint16_t kLoseTicks = 90;           // a chase goes on that long without a sight of the player
constexpr std::uint32_t kSuspiciousTicks = 240;    // a guard does not stand staring for longer
constexpr std::uint16_t kPlacesToSearch = 3;
constexpr float kBarkDb = 66.0f;
constexpr float kAlarmDb = 78.0f;

// Light of a body that appears `seen` bright from `metres` away, in log units above what is just noticed: a fully
// lit one 25 m off gives 0, twice as bright or 1.4 times nearer gives 10 more.
float sight_stimulus(float seen, float metres) {
    constexpr float kFullSize = 25.0f;
    if (!(seen > 0.0f)) return 0.0f;
    const float size = kFullSize / std::max(metres, 1.0f);
    return std::clamp(10.0f * det::log2(seen * size * size), 0.0f, kMostSuspicion);
}

void add_suspicion(GuardState& guard, float amount, float at_most, Cue cue) {
    if (!(amount > 0.0f)) return;
    guard.quiet_ticks = 0;
    const float raised = std::min(guard.suspicion + amount, std::max(at_most, guard.suspicion));
    if (raised > guard.suspicion) guard.raised_by = cue;
    guard.suspicion = raised;
}

void notice_sight(GuardState& guard) {
    const world::Percept& percept = guard.percept;
    if (percept.is_fresh == 0) return;
    const float direct = sight_stimulus(percept.sight, percept.sight_metres);
    const float mirrored = sight_stimulus(percept.mirror_sight, percept.mirror_metres);
    const auto longer = static_cast<std::uint16_t>(std::min(guard.seen_ticks + 4, 60000));
    guard.seen_ticks = direct > 0.0f ? longer : std::uint16_t{0};
    if (direct > 0.0f || mirrored > 0.0f) guard.last_known = percept.seen_at;
    const float share = kSightRate * kLookSeconds;
    add_suspicion(guard, mirrored * share, std::min(mirrored + kSightHeadroom, kIndirectMost), Cue::Mirrored);
    add_suspicion(guard, direct * share, std::min(direct + kSightHeadroom, kMostSuspicion), Cue::Seen);
}

void notice_noise(GuardState& guard) {
    const float above = guard.percept.heard_db - kFaintestDb;
    if (!(above > 0.0f)) return;
    add_suspicion(guard, above * kHearingShare, kIndirectMost, Cue::Heard);
    const bool knows_better = guard.alert == Alert::Chasing && guard.seen_ticks > 0;
    if (!knows_better) guard.last_known = guard.percept.heard_at;
}

void notice_touch(const world::State& state, GuardState& guard) {
    const glm::vec3 apart = state.player.position - guard.position;
    if (flat_length(apart) > kTouchDistance || std::abs(apart.y) > kGuardHeight) return;
    guard.last_known = state.player.position;
    add_suspicion(guard, kSearchingAt - guard.suspicion + 1.0f, kIndirectMost, Cue::Heard);
}

// A stone that hits says that somebody is there, and from where; not who.
void notice_blow(GuardState& guard) {
    if (guard.percept.is_struck == 0) return;
    constexpr float kWideAwake = 4.0f;  // above what starts a search
    add_suspicion(guard, std::max(kSearchingAt + kWideAwake - guard.suspicion, 1.0f), kIndirectMost, Cue::Struck);
    if (guard.alert != Alert::Chasing) guard.last_known = guard.percept.struck_from;
}

void bark(std::size_t g, Bark what, world::State& state) {
    emit(state, {.position = state.guards[g].position + glm::vec3(0.0f, 1.6f, 0.0f),
                 .loudness_db = what == Bark::Alarm ? kAlarmDb : kBarkDb,
                 .kind = world::NoiseKind::Bark,
                 .bark = what,
                 .by_guard = static_cast<std::uint8_t>(g)});
}

void enter(GuardState& guard, Alert alert) {
    guard.alert = alert;
    guard.state_ticks = 0;
    guard.wait_ticks = 0;
    guard.searched = 0;
    guard.path_count = 0;
}

// Up one or more rungs, as far as suspicion reaches. A chase also needs the player in plain view for long enough.
void rise(std::size_t g, world::State& state) {
    GuardState& guard = state.guards[g];
    const bool has_seen = guard.seen_ticks >= kReactionTicks;
    if (guard.suspicion >= kChasingAt && has_seen && guard.alert != Alert::Chasing) {
        enter(guard, Alert::Chasing);
        bark(g, Bark::Alarm, state);
    } else if (guard.suspicion >= kSearchingAt && guard.alert < Alert::Searching) {
        enter(guard, Alert::Searching);
        bark(g, Bark::WhoIsThere, state);
    } else if (guard.suspicion >= kSuspiciousAt && guard.alert < Alert::Suspicious) {
        enter(guard, Alert::Suspicious);
        bark(g, Bark::Huh, state);
    }
}

void calm_down(std::size_t g, world::State& state) {
    GuardState& guard = state.guards[g];
    guard.suspicion = 0.0f;
    guard.raised_by = Cue::None;
    enter(guard, Alert::Calm);
    bark(g, Bark::GaveUp, state);
}

// Down again: a chase turns into a search, a search ends after a few places, a start after a few seconds.
void fall(std::size_t g, world::State& state) {
    GuardState& guard = state.guards[g];
    if (guard.quiet_ticks > kGraceTicks) guard.suspicion = std::max(guard.suspicion - kFadePerTick, 0.0f);
    switch (guard.alert) {
        case Alert::Calm:
            return;
        case Alert::Suspicious:
            if (guard.state_ticks > kSuspiciousTicks && guard.suspicion < kSearchingAt) calm_down(g, state);
            return;
        case Alert::Searching:
            if (guard.searched > kPlacesToSearch) calm_down(g, state);
            return;
        case Alert::Chasing:
            if (guard.seen_ticks == 0 && guard.quiet_ticks > kLoseTicks) {
                guard.suspicion = std::min(guard.suspicion, kIndirectMost);
                enter(guard, Alert::Searching);
                bark(g, Bark::WhoIsThere, state);
            }
            return;
    }
}

bool can_seize(const GuardWorld& now, const world::State& state, std::size_t g) {
    const GuardState& guard = state.guards[g];
    if (guard.alert != Alert::Chasing || guard.seen_ticks < kReactionTicks) return false;
    const glm::vec3 way = state.player.position - guard.position;
    const float distance = flat_length(way);
    if (!(distance <= kCatchReach) || std::abs(way.y) > 1.2f) return false;
    const bool is_ahead = glm::dot(world::forward_of_yaw(guard.yaw), flat(way)) >= 0.5f * distance;
    const glm::vec3 chest = guard.position + glm::vec3(0.0f, 1.3f, 0.0f);
    const glm::vec3 body = state.player.position + glm::vec3(0.0f, 0.6f * state.player.height, 0.0f);
    const rc::Ray arm{.origin = chest, .direction = body - chest, .t_max = 1.0f};
    return is_ahead && !rc::any_hit(*now.snapshot.scene, arm, world::Solid);
}

}  // namespace

void judge_guards(const GuardWorld& now, world::State& state) {
    const bool is_playing = state.rules.outcome == world::Outcome::Playing;
    for (std::size_t g = 0; g < now.level.guards.size(); ++g) {
        GuardState& guard = state.guards[g];
        guard.state_ticks += 1;
        guard.quiet_ticks = static_cast<std::uint16_t>(std::min(guard.quiet_ticks + 1, 60000));
        if (!is_playing) continue;
        notice_sight(guard);
        notice_noise(guard);
        notice_touch(state, guard);
        notice_blow(guard);
        rise(g, state);
        fall(g, state);
        if (can_seize(now, state, g)) {
            catch_player(state);
            bark(g, Bark::Caught, state);
            return;
        }
    }
}

}  // namespace gh::sim
