// sim/stones.h - holding, aiming, throwing; and every stone on its way.
#pragma once

#include <cstddef>
#include <span>

#include <glm/vec3.hpp>

#include "input/command.h"
#include "world/level.h"
#include "world/snapshot.h"

namespace gh::sim {

inline constexpr float kMinThrowSpeed = 6.0f;   // m/s, for a tap
inline constexpr float kMaxThrowSpeed = 14.0f;  // m/s, held for a second
inline constexpr std::size_t kMaxArcPoints = 180;

// Throw held aims; let go throws; Cancel puts the stone back.
void decide_throw(const world::Level& level, const world::Snapshot& before, const input::Command& command,
                  world::State& state);

// One tick of every stone, with its sounds.
void move_stones(const world::Level& level, const world::Snapshot& before, world::State& state);

// Where a stone let go now would be, tick by tick, until it first meets something (that point included) or
// `out` is full; returns how many points. None while no stone is aimed. Flown by the very code that flies stones.
[[nodiscard]] std::size_t throw_arc(const world::Level& level, const world::Snapshot& snapshot,
                                    std::span<glm::vec3> out);

}  // namespace gh::sim
