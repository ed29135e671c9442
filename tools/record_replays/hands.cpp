#include "hands.h"

#include "base/det_math.h"
#include "sim/geometry.h"
#include "world/eye.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <algorithm>

namespace gh::tools {

namespace {

using input::Button;
using input::Command;

constexpr float kTurnShare = 0.16f;     // of what is left to turn, a tick: a hand on a mouse
constexpr float kMostHandTurn = 0.09f;  // radians a tick

}  // namespace

Command turned_towards(const world::PlayerState& player, const glm::vec3& way) {
    const float yaw = world::radians_from_turn(player.yaw);
    const float pitch = world::radians_from_turn(player.pitch);
    const float left = wrap_angle(world::yaw_towards(way) - yaw);
    const float up = det::atan2(way.y, sim::flat_length(way)) - pitch;
    return {
        .yaw = input::quantise_yaw(yaw + std::clamp(left * kTurnShare, -kMostHandTurn, kMostHandTurn)),
        .pitch = input::quantise_pitch(pitch + std::clamp(up * kTurnShare, -kMostHandTurn, kMostHandTurn))};
}

float alignment(const world::PlayerState& player, const glm::vec3& way) {
    const float length = sim::flat_length(way);
    if (!(length > 0.0f)) return 1.0f;
    const glm::vec3 forward = world::forward_of_yaw(world::radians_from_turn(player.yaw));
    return glm::dot(forward, sim::flat(way)) / length;
}

bool looks_at(const world::PlayerState& player, const glm::vec3& point) {
    const glm::vec3 way = point - world::eye_of(player);
    return glm::dot(world::look_of(player), way) > 0.9995f * sim::length_of(way);
}

void walk_along(const glm::vec3& direction, float share, Command& command) {
    const float yaw = world::radians_from_turn(command.yaw);
    command.move_forward = input::quantise_move(share * glm::dot(world::forward_of_yaw(yaw), direction));
    command.move_right = input::quantise_move(share * glm::dot(world::right_of_yaw(yaw), direction));
}

void press(const world::PlayerState& player, Button button, Command& command) {
    if ((player.buttons_before & button) == 0) command.buttons |= button;
}

bool is_seen_from(const world::Snapshot& now, const glm::vec3& place, const glm::vec3& thing) {
    constexpr float kSetIn = 0.15f;  // metres: frames, plates
    const glm::vec3 eye = place + glm::vec3(0.0f, 1.5f, 0.0f);
    const rc::Ray ray{.origin = eye, .direction = thing - eye, .t_max = 1.0f};
    const auto hit = rc::closest_hit(*now.scene, ray, world::Sight);
    return !hit || (1.0f - hit->t) * sim::length_of(ray.direction) < kSetIn;
}

}  // namespace gh::tools
