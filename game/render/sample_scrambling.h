// render/sample_scrambling.h - how the numbers of a sample sequence are made from an index: Sobol's first two dimensions,
// nested uniform scrambling, and the scrambled Z curve.
//
// Same bits integers until the end.
#pragma once

#include "base/random.h"

#include <array>
#include <cstdint>

namespace gh::render {

inline constexpr int kBlockBits = 8;  // of pixels a side that share one sequence under blue noise

[[nodiscard]] constexpr std::uint32_t reversed(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0F0F0F0Fu) | ((x & 0x0F0F0F0Fu) << 4);
    x = ((x >> 8) & 0x00FF00FFu) | ((x & 0x00FF00FFu) << 8);
    return (x >> 16) | (x << 16);
}

// Flips every bit by a hash of the ones below it: in the order of reversed bits that is nested uniform scrambling
// (Laine and Karras 2011). Additions, odd multiplications and x ^= x * even carry upwards only.
[[nodiscard]] constexpr std::uint32_t carried_up(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

// The second Sobol dimension's bits, last one first: row j of Pascal's triangle modulo 2 takes every index bit whose
// number contains that of j (Lucas), a sum over supersets.
[[nodiscard]] constexpr std::uint32_t second_dimension(std::uint32_t index) {
    index ^= (index & 0xAAAAAAAAu) >> 1;
    index ^= (index & 0xCCCCCCCCu) >> 2;
    index ^= (index & 0xF0F0F0F0u) >> 4;
    index ^= (index & 0xFF00FF00u) >> 8;
    index ^= (index & 0xFFFF0000u) >> 16;
    return index;
}

// The number in [0, 1) that an index stands for, by a scrambling of its own for each coordinate.
[[nodiscard]] constexpr float first_coordinate(std::uint32_t index, std::uint32_t scrambling) {
    return unit_from_bits(reversed(carried_up(index, scrambling)));
}
[[nodiscard]] constexpr float second_coordinate(std::uint32_t index, std::uint32_t scrambling) {
    return first_coordinate(second_dimension(index), scrambling);
}

// Of a number below 256: room for another's between its bits.
[[nodiscard]] constexpr std::uint32_t spread_bits(std::uint32_t x) {
    x = (x | (x << 4)) & 0x0F0Fu;
    x = (x | (x << 2)) & 0x3333u;
    return (x | (x << 1)) & 0x5555u;
}

// All orders of four children.
inline constexpr std::array<std::array<std::uint8_t, 4>, 24> kDigitOrders = [] {
    std::array<std::array<std::uint8_t, 4>, 24> orders{};
    std::size_t n = 0;
    for (unsigned a = 0; a < 4; ++a) {
        for (unsigned b = 0; b < 4; ++b) {
            for (unsigned c = 0; c < 4; ++c) {
                if (a == b || a == c || b == c) continue;
                const unsigned d = 6 - a - b - c;
                orders[n++] = {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b),
                               static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(d)};
            }
        }
    }
    return orders;
}();

// How the four children of a node of the tree of digits are renamed: the node is what stands above the digit, whose upper
// end is bit `end` of the index.
[[nodiscard]] constexpr const std::array<std::uint8_t, 4>& digit_order(std::uint32_t above, std::uint32_t key,
                                                                       int end) {
    return kDigitOrders[hash_u32(above, key, static_cast<std::uint32_t>(end)) % 24u];
}

// Renames the children of every node of the tree of digits, each node by itself. `above` is what
// became of the bits from `end` on.
[[nodiscard]] constexpr std::uint32_t scrambled_digits(std::uint32_t index, int end, std::uint32_t key,
                                                       std::uint32_t above) {
    std::uint32_t result = above;
    int left = end;
    for (; left >= 2; left -= 2) {
        const std::uint32_t node = left < 32 ? index >> left : 0u;
        result = (result << 2) | digit_order(node, key, left)[(index >> (left - 2)) & 3u];
    }
    if (left == 1) result = (result << 1) | ((index ^ hash_u32(index >> 1, key)) & 1u);
    return result;
}

}  // namespace gh::render
