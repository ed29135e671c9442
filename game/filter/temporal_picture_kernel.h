// filter/temporal_picture_kernel.h - plain data between temporal_upscale.cpp and temporal_picture.cpp.
#pragma once

#include <cstddef>

namespace gh::filter {

// Adds a row of a picture up with those before it.
struct SmoothRow {
    int y, width;
    const float* motion[2];       // of the row, pixels
    const float* lighted[3];      // of the row; what lies left, right, above and below repeats the border
    std::ptrdiff_t above, below;  // from there to the rows around
    bool has_past;
    float still, moving;  // pictures a mean goes over where nothing moves, and where each frame moves them
    const float* moves;   // 1 where something moved by itself; may be null, and then is the next:
    const float* moved_before;  // the same of the last picture, row 0
    std::ptrdiff_t moved_stride;
    const float* change;  // of the row: the least a new picture counts; null: 0
    int then_width, then_height;
    const float* then[3];  // the pictures before, at pixel (0, 0); two pixels around repeat the border
    std::ptrdiff_t then_stride;
    float* next[3];        // of the row
    float* out;            // the same, red, green and blue side by side; null: nobody asks
    float* out_planes[3];  // the same apart, or null
};
void smooth_picture(const SmoothRow& row);

}  // namespace gh::filter
