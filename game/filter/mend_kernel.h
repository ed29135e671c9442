// filter/mend_kernel.h - plain data between mend.cpp and its kernel.
#pragma once

#include <cstddef>

namespace gh::filter {

struct MendRow {
    const float* light[3];
    const float* albedo[3];  // that it is divided by once it is mended; null: 1
    int width, height, y;
    std::ptrdiff_t stride;
    float floor, factor;
    float* out[3];
};

}  // namespace gh::filter
