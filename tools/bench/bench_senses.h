// bench_senses.h - what posing the world and asking it costs, call by call.
#pragma once

#include "world/level.h"

#include <memory>

namespace bench {

// Commits with guards walking and standing, exposure, sight, mirrors and hearing at the level's own places.
void bench_stage_and_senses(const std::shared_ptr<const gh::world::Level>& level, int rounds);

}  // namespace bench
