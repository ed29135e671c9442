// filter/picture_mean.h - pictures in a row, taken through other places of their pixels, added up: smooth edges, and less
// left of what boils.
//
// Each pixel is found in the mean of the pictures before, by where its surface was then (GBuffer::previous), and brought
// into the range of what the picture shows around it now: what has changed or was hidden is let go of at once (Karis 2014;
// Yang, Liu and Salvi 2020, sections 3 and 5). The sky is found by its direction. temporal_upscale.h does this too for
// pictures lit in few pixels; here every pixel is lit and brings its own surface along.
//
// Cost      7 ns a pixel with AVX-512.
// Threads   rows over all threads; one caller at a time.
// Same bits the mean depends on the pictures added since forget() alone, not on threads or instruction set.
// Bad input light must be finite, as remodulate() leaves it; a NaN position has no past.
#pragma once

#include "filter/gbuffer.h"
#include "filter/plane.h"
#include "filter/rows.h"

#include <glm/vec2.hpp>

namespace gh::filter {

class PictureMean {
  public:
    void forget() { has_past_ = false; }

    // As works after those that make `picture`, which must live until they have run; `out` is made to fit and is another.
    // finish() once they have. `surfaces` may be filled by the passes, but for its lens and sizes. `change` is the share of
    // each pixel's light that is known to be new; empty: 0.
    void add_rows(const GBuffer& surfaces, const Plane3& picture, const Plane& change, RowPasses& passes,
                  Plane3& out);
    void finish(const GBuffer& surfaces);

  private:
    void place_row(const GBuffer& surfaces, const Plane3& picture, int y);
    void smooth_row(int y, const Plane& change, Plane3& out);

    bool has_past_ = false;
    Pinhole before_;                     // the lens of the last picture
    glm::ivec2 size_{0}, size_then_{0};  // of this picture and of the last
    Plane motion_x_, motion_y_;          // in pixels, to where each was
    Plane3 now_, mean_, next_;           // bordered
};

}  // namespace gh::filter
