// filter/variance_kernel.h - plain data between variance.cpp and its kernel.
#pragma once

#include <cstddef>

namespace gh::filter {

struct VarianceRow {
    const float *luminance, *square, *length;
    int width, height, y;
    std::ptrdiff_t stride;
    float* variance;
};

}  // namespace gh::filter
