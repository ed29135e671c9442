// filter/temporal_picture_kernel.h - plain data between those who add pictures up and their kernels.
#pragma once

#include <cstddef>

namespace gh::filter {

// What the pictures before have left.
struct PicturePast {
    bool is_there;
    int width, height;
    const float* picture[3];  // their mean, at pixel (0, 0); two pixels around repeat the border
    std::ptrdiff_t stride;
    const float* moved;  // 1 where something moved by itself in the last picture, row 0; null: nobody knows
    std::ptrdiff_t moved_stride;
    int moved_begin, moved_end;  // rows outside of which nothing did
};

// Pictures a mean goes over where nothing moves, and where each frame moves them.
struct MeanLength {
    float still, moving;
};

// Adds a row of a picture up with those before it.
struct SmoothRow {
    int y, width;
    const float* motion[2];       // of the row, pixels
    const float* lighted[3];      // of the row; what lies left, right, above and below repeats the border
    std::ptrdiff_t above, below;  // from there to the rows around
    MeanLength pictures;
    const float* moves;   // of the row, as PicturePast::moved, if that is known
    const float* change;  // of the row: the least a new picture counts; null: 0
    PicturePast past;
    float* next[3];        // of the row
    float* out;            // the same, red, green and blue side by side; null: nobody asks
    float* out_planes[3];  // the same apart, or null
};
void smooth_picture(const SmoothRow& row);

// The same into a picture of twice its sides. Of the columns of a large picture the even ones all lie in the same way
// between the small picture's samples, and so do the odd ones; numbers of each come in twos.
struct DoubleRow {
    int y, width;                // of the large picture
    const float* picture[3][3];  // rows of the small one around the sample nearest to the row; colours. As SmoothRow::lighted
    const float* motion[2];      // of the middle one, small pixels
    const float* moves;          // of the middle one, as in SmoothRow
    int nearest[2];              // from small column u to the sample that is nearest to large column 2 u, 2 u + 1
    float across[2][3];          // what that sample and its neighbours count
    float down[3];
    float nearness[2];  // what this picture counts there, times what each of all does on average
    MeanLength pictures;
    float nearness_moving;  // how much of that is left where each frame moves things
    PicturePast past;  // of the large picture; `moved` is of the small one
    float* next[3];
    float* out;
};
void double_picture(const DoubleRow& row);

}  // namespace gh::filter
