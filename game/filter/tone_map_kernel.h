// filter/tone_map_kernel.h - plain data between tone_map.cpp and its kernel, and what both have to know of the curve.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gh::filter {

inline constexpr float kKnee = 0.25f;      // below it the curve is straight
inline constexpr float kWhitening = 8.0f;  // exposed peak at which a colour is a quarter of the way to white
inline constexpr std::size_t kDitherSide = 8;
inline constexpr std::size_t kMostLanes = 16;

struct ToneRow {
    const float* radiance;  // red, green, blue, red, ...
    std::size_t width;
    float exposure;
    float dither[kDitherSide + kMostLanes];  // added to the code of pixel x: the one at x % kDitherSide
    std::uint8_t* bytes;                     // as many as there are floats
};

// By the best instruction set there is.
void tone_row(const ToneRow& row);

}  // namespace gh::filter
