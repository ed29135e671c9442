// render/sample_sequence.h - the numbers a path is made from, one stream a pixel, in four qualities that can be
// compared with each other.
//
//   Iid        independent: error falls as N^-1/2
//   Jittered   one a cell of an even grid, cells in random order: N^-1 where the light is smooth
//   Sobol      nested uniform scrambling (Owen 1995) of the Sobol sequence, every pair of dimensions shuffled apart
//              (Burley 2020): N^-3/2 where the light is smooth. Goes on from frame to frame, so that a still picture
//              gathered over frames converges as one
//   BlueNoise  one such sequence for a whole block of pixels, handed out along a scrambled Z curve (Ahmed and Wonka
//              2020): what is wrong in a pixel its neighbours have the other way round, so filters take it away
//
// All are unbiased: the mean over seeds is the integral.
//
// Cost      5 to 40 ns a pair; of blue noise for all pixels of a tile, tile_samples.h has them for less.
// Threads   a value; copy it.
// Same bits integers until the end: a function of (settings, pixel, frame, sample, dimension).
#pragma once

#include <glm/vec2.hpp>

#include <cstdint>

namespace gh::render {

enum class SampleKind : std::uint8_t { Iid, Jittered, Sobol, BlueNoise };

struct SampleSettings {
    SampleKind kind = SampleKind::Sobol;
    std::uint32_t samples_per_pixel = 1;
    std::uint32_t seed = 0;  // another one is another, independent picture
};

class SampleSequence {
  public:
    SampleSequence() = default;
    SampleSequence(const SampleSettings& settings, int x, int y, std::uint32_t frame);

    // For one purpose each, in [0, 1): dimensions are independent of each other. `sample` < samples_per_pixel.
    [[nodiscard]] float one(std::uint32_t sample, std::uint32_t dimension) const;
    [[nodiscard]] glm::vec2 two(std::uint32_t sample, std::uint32_t dimension) const;

    // What tile_samples.h goes by.
    [[nodiscard]] std::uint32_t seed() const { return seed_; }
    [[nodiscard]] std::uint32_t log2_count() const { return log2_count_; }
    [[nodiscard]] std::uint32_t curve() const { return curve_; }

  private:
    [[nodiscard]] std::uint32_t index(std::uint32_t sample, std::uint32_t key) const;

    SampleKind kind_ = SampleKind::Iid;
    std::uint32_t count_ = 1;
    std::uint32_t seed_ = 0;   // of the pixel, or of its block
    std::uint32_t first_ = 0;  // index of this frame's first sample
    std::uint32_t log2_count_ = 0;
    std::uint32_t curve_ = 0;  // place of the pixel on its block's Z curve
};

}  // namespace gh::render
