// tree_math.h - small things all builders share.
#pragma once

#include "binned_builder.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>

namespace rc::build {

inline constexpr float kHuge = std::numeric_limits<float>::max();
inline constexpr GrowingBox kNoBox{{-kHuge, -kHuge, -kHuge, -kHuge}, {-kHuge, -kHuge, -kHuge, -kHuge}};

inline void grow(GrowingBox& box, const GrowingBox& by) {
    for (int i = 0; i < 4; ++i) box.neg_min[i] = std::max(box.neg_min[i], by.neg_min[i]);
    for (int i = 0; i < 4; ++i) box.max[i] = std::max(box.max[i], by.max[i]);
}

inline void grow(kernel::Bins& bins, const kernel::Bins& by) {
    for (int b = 0; b < bins.used; ++b) {
        for (int a = 0; a < 3; ++a) {
            grow(bins.at[b].boxes[a], by.at[b].boxes[a]);
            bins.at[b].entries[a] += by.at[b].entries[a];
            bins.at[b].exits[a] += by.at[b].exits[a];
        }
    }
}

inline float half_area(const GrowingBox& b) {
    const float x = b.max[0] + b.neg_min[0], y = b.max[1] + b.neg_min[1], z = b.max[2] + b.neg_min[2];
    return (x * y + y * z) + z * x;
}

// Adding +0 leaves one zero, whatever order the larger were taken in.
inline void set_box(BinaryNode& node, const GrowingBox& box) {
    for (int a = 0; a < 3; ++a) {
        node.min[a] = 0.0f - box.neg_min[a];
        node.max[a] = box.max[a] + 0.0f;
    }
}

// Twice the centre: no rounding but one, and only its order matters.
inline float centre(const BuildRef& ref, int axis) {
    return ref.max[axis] - ref.neg_min[axis];
}

inline int widest_axis(const GrowingBox& box) {
    int widest = 0;
    for (int a = 1; a < 3; ++a)
        if (box.max[a] + box.neg_min[a] > box.max[widest] + box.neg_min[widest]) widest = a;
    return widest;
}

// Doubled centres that lie in `centres` and may belong to something inside `boxes`.
inline GrowingBox centres_within(const GrowingBox& centres, const GrowingBox& boxes) {
    GrowingBox within;
    for (int i = 0; i < 4; ++i) within.neg_min[i] = std::min(centres.neg_min[i], 2.0f * boxes.neg_min[i]);
    for (int i = 0; i < 4; ++i) within.max[i] = std::min(centres.max[i], 2.0f * boxes.max[i]);
    return within;
}

// Bins over `centres` for n refs. Few need few: most ranges are small, and their bins are most of a build.
inline kernel::BinGrid grid_over(const GrowingBox& centres, std::size_t n) {
    kernel::BinGrid grid{};
    grid.count = static_cast<std::int32_t>(std::min<std::size_t>(kernel::kMaxBins, 4 + n / 8));
    for (int a = 0; a < 3; ++a) {
        const float extent = centres.max[a] + centres.neg_min[a];
        const float scale = float(grid.count) * 0.9999f / extent;
        grid.origin[a] = 0.0f - centres.neg_min[a];
        grid.scale[a] = extent > 0.0f && scale < kHuge ? scale : 0.0f;
    }
    return grid;
}

inline int ceil_log2(std::size_t n) {
    return static_cast<int>(std::bit_width(n - 1));
}

}  // namespace rc::build
