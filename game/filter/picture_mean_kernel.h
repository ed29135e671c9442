// filter/picture_mean_kernel.h - plain data between picture_mean.cpp and its kernel.
#pragma once

#include "filter/reproject_kernel.h"

#include <cstdint>

namespace gh::filter {

// Where a row of pixels was in the last picture.
struct PlaceRow {
    Projector now, then;
    float corner[3], right[3];  // `corner` of the row: with how far its middle lies down
    const float* position[3];
    const float* previous[3];
    const std::uint32_t* part;
    int width;
    float y;                 // of its pixels' centres
    float scale_x, scale_y;  // of the last picture relative to this one
    float* motion[2];        // pixels
};

}  // namespace gh::filter
