// filter/bilateral_kernel.h - plain data between bilateral.cpp and its kernel.
#pragma once

#include "filter/guides.h"

#include <cstddef>

namespace gh::filter {

struct BilateralRow {
    const float* light[3];
    const float* albedo[3];  // null: not looked at
    GuideRows guides;        // null: not looked at
    const float* spatial;    // quarter exponents of distances, (2 reach + 1)^2 of them
    int reach;
    int width, height, y;
    std::ptrdiff_t stride;
    float luminance_scale, albedo_scale;  // quarter exponent by unit of difference; 0: not looked at
    float* out[3];
};

}  // namespace gh::filter
