// filter/enlarge_kernel.h - plain data between enlarge.cpp and its kernels.
#pragma once

#include "filter/guides.h"

#include <cstddef>
#include <cstdint>

namespace gh::filter {

// Where each pixel of a large row lies in a small one: the first of its taps and their weights.
struct ColumnTaps {
    const std::int32_t* first;
    const float* weight[4];
};

struct CubicDownRow {
    const float* in[4];  // small rows; repeated at the picture's edges
    float weight[4];
    int width;      // of the small picture
    float* middle;  // one number a small column; two more are written before it and two behind its end
};

struct CubicAcrossRow {
    const float* middle;
    ColumnTaps taps;
    int width;  // of the large picture
    float* out;
};

// Two rows of a picture of twice the size: those between the second and the third of four small ones.
struct DoubleRows {
    const float* in[4];  // repeated at the picture's edges
    float down[2][4];    // weights of these
    float across[2][4];  // of four columns, for even and for odd columns of the large picture
    int width;           // of the small picture
    float* middle[2];    // as CubicDownRow has it
    float* out[2];       // null: beyond the picture
};
void double_rows(const DoubleRows& rows);

struct JointRow {
    GuideRows large;
    GuideRows small[2];  // upper and lower row
    const float* light[2][3];
    float below;            // share of the lower row
    const float* offset_y;  // two: rows of the large picture from this one to each small one's centre
    const std::int32_t* first;
    const float* right;        // share of the right column
    const float* offset_x[2];  // columns of the large picture to each small one's centre
    int width;
    float* out[3];
};

}  // namespace gh::filter
