// filter/reproject_kernel.h - plain data between reproject.cpp and its kernel.
#pragma once

#include "filter/gbuffer.h"
#include "filter/guides.h"
#include "filter/movement.h"

#include <cstddef>
#include <cstdint>

namespace gh::filter {

// Picture coordinates of p: d = p - eye; (across . d, down . d) / (ahead . d).
struct Projector {
    float eye[3], across[3], down[3], ahead[3];
};

// The rows of the inverse of (right, down, corner).
[[nodiscard]] Projector projector_of(const Pinhole& lens);

struct ReprojectRow {
    Projector now, then;
    const float* position[3];
    const float* previous[3];
    const float* normal[3];
    const float* nearness;
    const float* roughness;  // may be null
    const float* reflected;  // null: motion of the surface
    const std::uint32_t* part;
    int width;  // of this frame's row
    float y;    // of its pixels' centres

    GuideRows then_guides;  // of row 0
    const std::uint32_t* then_part;
    int then_width, then_height;
    std::ptrdiff_t then_stride;
    float scale_x, scale_y;  // of the last picture relative to this one

    std::int32_t* first;
    float* weight[4];

    float* motion[2];           // null: nobody asks for it
    float* moves;               // null with those
    RowSpan* itself;            // null with those
    float corner[3], right[3];  // then: of the lens; `corner` with how far the row's middle lies down
};

// What all rows of a picture share but for guides, and what each asks of its own.
[[nodiscard]] ReprojectRow reproject_row_of(const GBuffer& now, const Pinhole& then, glm::ivec2 size_then);
void point_to_surfaces(const GBuffer& now, int y, ReprojectRow& row);
void point_to_movement(const GBuffer& now, int y, Movement& movement, ReprojectRow& row);

}  // namespace gh::filter
