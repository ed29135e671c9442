#include "sim/noises.h"

#include <algorithm>
#include <array>

#include "base/det_math.h"

namespace gh::sim {

namespace {

using world::kSurfaceCount;
using world::Surface;

constexpr float kNeedleFallDb = 0.75f;  // a tick: from a step to silence in about a second
constexpr float kRunDb = 11.0f;         // louder than walking
constexpr float kCrouchDb = -17.0f;
constexpr float kQuietStoneSpeed = 0.25f;  // m/s: slower touches make no sound

// In the order of world::Surface: marble concrete parquet plaster stud glass pane oak metal curtain ceiling carpet.
constexpr std::array<float, kSurfaceCount> kStepDb = {45, 42, 44, 40, 41, 49, 49, 45, 52, 25, 39, 29};
constexpr std::array<float, kSurfaceCount> kStoneDb = {62, 58, 57, 50, 52, 66, 66, 58, 68, 25, 45, 32};  // at 1 m/s

// 20 dB for every tenfold speed.
float db_of_ratio(float ratio) { return 20.0f * det::log10(std::max(ratio, 1e-6f)); }

}  // namespace

Surface surface_at(const world::Level& level, std::uint32_t instance, std::uint32_t primitive) {
    if (instance >= level.parts.size()) return Surface::Marble;
    const world::Mesh& mesh = level.meshes[level.parts[instance].mesh];
    if (primitive >= mesh.materials.size()) return Surface::Marble;
    const std::uint32_t material = mesh.materials[primitive];
    return material < level.materials.size() ? level.materials[material].surface : Surface::Marble;
}

float footstep_db(Surface surface, Gait gait) {
    const float by_gait = gait == Gait::Run ? kRunDb : gait == Gait::Crouch ? kCrouchDb : 0.0f;
    return kStepDb[index_of(surface)] + by_gait;
}

float landing_db(Surface surface, float speed) {
    return kStepDb[index_of(surface)] + std::max(db_of_ratio(speed), 0.0f);
}

float stone_hit_db(Surface surface, float speed) {
    if (speed < kQuietStoneSpeed) return -120.0f;
    return kStoneDb[index_of(surface)] + db_of_ratio(speed);
}

void emit(world::State& state, const world::Noise& noise) {
    if (state.noise_count < world::kMaxNoises) {
        state.noises[state.noise_count++] = noise;
        return;
    }
    const auto quietest = std::min_element(
        state.noises.begin(), state.noises.end(),
        [](const world::Noise& a, const world::Noise& b) { return a.loudness_db < b.loudness_db; });
    if (quietest->loudness_db < noise.loudness_db) *quietest = noise;
}

void emit_by_player(world::State& state, const world::Noise& noise) {
    emit(state, noise);
    state.player.noise_db = std::max(state.player.noise_db, noise.loudness_db);
}

void fade_noise_needle(world::PlayerState& player) {
    player.noise_db = std::max(player.noise_db - kNeedleFallDb, 0.0f);
}

}  // namespace gh::sim
