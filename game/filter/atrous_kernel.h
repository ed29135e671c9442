// filter/atrous_kernel.h - plain data between atrous.cpp and its kernel.
#pragma once

#include "filter/guides.h"

#include <cstddef>
#include <cstdint>

namespace gh::filter {

struct AtrousRow {
    GuideRows guides;
    const float* light[3];  // red, luminance, blue
    const float* variance;
    const float* stiffness;     // may be null
    const std::uint32_t* part;  // may be null
    float* out_light[3];
    float* out_variance;
    int radius, step;
    int width, height, y;
    std::ptrdiff_t stride;  // of every plane
    float luminance_sigmas;
};

}  // namespace gh::filter
