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
#include "filter/movement.h"
#include "filter/plane.h"
#include "filter/rows.h"

#include <glm/vec2.hpp>

#include <functional>

namespace gh::filter {

class PictureMean {
  public:
    void forget() { has_past_ = false; }

    // Writes row `y` of a picture to three rows of whole vectors.
    using PictureRows = std::function<void(int y, float* const to[3])>;
    // As works after those that `picture` needs; `out` is made to fit. finish() once they have run. `surfaces` may be filled
    // by the passes, but for its lens and sizes.
    struct Change {
        const Plane& share;                  // of each pixel's light that is known to be new; empty: 0
        const Movement* movement = nullptr;  // since the last picture, if somebody found it already
    };
    void add_rows(const GBuffer& surfaces, const PictureRows& picture, const Change& change,
                  RowPasses& passes, Plane3& out);
    void finish(const GBuffer& surfaces);

  private:
    void smooth_row(int y, const Movement& movement, const Plane& change, Plane3& out);

    bool has_past_ = false;
    Pinhole before_;                     // the lens of the last picture
    glm::ivec2 size_{0}, size_then_{0};  // of this picture and of the last
    Movement movement_;                  // if nobody else found it
    Plane3 now_, mean_, next_;           // bordered
};

}  // namespace gh::filter
