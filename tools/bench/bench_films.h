// bench_films.h - what the filters take of path-traced films, as the window has them.
#pragma once

#include "world/level.h"

#include <memory>

namespace bench {

// Of a walk from the level's first camera at 640x360: denoised and added up, from the film to its picture, at full size and
// with soft light at half the sides; and that picture enlarged to 1280x720. Processor time of all threads.
void bench_films(const std::shared_ptr<const gh::world::Level>& level, int threads, int rounds);

}  // namespace bench
