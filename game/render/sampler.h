// render/sampler.h - the numbers that choose where on a lamp a shadow ray looks, and where in a pixel the eye does.
//
// Points come from the Sobol sequence in two dimensions, whose every aligned run of 16 puts one point into each cell of
// a 4x4 grid. Pixels of a 4x4 block take the points of such a run in the order of a Bayer matrix, so that together
// they look everywhere, and each 2x2 of them does nearly so.
// Same bits pure, integers until the end.
#pragma once

#include "base/random.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>

namespace gh::render {

// Its place in the order of its 4x4 block: neighbours are far apart in it.
[[nodiscard]] constexpr std::uint32_t block_place(int x, int y) {
    constexpr std::array<std::uint32_t, 16> kBayer = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    return kBayer[static_cast<std::size_t>((y & 3) * 4 + (x & 3))];
}

// Point `index` of the sequence, moved by `scramble` in a way that keeps its evenness.
[[nodiscard]] constexpr glm::vec2 sobol_point(std::uint32_t index, std::uint32_t scramble) {
    std::uint32_t first = scramble;
    std::uint32_t second = hash_u32(scramble, 0x5bd1e995u);
    std::uint32_t direction = 0x80000000u;  // of the second dimension: Pascal's triangle modulo 2
    for (std::uint32_t bit = 0x80000000u; index != 0; index >>= 1, bit >>= 1) {
        if ((index & 1u) != 0) {
            first ^= bit;
            second ^= direction;
        }
        direction ^= direction >> 1;
    }
    return {unit_from_bits(first), unit_from_bits(second)};
}

// Where the samples of one pixel come from.
struct PixelSampler {
    std::uint32_t first = 0;     // index of the pixel's first point
    std::uint32_t stride = 1;    // to its next one
    std::uint32_t scramble = 0;  // the same for all pixels that share samples

    // Point `i` for one purpose: a lamp's id, a depth.
    [[nodiscard]] glm::vec2 point(std::uint32_t i, std::uint32_t purpose, std::uint32_t depth) const {
        return sobol_point(first + stride * i, hash_u32(scramble, purpose, depth));
    }
};

// Pixels that share take points of one sequence in turn, those that do not have one each.
[[nodiscard]] constexpr PixelSampler pixel_sampler(int x, int y, std::uint32_t frame, bool shares) {
    if (shares) return {.first = block_place(x, y), .stride = 16, .scramble = hash_u32(frame, 1)};
    return {.scramble = hash_u32(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), frame)};
}

}  // namespace gh::render
