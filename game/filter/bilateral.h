// filter/bilateral.h - blur that stops at edges: of the light itself (Tomasi and Manduchi 1998), or of what is known
// without noise, nearness, normal and albedo (cross or joint bilateral: Eisemann and Durand 2004, Petschnigg et al. 2004).
//
// The weight of a neighbour falls as e^-x with the sum of all that tells it apart, see falloff() in simd-inl.h.
//
// Cost      (2 reach + 1)^2 neighbours a pixel, reach = ceil(2 sigma): 25 cycles each vector. Allocates three planes.
// Same bits for any number of threads and any instruction set.
// Energy    a weighted mean: a constant stays that constant to 1e-6.
// Bad input light that is not finite is mended first, see mend.h; guides are always fine.
#pragma once

#include "base/jobs.h"
#include "filter/guides.h"
#include "filter/plane.h"

namespace gh::filter {

struct BilateralSettings {
    float sigma_px = 2.0f;   // in (0, 16]
    float luminance = 0.1f;  // difference at which a weight has fallen to 1/e; 0: does not matter
    float albedo = 0.1f;     // the same, of the sum of the three channels' differences
};

// By the light's own luminance. `out` is made to fit.
void bilateral(const Plane3& in, const BilateralSettings& settings, const Jobs& jobs, Plane3& out);

// By what is known of the surfaces: `guides`, and `albedo` unless it is empty; and by luminance if that is asked for.
void cross_bilateral(const Plane3& in, const Guides& guides, const Plane3& albedo,
                     const BilateralSettings& settings, const Jobs& jobs, Plane3& out);

}  // namespace gh::filter
