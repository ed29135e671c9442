// What guards see and hear: sense's answers, written down in State for the next tick's decisions.
#include <algorithm>
#include <span>

#include "base/det_math.h"
#include "sense/body.h"
#include "sense/exposure.h"
#include "sense/hearing.h"
#include "sense/sight.h"
#include "sim/carry.h"
#include "sim/geometry.h"
#include "sim/guards.h"
#include "sim/noises.h"

namespace gh::sim {

namespace {

constexpr std::uint32_t kLookPeriod = 4;      // ticks
constexpr float kCosHalfView = 0.42261826f;   // 65 degrees to either side
constexpr float kSightRange = 35.0f;          // metres

bool looks_now(const world::State& state, std::size_t guard) {
    return state.tick % kLookPeriod == guard % kLookPeriod;
}

bool is_own(const world::Noise& noise, std::size_t guard) {
    return noise.by_guard == kSomeGuard || noise.by_guard == guard;
}

// Guards are used to each other's steps, and to each other's muttering; an alarm is another matter.
bool is_worth_hearing(const world::Noise& noise, std::size_t guard) {
    if (is_own(noise, guard)) return false;
    return noise.by_guard == kNobody || noise.bark == world::Bark::Alarm;
}

void look(const GuardWorld& now, const sense::Body& body, std::size_t g, world::State& state) {
    const sense::Eye eye{.position = now.snapshot.guard_eyes[g],
                         .forward = now.snapshot.guard_looks[g],
                         .cos_half_fov = kCosHalfView,
                         .range = kSightRange};
    sense::Sighting direct, mirrored;
    sense::sight(*now.snapshot.scene, std::span(&eye, 1), body, std::span(&direct, 1));
    sense::mirror_sight(*now.snapshot.scene, now.snapshot.panes, std::span(&eye, 1), body, std::span(&mirrored, 1));
    world::Percept& percept = state.guards[g].percept;
    percept.is_fresh = 1;
    percept.sight = direct.seen;
    percept.mirror_sight = mirrored.seen;
    percept.sight_metres = direct.distance;
    percept.mirror_metres = mirrored.distance;
    if (percept.sight > 0.0f || percept.mirror_sight > 0.0f) percept.seen_at = state.player.position;
}

// The level of one noise at a guard's ear: through walls, around corners, or along the corridors.
float heard_db(const GuardWorld& now, const world::Noise& noise, const glm::vec3& ear, const glm::vec3& feet) {
    constexpr float kOffFloor = 0.05f;  // metres: steps sound from just above what they fall on
    const glm::vec3 source = noise.position + glm::vec3(0.0f, kOffFloor, 0.0f);
    const float distance = length_of(source - ear);
    const float at_best = noise.loudness_db - 20.0f * det::log10(std::max(distance, 0.3f));
    if (at_best <= kFaintestDb) return sense::kSilenceDb;
    const sense::Transmission transmission =
        carry_sound(now.level, *now.snapshot.scene, now.navigation, source, ear, feet);
    return sense::level_db(noise.loudness_db, transmission);
}

void hear_noise(const GuardWorld& now, const world::Noise& noise, std::size_t g, world::State& state) {
    if (!is_worth_hearing(noise, g)) return;
    world::Percept& percept = state.guards[g].percept;
    const float level = heard_db(now, noise, now.snapshot.guard_eyes[g], state.guards[g].position);
    if (level <= percept.heard_db) return;
    percept.heard_db = level;
    // Who hears an alarm goes where the alarmed guard means to go.
    const bool is_call = noise.bark == world::Bark::Alarm && noise.by_guard < now.level.guards.size();
    percept.heard_at = is_call ? state.guards[noise.by_guard].last_known : noise.position;
}

void listen(const GuardWorld& now, const world::State& last, std::size_t g, world::State& state) {
    state.guards[g].percept.heard_db = sense::kSilenceDb;
    for (std::uint32_t n = 0; n < last.noise_count; ++n) {
        if (last.noises[n].kind == world::NoiseKind::Bark) hear_noise(now, last.noises[n], g, state);
    }
    for (std::uint32_t n = 0; n < state.noise_count; ++n) hear_noise(now, state.noises[n], g, state);
}

}  // namespace

void perceive(const GuardWorld& now, const world::State& last, world::State& state) {
    const std::size_t guards = now.level.guards.size();
    bool anybody_looks = state.tick % kLookPeriod == 0;  // the HUD's gem, at least
    for (std::size_t g = 0; g < guards; ++g) anybody_looks = anybody_looks || looks_now(state, g);

    sense::Body body;
    if (anybody_looks) {
        body.point = sense::body_points(state.player);
        const sense::Exposure exposure = sense::exposure(now.level, now.snapshot, body.point);
        body.lit = exposure.lit;
        state.player.exposure = exposure.level;
    }
    for (std::size_t g = 0; g < guards; ++g) {
        state.guards[g].percept.is_fresh = 0;
        if (looks_now(state, g)) look(now, body, g, state);
        listen(now, last, g, state);
    }
}

}  // namespace gh::sim
