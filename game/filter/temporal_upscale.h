// filter/temporal_upscale.h - light in few pixels, made into a picture of many by what every one of those shows.
//
// What is seen, its colours and edges, is known in every pixel of the large picture: a ray each (render/guide.h). Light
// is worked out in one pixel of every step x step, another in each frame, and divided by the colours it falls on. Every
// pixel then keeps a running mean of the light on its surface, carried along with it; samples of the same surface count
// the more the nearer they lie. What has changed is found by the samples around: a mean outside their range is brought
// back to it, so that a lamp switched off is dark in the next picture (Karis 2014; Yang, Liu and Salvi 2020, sections 3
// and 5). Last, pictures taken through other places of their pixels are added up, which smooths edges; if asked for, in one of
// twice their sides, which shows more than any of them: a sample counts the more in a pixel the nearer it lies (Yang, Liu and
// Salvi 2020, section 6).
//
// jitter.h says where pixels of a guide are looked through, and which of them are lit.
//
//   filter::TemporalUpscaler upscaler;                     // once; forget() after a cut
//   upscaler.add({small, step, offset, guide}, jobs, picture);   // every frame, in order
//
// Cost      about 43 ns a pixel of the large picture on one core; doubled, some 60 more.
// Threads   rows over all threads; one caller at a time.
// Same bits the picture depends on the frames added since forget() alone, not on threads or instruction set.
// Bad input a sample that is not finite is skipped.
#pragma once

#include "base/image.h"
#include "base/jobs.h"
#include "filter/gbuffer.h"
#include "filter/temporal_light_kernel.h"
#include "filter/temporal_picture_kernel.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gh::filter {

// What each pixel of the large picture shows. Spans have one entry a pixel.
struct Guide {
    int width = 0, height = 0;
    Pinhole lens;
    glm::vec2 jitter{0.0f};                // where pixels were looked through, from their middle, in pixels
    std::span<const std::uint32_t> part;   // kNoSurface: sky
    std::span<const glm::vec3> position;   // as GBuffer::position
    std::span<const glm::vec3> previous;   // as GBuffer::previous
    std::span<const glm::vec3> geometric;  // as GBuffer::geometric
    std::span<const glm::vec3> albedo;     // above 0: what light is multiplied by there, about
    // What shines by itself, and what is known to be mirrored: that need not be right, since lit pixels say what is left.
    std::span<const glm::vec3> clean;
    // Not 0 where a highlight in `clean` outshines all else: the light there is that beside it (lit_light.h). May be empty.
    std::span<const std::uint8_t> outshone{};

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

struct GuidedFrame {
    const Image&
        radiance;  // of one pixel in every step x step of the guide, which has so many times its size
    int step = 1;
    glm::ivec2 offset{0};  // pixel (u, v) shows what pixel step * (u, v) + offset of the guide does
    Guide guide;
    bool doubles = false;  // the picture has twice the guide's sides, not its own

    // The pixel of the guide that a lit pixel is.
    [[nodiscard]] std::size_t index_of_lit(int u, int v) const {
        return guide.index(u * step + offset.x, v * step + offset.y);
    }
};

class TemporalUpscaler {
  public:
    void forget() { has_history_ = false; }

    // `out` is made to have the guide's size, or twice its sides; both may change from frame to frame.
    void add(const GuidedFrame& frame, const Jobs& jobs, Image& out);

  private:
    // Of the lit pixels: what they show, its light, and the range of that among those around on the same surface.
    struct Lit {
        PlaneU32 part;
        Plane3 normal, position, light, low, high;
        Plane distance, known;
    };
    // What is kept of every pixel's light.
    struct Kept {
        Plane3 light;
        Plane count;  // of the samples in its mean; 0: none yet
        Plane distance;
        PlaneU32 part, facing;  // what it lies on, and where that faces

        void fit(glm::ivec2 size) { fit_together(size.x, size.y, light, count, distance, part, facing); }
    };
    // How pixels of the large picture lie between lit ones, a number for every x.
    struct Between {
        std::vector<std::int32_t> u;  // the lit pixel to the left
        std::vector<float> share, near_left, near_right;
    };
    void fit(const GuidedFrame& frame);
    void stretch(glm::ivec2 size);
    void lay_out(const GuidedFrame& frame);
    void demodulate_row(const GuidedFrame& frame, int v);
    void find_range_row(int v);
    void spread_row(const GuidedFrame& frame, int y);
    // temporal_shown.cpp
    [[nodiscard]] PicturePast past() const;
    void smooth_row(const GuidedFrame& frame, int y, Image& out);
    void double_row(const GuidedFrame& frame, int y, Image& out);
    [[nodiscard]] LitPlanes lit_planes() const;

    bool has_history_ = false;
    Pinhole before_;  // the lens of the last frame
    glm::mat3 picture_before_{1.0f};
    glm::ivec2 size_{0}, shown_{0};
    float reach_ = 0.0f;  // of a lit pixel, a metre from the eye
    Between between_;
    Lit lit_;
    Kept kept_, next_;
    Plane motion_x_, motion_y_;
    Plane moves_, moved_before_;     // 1 where a surface moved by itself, in this frame and in the last
    Plane3 lighted_;                 // this frame's picture, bordered
    Plane3 picture_, next_picture_;  // and those before it, added up, bordered
};

}  // namespace gh::filter
