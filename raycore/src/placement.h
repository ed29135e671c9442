// placement.h - an instance seen from the world, with every rounding on the way accounted for.
#pragma once

#include "raycore/scene.h"

#include <optional>

namespace rc {

struct Placement {
    double local_from_world[12];  // rows of three and a translation
    float condition;              // norm(world_from_local) * norm(local_from_world), largest row sums
    Box world_box;                // holds whatever the instance's frame may decide to be hit
};

// Nothing when the instance can not be met: no Blas, an empty one, a transform that is not finite, singular, or
// stretched so unevenly (condition above 1e7) that single precision can not tell its points apart.
[[nodiscard]] std::optional<Placement> place(const Instance& instance);

}  // namespace rc
