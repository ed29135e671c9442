// collapse.h - a binary tree made eight wide, in the layout the kernels walk.
#pragma once

#include "binned_builder.h"
#include "kernels/kernel_abi.h"
#include "unfilled.h"

#include "raycore/mesh.h"

#include <cstdint>
#include <vector>

namespace rc {

// As many triangles fit into a leaf, whatever they share.
inline constexpr std::uint32_t kAlwaysFit = kernel::kMaxCorners / 3;

inline constexpr std::uint32_t kRangeShift = 28, kFirstMask = (1u << kRangeShift) - 1;

struct WideTree {
    Unfilled<kernel::WideNode> nodes;  // a parent stands before its children
    std::uint32_t root = kernel::kEmptyTree;
};

// BLAS leaves are ranges of the tree's items, which name triangles: as many as fit into a block. fill_leaves gives them
// their places.
[[nodiscard]] WideTree collapse_blas(const BinaryTree& tree, const MeshView& mesh, bool can_refit);

// Items side by side; in a tree's words until it has blocks.
struct ItemRange {
    std::uint32_t first, count;
};
inline ItemRange range_of(std::uint32_t code) {
    return {code & kFirstMask, ((code & ~kernel::kLeafBit) >> kRangeShift) + 1};
}
inline std::uint32_t range_code(ItemRange range) {
    return kernel::kLeafBit | (range.count - 1) << kRangeShift | range.first;
}

// TLAS leaves are single items; `layers[item]` is gathered upwards.
[[nodiscard]] WideTree collapse_tlas(const BinaryTree& tree, const std::vector<std::uint32_t>& layers);

}  // namespace rc
