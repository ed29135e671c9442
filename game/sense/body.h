// sense/body.h - the points of the player's body that lamps light and guards look for.
//
// All lie within the player's own capsule, 0.25 m from its axis (leaning aside), so that none is inside a wall.
// Frames    world, metres, +y up.
// Same bits det_math only.
#pragma once

#include "world/state.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>

namespace gh::sense {

inline constexpr std::size_t kBodyPoints = 10;

enum class BodyPart : std::size_t {
    Head,
    Chest,
    Hips,
    LeftShoulder,
    RightShoulder,
    LeftHand,
    RightHand,
    Knees,
    LeftFoot,
    RightFoot,
};

using BodyPoints = std::array<glm::vec3, kBodyPoints>;  // indexed by BodyPart

// Where the points of a body are whose feet stand at `player.position`, as high as its capsule is now,
// leaning.
[[nodiscard]] BodyPoints body_points(const world::PlayerState& player);

}  // namespace gh::sense
