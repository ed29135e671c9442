// filter/mend_kernel.h - plain data between mend.cpp and its kernel.
#pragma once

#include <cstddef>

namespace gh::filter {

struct MendRow {
    const float* light[3];
    int width, height, y;
    std::ptrdiff_t stride;
    float floor, factor;
    float* out[3];
};

}  // namespace gh::filter
