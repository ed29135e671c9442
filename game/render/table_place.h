// render/table_place.h - looking a number up between the entries of a table.
#pragma once

#include <algorithm>
#include <cstddef>

namespace gh::render {

// The entry below, and how far from it to the next.
struct TablePlace {
    std::size_t cell;
    float t;
};

// Where x in [0, 1], or what of it is nearest, lies on `side` >= 2 even entries.
[[nodiscard]] inline TablePlace place_in_table(float x, int side) {
    const float scaled = std::clamp(x, 0.0f, 1.0f) * static_cast<float>(side - 1);
    const int cell = std::min(static_cast<int>(scaled), side - 2);
    return {static_cast<std::size_t>(cell), scaled - static_cast<float>(cell)};
}

[[nodiscard]] inline float blend(float a, float b, float t) {
    return a + (b - a) * t;
}

[[nodiscard]] inline float between(const float* table, std::size_t columns, const TablePlace& row,
                                   const TablePlace& column) {
    const float* low = table + row.cell * columns + column.cell;
    const float* high = low + columns;
    return blend(blend(low[0], low[1], column.t), blend(high[0], high[1], column.t), row.t);
}

}  // namespace gh::render
