// sim/guards_animate.h - which clip shows what a guard does, and how far into it he is.
#pragma once

#include <cstddef>

#include "world/level.h"
#include "world/state.h"

namespace gh::sim {

// One tick. Walking and running play as fast as the feet go, so that they do not slide.
void animate_guard(const world::Level& level, std::size_t guard, world::State& state);

}  // namespace gh::sim
