// filter/temporal_light_kernel.h - plain data between temporal_upscale.cpp and temporal_light.cpp.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gh::filter {

inline constexpr float kToSky = 1e4f;  // metres

// What is known of the lit pixels, each plane at pixel (0, 0).
struct LitPlanes {
    const std::uint32_t* part;
    const float* normal[3];
    const float* position[3];
    const float* distance;  // from the eye
    const float* light[3];
    const float* known;  // 1, or 0
    const float* low[3];
    const float* high[3];
    std::ptrdiff_t stride;
    int width, height;
};

// Finds the range of light among a row of lit pixels' neighbours on the same surface.
struct RangeRow {
    LitPlanes lit;
    int v;
    float reach;  // how far one surface leaves its own plane, a metre from the eye
    float* low[3];
    float* high[3];
};
void find_range(const RangeRow& row);

// What is kept of every pixel's light, each plane at pixel (0, 0).
struct KeptPlanes {
    const float* light[3];
    const float* count;                  // of the samples in its mean; 0: none yet
    const float* distance;               // from the eye
    const std::uint32_t *part, *facing;  // the latter as packed_facing() has it
    std::ptrdiff_t stride;
};

// Gives a row of pixels the light of their surfaces: this frame's, as far as lit pixels show the same, and what is kept of
// frames before.
struct SpreadRow {
    int y, width, height;
    // Of the row, x y z after each other.
    const float *position, *previous, *normal, *albedo, *clean;
    const std::uint32_t* part;
    float eye[3], corner[3], right[3];  // `corner` of the row: with how far it lies down
    float jitter[2];
    float eye_before[3], picture_before[9];  // by columns
    LitPlanes lit;
    int v;                  // the row of lit pixels above this row or on it; -1 above the first
    float share_y;          // how far this row is from there to the next
    float near_y[2];        // what a sample of either counts for its distance down
    const std::int32_t* u;  // the same for every x
    const float* share_x;
    const float* near_x[2];
    float step, reach;
    bool has_past;
    KeptPlanes then;
    float* light[3];  // of the row: what is kept next
    float *count, *distance;
    std::uint32_t *kept_part, *kept_facing;
    float* motion[2];   // in pixels, to where the surface was
    float* moves;       // 1 where it moved by itself, else 0
    float* lighted[3];  // this frame's picture
};
void spread_light(const SpreadRow& row);

}  // namespace gh::filter
