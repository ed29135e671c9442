// load/level_check.h - what must hold for a level to be playable, asked once, at the door.
#pragma once

#include "base/result.h"
#include "world/level.h"

namespace gh::load {

// Every index in range, every number finite and within bounds, arrays of equal length where they must be.
// Everything behind the loader relies on it.
[[nodiscard]] Result<void> check_ranges(const world::Level& level);

}  // namespace gh::load
