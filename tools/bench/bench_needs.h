// bench_needs.h - what it costs that the path tracer can do more than a scene needs: with code for it, and used.
#pragma once

#include "world/level.h"

#include <memory>

namespace bench {

// The level as it is, and with its glass, layers and textures taken away, by the kernel that each needs and by the one that
// can do everything, in turn, on one thread. Core time, and that of the general kernel over the other's.
void bench_needs(const std::shared_ptr<const gh::world::Level>& level, int rounds);

}  // namespace bench
