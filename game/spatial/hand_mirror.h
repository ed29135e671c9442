// spatial/hand_mirror.h - where the hand mirror is while it is held out: an arm's length from the eye, turned so that
// what is seen in its middle lies behind, or round the corner to the left or right.
//
// The looked-along direction d, reflected in the pane's middle, is level and turned from "behind" to "sideways" by
// PlayerState::mirror_side; so the pane faces the bisector, normalize(out - d). Raising or lowering the eyes moves the
// hand, not what it shows.
//
// Units     metres, world frame, +y up. Threads: pure. Same bits: det_math and sqrt only.
#pragma once

#include "world/level.h"
#include "world/state.h"

#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>

namespace gh::spatial {

// Whether the hand mirror hangs on the arm now: taken, and not put away.
[[nodiscard]] bool is_mirror_held(const world::PlayerState& player);

// From the eye to the middle of the pane, with all the room there is: mirror_reach is for walls.
[[nodiscard]] glm::vec3 arm_of(const world::PlayerState& player);

// The unit direction that a look at the middle of the pane goes on in.
[[nodiscard]] glm::vec3 shown_direction(const world::PlayerState& player);

// Of the hand mirror's own frame. Precondition: it is held, and the level has one.
[[nodiscard]] glm::mat4x3 world_from_held_mirror(const world::Level& level, const world::PlayerState& player);

}  // namespace gh::spatial
