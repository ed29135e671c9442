// filter/guides.h - which neighbours lie on the same surface, prepared once a frame for all filters over the picture.
//
// Along a plane the reciprocal of the depth is linear in the picture. So a pixel's triangle foretells the nearness of
// each of its neighbours, exactly at any slant, and what is off the foretold value is off the plane. (Depth gradients
// by differences, as in Schied et al. 2017, equation 3, break at every edge; these do not.)
//
// Cost      about 5 cycles a pixel; 6 planes.
// Same bits for any number of threads and any instruction set.
// Bad input a pixel whose depth is not above 0 or whose normal is not about unit, NaN among them, counts as sky: it has no
//           neighbours. All planes come out finite; nobody behind this door checks again.
#pragma once

#include "base/jobs.h"
#include "filter/gbuffer.h"
#include "filter/plane.h"
#include "filter/rows.h"

namespace gh::filter {

struct Guides {
    Plane nearness;          // 1 / depth along the axis of the camera, at the pixel's centre; 0: sky
    Plane slope_x, slope_y;  // its change a pixel to the right and a pixel down
    Plane3 normal;           // GBuffer's

    [[nodiscard]] int width() const { return nearness.width(); }
    [[nodiscard]] int height() const { return nearness.height(); }
};

// `guides` is made to fit.
void make_guides(const GBuffer& surfaces, const Jobs& jobs, Guides& guides);
[[nodiscard]] RowWork guide_rows(const GBuffer& surfaces, Guides& guides);

// One row of them, for kernels; null pointers never.
struct GuideRows {
    const float* nearness;
    const float* slope_x;
    const float* slope_y;
    const float* normal[3];
};
[[nodiscard]] GuideRows rows_of(const Guides& guides, int y);

}  // namespace gh::filter
