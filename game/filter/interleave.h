// filter/interleave.h - rows of colours or vectors, three numbers a pixel, to and from three rows of one number a pixel.
//
// Cost      .3 cycles a number with AVX-512, waiting for memory apart.
// Same bits numbers are moved, not computed.
#pragma once

#include <cstddef>

namespace gh::filter {

// `to[c][x]` becomes from[3 * x + c]; `count` pixels, no others are read or written.
void part_row(const float* from, std::size_t count, float* const to[3]);
// The other way round.
void join_row(const float* const from[3], std::size_t count, float* to);

}  // namespace gh::filter
