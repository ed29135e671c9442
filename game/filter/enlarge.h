// filter/enlarge.h - a rendered picture to the window's size, plane by plane; upscale.h does it for whole images of any
// proportion, also smaller ones.
//
// enlarge        Mitchell and Netravali's cubic (1988, B = C = 1/3), clamped to the values it blends: no halo.
// joint_enlarge  where the large picture's surfaces are known (rays to the first surface alone are cheap), light is taken
//                from the four nearest small pixels on the same surface, bilinearly (Kopf et al. 2007): edges come out as
//                sharp as the surfaces. Where none of the four is on it, the nearest in kind counts most.
//
// Cost      7 cycles a pixel of `out` for the cubic, 8 for the joint one, with AVX-512.
// Same bits for any number of threads and any instruction set.
// Energy    a constant stays that constant to 1e-6.
// Bad input enlarge(): what is not finite counts as black, so it does not spread; joint_enlarge(): light must be finite,
//           as remodulate() leaves it, guides are always fine.
#pragma once

#include "base/jobs.h"
#include "filter/guides.h"
#include "filter/plane.h"

namespace gh::filter {

// `out` has its size already, neither side less than that of `in`, which is at least 1x1.
void enlarge(const Plane3& in, const Jobs& jobs, Plane3& out);

// `guides` are those of `in`, `large` those `out` is to have; `out` is made to fit.
void joint_enlarge(const Plane3& in, const Guides& guides, const Guides& large, const Jobs& jobs,
                   Plane3& out);

}  // namespace gh::filter
