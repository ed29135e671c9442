// bench_window.h - what the window's pictures cost at the level's own cameras.
#pragma once

#include "world/level.h"

#include <memory>

namespace bench {

// Four of the level's viewpoints, seen in every pixel and lit in one of nine or sixteen; core milliseconds by stage.
void bench_window(const std::shared_ptr<const gh::world::Level>& level, int threads, int rounds);

}  // namespace bench
