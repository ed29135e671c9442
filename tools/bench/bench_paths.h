// bench_paths.h - what a path-traced picture costs at the level's own cameras, as the window makes it.
#pragma once

#include "world/level.h"

#include <memory>

namespace bench {

// Four of the level's viewpoints: 640x360 with every pixel lit, and 1280x720 with one in nine; core milliseconds by stage.
void bench_paths(const std::shared_ptr<const gh::world::Level>& level, int threads, int rounds);

}  // namespace bench
