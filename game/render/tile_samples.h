// render/tile_samples.h - the sample sequences of a tile's pixels. Blue noise hands numbers out by a Z curve whose digits are
// scrambled one below the other: what lies above a tile, and above four by four of its pixels, is worked out once for all
// of them.
//
// Cost      of blue noise about 15 ns a number where most pixels ask, a pixel's own sequence takes 60.
// Threads   scratch memory for one thread.
// Same bits what sample_sequence.h gives.
#pragma once

#include "render/sample_sequence.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gh::render {

class TileSamples {
  public:
    static constexpr int kSide = 16;  // of a tile, pixels

    // The tile's first pixel is (x, y), multiples of kSide; pixels are counted row by row.
    void begin(const SampleSettings& settings, int x, int y, int columns, int rows, std::uint32_t frame);

    [[nodiscard]] float one(std::size_t pixel, std::uint32_t sample, std::uint32_t dimension);
    [[nodiscard]] glm::vec2 two(std::size_t pixel, std::uint32_t sample, std::uint32_t dimension);

  private:
    static constexpr std::size_t kBlocks = 16;  // of four by four pixels, next to each other on the curve
    // What one purpose makes of the curve.
    struct Curve {
        std::uint32_t dimension = 0, coordinates = 0;  // 0: of no purpose yet
        std::uint32_t key = 0, first = 0, second = 0;
        std::uint32_t above = 0;   // of the tile
        std::uint32_t filled = 0;  // a bit a block
        std::array<std::array<std::uint16_t, 16>, kBlocks> places{};
    };
    static constexpr std::size_t kCurves = 64;

    [[nodiscard]] Curve& curve_of(std::uint32_t dimension, std::uint32_t coordinates);
    void fill(Curve& curve, std::uint32_t block) const;
    [[nodiscard]] std::uint32_t index(Curve& curve, std::size_t pixel, std::uint32_t sample) const;

    SampleKind kind_ = SampleKind::Iid;
    std::vector<SampleSequence> sequences_;
    std::vector<Curve> curves_;
};

}  // namespace gh::render
