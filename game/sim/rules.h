// sim/rules.h - winning, losing, and starting again.
#pragma once

#include "input/command.h"
#include "world/level.h"
#include "world/state.h"

namespace gh::sim {

inline constexpr std::uint32_t kCaughtTicks = 60;  // before the player may start again

// Whether the player asks for the last checkpoint: by Restart at any time, by Use once caught.
[[nodiscard]] bool wants_checkpoint(const world::State& state, const input::Command& command);

// The world as at the checkpoint; the tick and the count of arrests run on.
[[nodiscard]] world::State checkpoint(const world::Level& level, const world::State& state);

// What is left of a command: who is caught or has won can only look about.
[[nodiscard]] input::Command allowed(const world::State& state, const input::Command& command);

// A guard's hand is on the player's shoulder.
void catch_player(world::State& state);

// Winning; and somebody who fell out of the world is put back to the spawn.
void judge_rules(const world::Level& level, world::State& state);

}  // namespace gh::sim
