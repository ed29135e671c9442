// sim/use.h - the verb `use`: doors, mirrors, switches, lenses, stones.
#pragma once

#include "sim/use_target.h"
#include "world/state.h"

namespace gh::sim {

void use(const world::Level& level, const UseTarget& target, world::State& state);

}  // namespace gh::sim
