// filter/picture_past.h - the mean of pictures before, as kernels read it and as it is kept when pictures change their size.
#pragma once

#include "filter/bordered.h"
#include "filter/plane.h"
#include "filter/temporal_picture_kernel.h"

#include <glm/vec2.hpp>

#include <utility>

namespace gh::filter {

// Of a bordered picture.
[[nodiscard]] inline PicturePast past_of(const Plane3& mean, glm::ivec2 size) {
    PicturePast past{};
    past.is_there = true;
    past.width = size.x;
    past.height = size.y;
    point_to_bordered(past.picture, mean, 0);
    past.stride = mean.x.stride();
    return past;
}

// Of which rows [begin, end) are asked.
inline void point_to_moved(PicturePast& past, const Plane& moved, int begin, int end) {
    past.moved = moved.row(0);
    past.moved_begin = begin;
    past.moved_end = end;
    past.moved_stride = moved.stride();
}

// A bordered picture in another size, each pixel the one that lies there.
[[nodiscard]] inline Plane3 stretched(const Plane3& from, glm::ivec2 size_then, glm::ivec2 size) {
    Plane3 to;
    fit_bordered(to, size);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const int u = x * size_then.x / size.x, v = y * size_then.y / size.y;
            to.set(x + kBorder, y + 2, from.get(u + kBorder, v + 2));
        }
        repeat_sides(to, size.x, y);
    }
    repeat_rows(to, size.y);
    return to;
}

}  // namespace gh::filter
