// bench_ticks.h - what a tick of the game costs, room by room.
#pragma once

#include "input/command.h"
#include "world/level.h"

#include <memory>
#include <vector>

namespace bench {

// Somebody who walks, runs, turns, opens what is in front of him and throws stones now and then.
[[nodiscard]] std::vector<gh::input::Command> restless_player(int ticks);

// Plays the commands `rounds` times from the start.
void bench_ticks(const std::shared_ptr<const gh::world::Level>& level,
                 const std::vector<gh::input::Command>& commands, int rounds);

}  // namespace bench
