#include "sense/body.h"

#include "world/eye.h"

#include <algorithm>

namespace gh::sense {
namespace {

// One point of the body, with its height as a share of the capsule's: a crouching body has them all, lower.
struct Place {
    float height;
    float right;    // metres
    float forward;  // metres
};

constexpr std::array<Place, kBodyPoints> kPlaces = {{
    {.height = 0.92f, .right = 0.0f, .forward = 0.03f},    // head
    {.height = 0.72f, .right = 0.0f, .forward = 0.10f},    // chest
    {.height = 0.53f, .right = 0.0f, .forward = 0.08f},    // hips
    {.height = 0.81f, .right = -0.19f, .forward = 0.0f},   // left shoulder
    {.height = 0.81f, .right = 0.19f, .forward = 0.0f},    // right shoulder
    {.height = 0.45f, .right = -0.23f, .forward = 0.08f},  // left hand
    {.height = 0.45f, .right = 0.23f, .forward = 0.08f},   // right hand
    {.height = 0.28f, .right = 0.0f, .forward = 0.06f},    // knees
    {.height = 0.05f, .right = -0.11f, .forward = 0.04f},  // left foot
    {.height = 0.05f, .right = 0.11f, .forward = 0.04f},   // right foot
}};

constexpr float kLeansFrom = 0.5f;  // share of the height below which a leaning body stays where it stands

}  // namespace

BodyPoints body_points(const world::PlayerState& player) {
    const float yaw = world::radians_from_turn(player.yaw);
    const glm::vec3 right = world::right_of_yaw(yaw);
    const glm::vec3 forward = world::forward_of_yaw(yaw);
    const float reach = player.lean * world::kLeanReach;
    BodyPoints points;
    for (std::size_t i = 0; i < kBodyPoints; ++i) {
        const Place& place = kPlaces[i];
        const float bent = std::max(0.0f, (place.height - kLeansFrom) / (1.0f - kLeansFrom));
        points[i] = player.position + glm::vec3(0.0f, place.height * player.height, 0.0f) +
                    right * (place.right + reach * bent) + forward * place.forward;
    }
    return points;
}

}  // namespace gh::sense
