// filter/gaussian.h - plain blur, for glows and as the filter every other one is measured against.
//
// A normalised convolution: weights are those of the pixels there are, so borders neither darken nor brighten.
//
// Cost      separable: 2 * (2 ceil(3 sigma) + 1) multiply-adds a number. Allocates four planes.
// Same bits for any number of threads and any instruction set.
// Energy    a constant stays that constant to 1e-6.
// Bad input a pixel that is not finite counts for nobody and is filled in from its neighbours; 0 where there are none.
#pragma once

#include "base/jobs.h"
#include "filter/plane.h"

namespace gh::filter {

// `sigma` in pixels, in (0, 20]. `out` is made to fit and may be `in`.
void gaussian(const Plane3& in, float sigma, const Jobs& jobs, Plane3& out);

}  // namespace gh::filter
