#include "spatial/hand_mirror.h"

#include "base/contracts.h"
#include "base/det_math.h"
#include "base/vectors.h"
#include "spatial/transforms.h"
#include "world/eye.h"

#include <cmath>

namespace gh::spatial {
namespace {

constexpr float kAhead = 0.50f;       // metres along the look
constexpr float kAheadAside = 0.12f;  // more of it, held out to a side
constexpr float kRight = 0.13f;       // metres: it is the right hand
constexpr float kAside = 0.17f;       // metres, held out to a side
constexpr float kBelow = 0.05f;
constexpr float kPutAway = 0.50f;      // metres below that, put away
constexpr float kOverShoulder = 0.3f;  // radians from straight behind, over the right shoulder

glm::vec3 unit_of(const glm::vec3& v) {
    return v / length_of(v);
}

// Right, up and facing, as columns: facing is kept, up as far up as that allows. Not for a mirror flat on its back.
glm::mat4x3 facing_frame(const glm::vec3& facing, const glm::vec3& up) {
    const glm::vec3 right = unit_of(cross_of(up, facing));
    return {right, cross_of(facing, right), facing, glm::vec3(0.0f)};
}

}  // namespace

bool is_mirror_held(const world::PlayerState& player) {
    return player.has_mirror != 0 && player.mirror_raise > 0.0f;
}

glm::vec3 arm_of(const world::PlayerState& player) {
    const glm::vec3 look = world::look_of(player);
    const glm::vec3 right = world::right_of_yaw(world::radians_from_turn(player.yaw));
    const float aside = player.mirror_side;
    const float below = kBelow + kPutAway * (1.0f - player.mirror_raise);
    return (look * (kAhead + kAheadAside * std::abs(aside)) +
            right * (kRight * (1.0f - std::abs(aside)) + kAside * aside)) -
           glm::vec3(0.0f, below, 0.0f);
}

glm::vec3 shown_direction(const world::PlayerState& player) {
    const float yaw = world::radians_from_turn(player.yaw);
    const float aside = player.mirror_side;
    const float turn = (kPi * 0.5f) * aside + kOverShoulder * (1.0f - std::abs(aside));
    const auto [sine, cosine] = det::sin_cos(turn);
    return world::right_of_yaw(yaw) * sine - world::forward_of_yaw(yaw) * cosine;
}

glm::mat4x3 world_from_held_mirror(const world::Level& level, const world::PlayerState& player) {
    EXPECTS(level.hand_mirror < level.mirrors.size() && is_mirror_held(player));
    const world::Mirror& mirror = level.mirrors[level.hand_mirror];
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    const glm::vec3 arm = arm_of(player);
    const glm::mat4x3 world_from_pane = facing_frame(unit_of(shown_direction(player) - unit_of(arm)), up);
    const glm::vec3 facing = unit_of(cross_of(mirror.pane_half_u, mirror.pane_half_v));
    // A pane that faces its own +y has no up of its own; -z then is the top, as of a thing lying on its back.
    const glm::vec3 top = std::abs(facing.y) < 0.99f ? up : glm::vec3(0.0f, 0.0f, -1.0f);
    const glm::mat4x3 mirror_from_pane = facing_frame(facing, top);
    const glm::mat4x3 turned = chain(world_from_pane, inverse_of(mirror_from_pane));
    const glm::vec3 middle = world::eye_of(player) + arm * player.mirror_reach;
    return {turned[0], turned[1], turned[2], middle - vector_through(turned, mirror.pane_centre)};
}

}  // namespace gh::spatial
