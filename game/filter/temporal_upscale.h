// filter/temporal_upscale.h - many small pictures, each of slightly different places, made into a larger one.
//
// Every frame's samples lie elsewhere in their pixels (`jitter`). Each pixel of the large picture keeps a running mean,
// carried along with what it shows; the nearest new sample counts the more the nearer it lies. What has changed is
// found by the colours around: a mean outside their range is brought back to it, so that a lamp switched off is dark
// in the next picture (Karis 2014; Yang, Liu and Salvi 2020, section 3 and 5).
//
//   filter::TemporalUpscaler upscaler;                                // once; forget() after a cut
//   upscaler.add(frame, {640, 360}, jobs, picture);                   // every frame, in order
//
// Cost      about 60 ns a pixel of the large picture and 40 of the small one, on one core.
// Threads   rows over all threads; one caller at a time.
// Same bits the picture depends on the frames added since forget() alone, not on threads.
// Bad input a sample that is not finite is skipped.
#pragma once

#include "base/image.h"
#include "base/jobs.h"
#include "filter/gbuffer.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gh::filter {

// A picture and what each of its pixels shows. Spans have one entry a pixel of `radiance`.
struct JitteredFrame {
    const Image& radiance;
    Pinhole lens;                         // of the small picture
    glm::vec2 jitter{0.0f};               // where samples lie, from the middle of their pixels, in pixels
    std::span<const std::uint32_t> part;  // kNoSurface: sky
    std::span<const glm::vec3> position;  // as GBuffer::position
    std::span<const glm::vec3> previous;  // as GBuffer::previous
};

// Frame `i` of an even sequence of jitters (Halton 2, 3), in [-0.5, 0.5).
[[nodiscard]] glm::vec2 halton_jitter(std::uint32_t i);

class TemporalUpscaler {
  public:
    void forget() { has_history_ = false; }

    // `out` is made to have the size asked for; that of the small picture may change from frame to frame.
    void add(const JitteredFrame& frame, glm::ivec2 size, const Jobs& jobs, Image& out);

  private:
    // A pixel of the small picture as the large one asks for it.
    struct Sample {
        glm::vec3 color{0.0f};
        glm::vec3 low{0.0f}, high{0.0f};  // of the nine around it
        glm::vec2 motion{0.0f};           // to where it was a frame ago, in widths and heights of the picture
        float distance = 0.0f;            // from the eye
        float was_distance = 0.0f;        // from where the eye was, a frame ago
        bool stays = true;                // in the world; only the eye moves
        std::uint32_t part = kNoSurface;
    };
    struct Kept {
        glm::vec3 color{0.0f};
        float weight = 0.0f;    // of the samples in its mean; 0: none yet
        float distance = 0.0f;  // from the eye
        std::uint32_t part = kNoSurface;
        bool stays = true;
    };
    // What is kept has another size: begin with it stretched.
    void stretch(glm::ivec2 size);
    void gather_row(const JitteredFrame& frame, int y);
    [[nodiscard]] Kept kept_at(const glm::vec2& place) const;
    [[nodiscard]] static bool is_same(const Kept& kept, const Sample& sample);
    // `around`: the sample and the four beside it.
    [[nodiscard]] bool is_known(const Kept& kept, const std::array<const Sample*, 5>& around) const;
    [[nodiscard]] glm::vec3 smooth(const JitteredFrame& frame, const glm::vec2& place,
                                   const Sample& nearest) const;
    [[nodiscard]] Kept renewed(const JitteredFrame& frame, int x, int y) const;

    bool has_history_ = false;
    Pinhole before_;  // the lens of the last frame
    glm::ivec2 before_size_{0};
    glm::ivec2 size_{0};
    float parallax_ =
        0.0f;  // how far something a metre away has moved across the picture, at most, in its pixels
    std::vector<Sample> samples_;
    std::vector<Kept> kept_, next_;
};

}  // namespace gh::filter
