// filter/atrous_kernel.h - plain data between atrous.cpp and its kernel.
#pragma once

#include "filter/guides.h"

#include <cstddef>

namespace gh::filter {

struct AtrousSignal {
    const float* light[3];
    const float* luminance;
    const float* variance;
    const float* stiffness;  // may be null
    float* out_light[3];
    float* out_luminance;
    float* out_variance;
};

struct AtrousRow {
    GuideRows guides;
    AtrousSignal signal[2];
    int signals, radius, step;
    int width, height, y;
    std::ptrdiff_t stride;  // of every plane
    float luminance_sigmas;
};

}  // namespace gh::filter
