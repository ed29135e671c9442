#include "sim/stones.h"

#include <algorithm>
#include <array>

#include "raycore/query.h"

#include "sim/geometry.h"
#include "sim/guards.h"
#include "sim/noises.h"
#include "sim/stone_flight.h"
#include "world/eye.h"
#include "world/layers.h"

namespace gh::sim {

namespace {

constexpr std::uint16_t kFullAimTicks = 60;
constexpr float kThrowDb = 26.0f;   // the sleeve
constexpr float kHandReach = 0.3f;  // metres from the eye to where a stone leaves the hand
constexpr float kTracedBack = 5.0f;  // metres along its flight that who is hit takes a stone to come from

float throw_speed(std::uint16_t aim_ticks) {
    const float share = static_cast<float>(std::min(aim_ticks, kFullAimTicks)) / static_cast<float>(kFullAimTicks);
    return kMinThrowSpeed + (kMaxThrowSpeed - kMinThrowSpeed) * share;
}

// The stone as it leaves the hand, never beyond a wall the player leans against.
world::StoneState stone_in_hand(const world::Level& level, const world::Snapshot& snapshot,
                                const world::PlayerState& player) {
    const glm::vec3 eye = world::eye_of(player);
    const glm::vec3 look = world::look_of(player);
    const glm::vec3 way = look * kHandReach;
    const auto hit = rc::sphere_cast(*snapshot.scene, eye, level.stone_radius, way, world::Solid);
    const float share = hit ? std::max(hit->t - kStoneSkin / kHandReach, 0.0f) : 1.0f;
    world::StoneState stone;
    stone.position = eye + way * share;
    stone.velocity = look * throw_speed(player.aim_ticks) + player.velocity;
    stone.is_present = 1;
    return stone;
}

void throw_stone(const world::Level& level, const world::Snapshot& before, world::State& state) {
    const auto slot = std::find_if(state.stones.begin(), state.stones.end(),
                                   [](const world::StoneState& stone) { return stone.is_present == 0; });
    if (slot == state.stones.end()) return;
    *slot = stone_in_hand(level, before, state.player);
    slot->thrown_tick = state.tick;
    state.player.stones_left -= 1;
    emit_by_player(state, {.position = slot->position, .loudness_db = kThrowDb, .kind = world::NoiseKind::Throw});
}

// The guards as stones meet them.
class GuardBodies {
  public:
    GuardBodies(const world::Level& level, const world::State& state) : count_(level.guards.size()) {
        for (std::size_t g = 0; g < count_; ++g) bodies_[g] = body_of(state.guards[g]);
    }
    [[nodiscard]] std::span<const Body> all() const { return std::span(bodies_).first(count_); }

  private:
    std::array<Body, world::kMaxGuards> bodies_;
    std::size_t count_;
};

void strike(world::GuardState& guard, const glm::vec3& flight) {
    guard.percept.is_struck = 1;
    guard.percept.struck_from = guard.position - unit_or_zero(flat(flight)) * kTracedBack;
}

}  // namespace

void decide_throw(const world::Level& level, const world::Snapshot& before, const input::Command& command,
                  world::State& state) {
    world::PlayerState& player = state.player;
    if (command.is_held(input::Button::Cancel)) {
        player.aim_ticks = 0;
        return;
    }
    if (command.is_held(input::Button::Throw)) {
        const bool may_aim = player.aim_ticks > 0 || (player.buttons_before & input::Button::Throw) == 0;
        if (may_aim && player.stones_left > 0 && player.aim_ticks < kFullAimTicks) ++player.aim_ticks;
        return;
    }
    if (player.aim_ticks == 0) return;
    throw_stone(level, before, state);
    player.aim_ticks = 0;
}

void move_stones(const world::Level& level, const world::Snapshot& before, world::State& state) {
    for (world::GuardState& guard : state.guards) guard.percept.is_struck = 0;
    const GuardBodies guards(level, state);
    for (world::StoneState& stone : state.stones) {
        if (stone.is_present == 0) continue;
        const glm::vec3 flight = stone.velocity;
        const Impact impact = fly(level, *before.scene, stone, guards.all());
        if (impact.guard != world::kNoIndex) strike(state.guards[impact.guard], flight);
        const float loudness = stone_hit_db(impact.surface, impact.speed);
        if (!impact.is_there || loudness <= 0.0f) continue;
        emit(state, {.position = impact.position,
                     .loudness_db = loudness,
                     .kind = world::NoiseKind::StoneHit,
                     .surface = static_cast<std::uint8_t>(impact.surface)});
    }
}

std::size_t throw_arc(const world::Level& level, const world::Snapshot& snapshot, std::span<glm::vec3> out) {
    const world::PlayerState& player = snapshot.state.player;
    if (player.aim_ticks == 0 || out.empty()) return 0;
    world::StoneState stone = stone_in_hand(level, snapshot, player);
    const GuardBodies guards(level, snapshot.state);
    std::size_t count = 0;
    out[count++] = stone.position;
    while (count < out.size()) {
        const Impact impact = fly(level, *snapshot.scene, stone, guards.all());
        out[count++] = impact.is_there ? impact.position : stone.position;
        if (impact.is_there) break;
    }
    return count;
}

}  // namespace gh::sim
