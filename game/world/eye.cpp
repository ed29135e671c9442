#include "world/eye.h"

#include "base/det_math.h"

namespace gh::world {

float radians_from_turn(std::int16_t turn) { return static_cast<float>(turn) * (kTwoPi / 65536.0f); }

glm::vec3 forward_of_yaw(float yaw) {
    const auto [sine, cosine] = det::sin_cos(yaw);
    return {-sine, 0.0f, -cosine};
}

glm::vec3 right_of_yaw(float yaw) {
    const auto [sine, cosine] = det::sin_cos(yaw);
    return {cosine, 0.0f, -sine};
}

float yaw_towards(const glm::vec3& direction) {
    if (direction.x == 0.0f && direction.z == 0.0f) return 0.0f;
    return det::atan2(-direction.x, -direction.z);
}

glm::vec3 eye_of(const PlayerState& player) {
    const glm::vec3 right = right_of_yaw(radians_from_turn(player.yaw));
    const float up = player.height - kEyeBelowTop - kLeanDrop * player.lean * player.lean;
    return player.position + glm::vec3(0.0f, up, 0.0f) + right * (player.lean * kLeanReach);
}

glm::vec3 look_of(const PlayerState& player) {
    const auto [sine, cosine] = det::sin_cos(radians_from_turn(player.pitch));
    return forward_of_yaw(radians_from_turn(player.yaw)) * cosine + glm::vec3(0.0f, sine, 0.0f);
}

}  // namespace gh::world
