// filter/atrous_kernel.h - what goes between atrous.cpp and its kernel.
#pragma once

#include "filter/guides.h"

#include <cstddef>
#include <cstdint>

namespace gh::filter {

inline constexpr int kMostTogether = 4;

struct AtrousSignal {
    const float* light[3];  // red, luminance, blue
    const float* variance;
    const float* stiffness;     // may be null
    const std::uint32_t* part;  // may be null
    float* out_light[3];
    float* out_variance;  // null: nobody asks
    float luminance_sigmas;
};

// A row of all signals that are smoothed over the same neighbours.
struct AtrousRow {
    GuideRows guides;
    AtrousSignal signals[kMostTogether];
    int count;
    int radius, step;
    int width, height, y;
    std::ptrdiff_t stride;  // of every plane
};

void atrous_row(const AtrousRow& row);

}  // namespace gh::filter
