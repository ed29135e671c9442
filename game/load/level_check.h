// load/level_check.h - what must hold for a level to be loaded, and what must hold for it to be a good one.
//
// Threads   pure. Cost: check_level walks the navmesh and every shell, tens of milliseconds.
#pragma once

#include "base/result.h"
#include "world/level.h"

#include <string>
#include <vector>

namespace gh::load {

// Every index in range, every number finite and within bounds, arrays of equal length where they must be.
// The loader asks it, and everything behind the loader relies on it.
[[nodiscard]] Result<void> check_ranges(const world::Level& level);

// Each a sentence. An error is something a player would run into: a shell with a hole, a lens or an exit that
// cannot be reached from the spawn, a guard that cannot walk its patrol. A warning is odd, and may be meant.
struct LevelReport {
    std::vector<std::string> errors;
    std::vector<std::string> warnings;
};
[[nodiscard]] LevelReport check_level(const world::Level& level);

}  // namespace gh::load
