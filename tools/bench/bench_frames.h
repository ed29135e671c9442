// bench_frames.h - what a Whitted picture costs at the level's own cameras.
#pragma once

#include "world/level.h"

#include <memory>

namespace bench {

// Four of the level's viewpoints, 640x360 and 1280x720, on `threads` threads.
void bench_frames(const std::shared_ptr<const gh::world::Level>& level, int threads, int rounds);

}  // namespace bench
