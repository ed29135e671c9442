#include "sim/hand_mirror.h"

#include "sim/geometry.h"
#include "spatial/hand_mirror.h"
#include "world/eye.h"
#include "world/layers.h"

#include "raycore/query.h"

namespace gh::sim {

namespace {

using input::Button;

constexpr float kRaiseRate = 1.0f / 12.0f;  // of the way up, a tick
constexpr float kAsideRate = 1.0f / 14.0f;  // of the way to a side, a tick
constexpr float kMirrorRadius = 0.12f;      // metres it keeps from walls
constexpr float kLeastReach = 0.35f;        // share of the arm: with less room it is not held up at all

}  // namespace

bool steers_mirror(const input::Command& command, const world::PlayerState& player) {
    return player.has_mirror != 0 && command.is_held(Button::HandMirror);
}

void move_hand_mirror(const world::Snapshot& before, const input::Command& command,
                      world::PlayerState& player) {
    const bool is_up = steers_mirror(command, player);
    float aside = 0.0f;
    if (is_up && command.is_held(Button::LeanLeft)) aside -= 1.0f;
    if (is_up && command.is_held(Button::LeanRight)) aside += 1.0f;
    player.mirror_side = towards(player.mirror_side, aside, kAsideRate);
    player.mirror_raise = towards(player.mirror_raise, is_up ? 1.0f : 0.0f, kRaiseRate);
    player.mirror_reach = 1.0f;
    if (!spatial::is_mirror_held(player)) return;
    const auto wall = rc::sphere_cast(*before.scene, world::eye_of(player), kMirrorRadius,
                                      spatial::arm_of(player), world::Solid);
    if (!wall) return;
    player.mirror_reach = wall->t;
    if (wall->t < kLeastReach) player.mirror_raise = 0.0f;
}

}  // namespace gh::sim
