// filter/bordered.h - pictures whose outermost pixels repeat two beyond every edge, so that a cubic filter needs to know
// nothing of edges.
//
// Same bits pure.
#pragma once

#include "filter/plane.h"

#include <glm/vec2.hpp>

#include <algorithm>

namespace gh::filter {

inline constexpr int kBorder = 16;  // pixels on either side of a row, of which two repeat the outermost

inline void fit_bordered(Plane3& planes, glm::ivec2 size) {
    planes.fit((size.x + 15) / 16 * 16 + 2 * kBorder, size.y + 4);
}

// At pixel (0, y) of the picture, `y` from -2 to 1 below the last.
inline float* bordered_row(Plane& plane, int y) {
    return plane.row(y + 2) + kBorder;
}
inline const float* bordered_row(const Plane& plane, int y) {
    return plane.row(y + 2) + kBorder;
}
template <class Planes, class Number>
void point_to_bordered(Number* to[3], Planes& planes, int y) {
    to[0] = bordered_row(planes.x, y);
    to[1] = bordered_row(planes.y, y);
    to[2] = bordered_row(planes.z, y);
}

// Of a row that was written.
inline void repeat_sides(Plane3& planes, int width, int y) {
    for (Plane* plane : {&planes.x, &planes.y, &planes.z}) {
        float* const row = bordered_row(*plane, y);
        row[-2] = row[-1] = row[0];
        row[width] = row[width + 1] = row[width - 1];
    }
}

// Of a picture whose rows all were.
inline void repeat_rows(Plane3& planes, int height) {
    for (Plane* plane : {&planes.x, &planes.y, &planes.z}) {
        for (const int y : {-2, -1, height, height + 1}) {
            const float* const from = plane->row(std::clamp(y, 0, height - 1) + 2);
            std::copy_n(from, plane->width(), plane->row(y + 2));
        }
    }
}

}  // namespace gh::filter
