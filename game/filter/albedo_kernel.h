// filter/albedo_kernel.h - plain data between albedo.cpp and its kernels.
#pragma once

namespace gh::filter {

struct DemodulateRow {
    const float* light[3];
    const float* albedo[3];
    int width;
    float* out[3];
};

struct GreenRow {
    const float* from[3];
    int width;
    bool to_luminance;
    float* to[3];
};

struct RemodulateRow {
    const float* parts[4][3];  // direct, indirect, specular: red, luminance, blue; clean: colour; null: black
    const float* albedo[3];    // null: 1
    const float* gloss[3];     // null: 1
    int width;
    float* out[3];
};

}  // namespace gh::filter
