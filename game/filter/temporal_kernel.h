// filter/temporal_kernel.h - plain data between temporal.cpp and its kernels.
#pragma once

#include <cstdint>

namespace gh::filter {

struct AccumulateRow {
    const float* sample[3];
    const float* change;  // may be null
    const std::int32_t* first;
    const float* weight[4];
    const float* then_light;  // Texels::row(0); null: no past
    const float* then_pace;
    int then_stride;
    int width;
    float longest, fast_longest;
    float* light[3];
    float *luminance, *square, *length, *fast;
};

struct PackRow {
    const float* light[3];
    const float *square, *length, *fast;
    int width;
    float *to_light, *to_pace;
};

}  // namespace gh::filter
