// filter/guides_kernel.h - plain data between guides.cpp and its kernel.
#pragma once

#include "filter/reproject_kernel.h"

#include <cstdint>

namespace gh::filter {

struct GuidesRow {
    float eye[3], ahead[3], corner[3], right[3], down[3];
    const float* position[3];
    const float* geometric[3];
    const float* smooth[3];
    const std::uint32_t* part;
    int width;
    float y;  // of the pixels' centres
    float *nearness, *slope_x, *slope_y;
    float* normal[3];
};

}  // namespace gh::filter
