// filter/temporal_kernel.h - plain data between temporal.cpp and its kernel.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gh::filter {

struct AccumulateRow {
    const float* sample[3];
    const float* change;  // may be null
    const std::int32_t* first;
    const float* weight[4];
    bool has_past;
    const float* then_light[3];  // row 0
    const float *then_square, *then_length, *then_fast;
    std::ptrdiff_t then_stride;
    int width;
    float longest, fast_longest;
    float* light[3];
    float *square, *length, *fast;
};

}  // namespace gh::filter
