// hands.h - what a player made of code does with mouse and keys, whoever thinks for it: turning, pressing, reaching.
//
// Same bits functions of their arguments; det_math only.
#pragma once

#include "input/command.h"
#include "world/snapshot.h"

#include <glm/vec3.hpp>

namespace gh::tools {

// The view turned towards a direction, as quickly as a hand turns it.
[[nodiscard]] input::Command turned_towards(const world::PlayerState& player, const glm::vec3& way);

// How well the view looks along a horizontal direction: 1 exactly, 0 sideways.
[[nodiscard]] float alignment(const world::PlayerState& player, const glm::vec3& way);

[[nodiscard]] bool looks_at(const world::PlayerState& player, const glm::vec3& point);

// Down now, if it was up a tick ago: the simulation acts on presses.
void press(const world::PlayerState& player, input::Button button, input::Command& command);

// Whether a thing is on this side of the wall: nothing but glass lies between it and eyes above the place.
[[nodiscard]] bool is_seen_from(const world::Snapshot& now, const glm::vec3& place, const glm::vec3& thing);

}  // namespace gh::tools
