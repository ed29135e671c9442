// filter/temporal_upscale.h - light in few pixels, made into a picture of many by what every one of those shows.
//
// What is seen, its colours and edges, is known in every pixel of the large picture: a ray each (render/guide.h). Light
// is worked out in one pixel of every step x step, another in each frame, and divided by the colours it falls on. Every
// pixel then keeps a running mean of the light on its surface, carried along with it; samples of the same surface count
// the more the nearer they lie. What has changed is found by the samples around: a mean outside their range is brought
// back to it, so that a lamp switched off is dark in the next picture (Karis 2014; Yang, Liu and Salvi 2020, sections 3
// and 5). Last, pictures taken through other places of their pixels are added up, which smooths edges.
//
// jitter.h says where pixels of a guide are looked through, and which of them are lit.
//
//   filter::TemporalUpscaler upscaler;                     // once; forget() after a cut
//   upscaler.add({small, step, offset, guide}, jobs, picture);   // every frame, in order
//
// Cost      see README.md: about 145 ns a pixel of the large picture on one core.
// Threads   rows over all threads; one caller at a time.
// Same bits the picture depends on the frames added since forget() alone, not on threads.
// Bad input a sample that is not finite is skipped.
#pragma once

#include "base/image.h"
#include "base/jobs.h"
#include "filter/gbuffer.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
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
    std::span<const glm::vec3> clean;      // what shines by itself

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

    // The pixel of the guide that a lit pixel is.
    [[nodiscard]] std::size_t index_of_lit(int u, int v) const {
        return guide.index(u * step + offset.x, v * step + offset.y);
    }
};

class TemporalUpscaler {
  public:
    void forget() { has_history_ = false; }

    // `out` is made to have the guide's size, which may change from frame to frame.
    void add(const GuidedFrame& frame, const Jobs& jobs, Image& out);

  private:
    // The light of a lit pixel, and its range among those around it on the same surface.
    struct Lit {
        glm::vec3 light{0.0f}, low{0.0f}, high{0.0f};
        bool is_known = false;
    };
    // What is kept of a pixel's light.
    struct Kept {
        glm::vec3 light{0.0f};
        float count = 0.0f;  // of the samples in its mean; 0: none yet
        float distance = 0.0f;
        std::uint32_t part = kNoSurface;
    };
    // Where a pixel's surface was a frame ago.
    struct Motion {
        glm::vec2 by{0.0f};     // pixels
        float distance = 0.0f;  // now, from the eye
        float was_distance = 0.0f;
    };
    void demodulate_row(const GuidedFrame& frame, int v);
    void find_range_row(const GuidedFrame& frame, int v);
    [[nodiscard]] Motion motion_of(const Guide& guide, int x, int y, std::size_t i) const;
    [[nodiscard]] bool are_one(const Guide& guide, std::size_t a, std::size_t b, float distance) const;
    [[nodiscard]] Lit fresh_light(const GuidedFrame& frame, int x, int y, float distance, float& count) const;
    [[nodiscard]] Kept kept_light(const Guide& guide, int x, int y, const Motion& motion,
                                  std::uint32_t part) const;
    void light_row(const GuidedFrame& frame, int y);
    void find_picture_range(const Guide& guide, int y, std::vector<float>& low,
                            std::vector<float>& high) const;
    [[nodiscard]] glm::vec3 picture_at(const glm::vec2& at) const;
    void smooth_row(const Guide& guide, int y, Image& out) const;
    void stretch(const Guide& guide);

    bool has_history_ = false;
    Pinhole before_;  // the lens of the last frame
    glm::mat3 picture_before_{1.0f};
    glm::ivec2 size_{0};
    float reach_ = 0.0f;  // of a lit pixel, a metre from the eye
    std::vector<Lit> lit_;
    std::vector<Kept> kept_, next_;
    std::vector<Motion> motion_;
    std::vector<glm::vec3> lighted_;  // this frame's picture
    std::vector<glm::vec3> picture_;  // and those before it, added up
};

}  // namespace gh::filter
