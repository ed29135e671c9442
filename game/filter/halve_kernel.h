// filter/halve_kernel.h - plain data between halve.cpp and its kernels.
#pragma once

#include "filter/guides.h"

#include <cstdint>

namespace gh::filter {

// Planes of which every second pixel is kept.
inline constexpr int kMostPicked = 20;

struct HalveRow {
    GuideRows
        guides[2];  // upper and lower row; the upper one twice at the end of a picture with an odd height
    const std::uint32_t* part[2];
    int lights;  // 0 to 2
    const float* light[2][2][3];
    float* out_light[2][3];
    int picked;
    const std::uint32_t* from[kMostPicked];  // numbers of any kind
    std::uint32_t* to[kMostPicked];
    int width;        // of the large picture
    bool has_second;  // whether there is a lower row
};

struct WidenRow {
    GuideRows large, small[2];
    const std::uint32_t* large_part;
    const std::uint32_t* small_part[2];
    int lights;
    const float* light[2][2][3];
    bool asks_part[2];
    float* out[2][3];
    float below;        // what the lower row counts for its nearness
    float offset_y[2];  // large rows from this one to the middle of each small one
    int width;          // of the large picture
    int small_width;
};

}  // namespace gh::filter
