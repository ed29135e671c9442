// world/eye.h - where the player's eyes and ears are, and where they look: one answer for camera, sound, prompts
// and thrown stones.
//
// Units     metres, world frame, +y up. Same bits: det_math only.
#pragma once

#include <glm/vec3.hpp>

#include "world/state.h"

namespace gh::world {

inline constexpr float kEyeBelowTop = 0.12f;  // metres from the crown of the head down to the eyes
inline constexpr float kLeanReach = 0.45f;    // how far a full lean carries the eyes sideways
inline constexpr float kLeanDrop = 0.06f;     // and how far it lowers them

// Radians from a Command's or PlayerState's sixteen bits: a whole turn is 65536 units.
[[nodiscard]] float radians_from_turn(std::int16_t turn);

// Unit, horizontal: where a body with this yaw faces (0 is -z, positive turns left), and what is to its right.
[[nodiscard]] glm::vec3 forward_of_yaw(float yaw);
[[nodiscard]] glm::vec3 right_of_yaw(float yaw);

// The yaw a body needs to face along `direction`; its height is ignored, and a vertical one gives 0.
[[nodiscard]] float yaw_towards(const glm::vec3& direction);

[[nodiscard]] glm::vec3 eye_of(const PlayerState& player);
[[nodiscard]] glm::vec3 look_of(const PlayerState& player);  // unit

}  // namespace gh::world
