// hands.h - what a player made of code does with mouse and keys, whoever thinks for it: turning, pressing, reaching.
//
// Same bits functions of their arguments; det_math only.
#pragma once

#include "input/command.h"
#include "world/snapshot.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string_view>

namespace gh::tools {

// The view turned towards a direction, as quickly as a hand turns it.
[[nodiscard]] input::Command turned_towards(const world::PlayerState& player, const glm::vec3& way);

// How well the view looks along a horizontal direction: 1 exactly, 0 sideways.
[[nodiscard]] float alignment(const world::PlayerState& player, const glm::vec3& way);

[[nodiscard]] bool looks_at(const world::PlayerState& player, const glm::vec3& point);

// Moves along a horizontal unit direction, wherever the eyes are.
void walk_along(const glm::vec3& direction, float share, input::Command& command);

// The place of a thing among others, by its node's name.
template <class Things>
[[nodiscard]] std::optional<std::uint32_t> named(const Things& things, std::string_view name) {
    for (std::uint32_t i = 0; i < things.size(); ++i) {
        if (things[i].name == name) return i;
    }
    return std::nullopt;
}

// Down now, if it was up a tick ago: the simulation acts on presses.
void press(const world::PlayerState& player, input::Button button, input::Command& command);

// Whether a thing is on this side of the wall: nothing but glass lies between it and eyes above the place.
[[nodiscard]] bool is_seen_from(const world::Snapshot& now, const glm::vec3& place, const glm::vec3& thing);

}  // namespace gh::tools
