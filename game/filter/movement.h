// filter/movement.h - how far each pixel's surface came since the last picture, and where something moved by itself.
//
// Cost      3 ns a pixel with AVX-512, 1 where reproject() finds it by the way.
// Threads   rows by themselves. Same bits for any number of them and any instruction set.
// Bad input a NaN position was not seen, and moved.
#pragma once

#include "filter/gbuffer.h"
#include "filter/rows.h"

#include <glm/vec2.hpp>

#include <vector>

namespace gh::filter {

// Columns [begin, end) of a row, in whole blocks, so that all instruction sets mean the same.
struct RowSpan {
    static constexpr int kBlock = 16;
    int begin = 0, end = 0;
};

struct Movement {
    static constexpr float kUnseen = -1e6f;  // pixels: outside any picture

    // Pixels from each to where its surface was, rounded to 1/256, jitter left out: right and down; the sky's by its
    // direction; kUnseen where it was not in front of the eye.
    Plane x, y;
    // Of each row the columns in which a surface was elsewhere a frame ago, whatever the camera did: by a
    // ten-thousandth of its distance or more, which is no rounding.
    std::vector<RowSpan> itself;

    // 1 in pixels whose surface did, else 0; and the same of the last picture, of the size that had.
    Plane moves, moved_before;
    // Rows [begin, end) of the last picture, outside of which nothing did.
    int moved_begin = 0, moved_end = 0;

    void fit(int width, int height);
    // Once a picture is made: this one is the last.
    void finish();
};

// From a picture of `size_then` pixels taken through `then`. `movement` is made to fit.
[[nodiscard]] RowWork movement_rows(const GBuffer& now, const Pinhole& then, glm::ivec2 size_then,
                                    Movement& movement);

}  // namespace gh::filter
