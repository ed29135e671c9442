// filter/reproject.h - where each pixel's surface was a frame ago, by the camera's motion and by its own.
//
// The point a pixel shaded is carried to where it was (GBuffer::previous) and looked up in the last frame's picture.
// Each of the four pixels around that place is asked whether it showed the same surface: same part, normal within
// 25 degrees, on the same plane within a share of the distance; those that did share the weight, bilinearly. With none
// the pixel was not seen before: it is disoccluded. (Schied et al. 2017, section 4.1; Yang, Liu, Salvi 2020, section 4.)
// Motion is measured from the point itself, not from the pixel's centre: with nothing moving it is exactly zero and the
// weights are exactly 1, 0, 0, 0, however the renderer jitters.
//
// The picture may change its size between frames; history is found all the same.
//
// Cost      about 20 cycles a pixel with AVX-512; a row is done 64 pixels at a time on the stack.
// Threads   reads its arguments only.
// Same bits for any number of threads and any instruction set.
// Bad input NaN positions or normals are disoccluded.
#pragma once

#include "base/jobs.h"
#include "filter/gbuffer.h"

#include <cstdint>
#include <vector>

namespace gh::filter {

// Four numbers of a pixel side by side, so that a history look-up touches one line of memory per pixel.
struct alignas(16) Texel {
    float value[4];
};

// A picture of texels with slack around it, such that the four neighbours of any place between (-1, -1) and
// (width, height) may be read.
class Texels {
  public:
    void resize(int width, int height);
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    // From one row to the next; whole vectors of 16 texels.
    [[nodiscard]] int stride() const { return stride_; }
    // The texel of pixel (0, y).
    [[nodiscard]] Texel* row(int y) { return texels_.data() + offset(y); }
    [[nodiscard]] const Texel* row(int y) const { return texels_.data() + offset(y); }

  private:
    static constexpr std::size_t kSlack = 16;
    [[nodiscard]] std::size_t offset(int y) const {
        EXPECTS(-1 <= y && y <= height_);
        return static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(stride_) + kSlack;
    }
    int width_ = 0, height_ = 0, stride_ = 0;
    std::vector<Texel> texels_;
};

// The last frame as reprojection needs it.
struct SeenSurfaces {
    Pinhole lens;
    Texels place;   // position and part
    Texels facing;  // normal and roughness
};

// For each pixel of a frame four texels of the last one: `first` is the index of the upper left one, counted from
// Texels::row(0); the others are to its right, below, and below right. Weights sum to 1, or to 0 where nothing is known.
struct Taps {
    PlaneOf<std::int32_t> first;
    Plane weight[4];

    void fit(int width, int height);
};

enum class Motion {
    OfSurface,     // light that sticks to its surface
    OfReflection,  // light seen in it: follows the virtual image at the reflected distance, the more the smoother the
                   // surface (dominant direction of Lagarde and de Rousiers 2014, listing 24)
};

// Keeps what the next frame's reproject() asks.
void remember(const GBuffer& surfaces, const Jobs& jobs, SeenSurfaces& seen);

// `taps` is made to fit. With an empty `seen` every weight is 0.
void reproject(const GBuffer& now, const SeenSurfaces& seen, Motion motion, const Jobs& jobs, Taps& taps);

}  // namespace gh::filter
