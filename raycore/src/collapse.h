// collapse.h - a binary tree made eight wide, in the layout the kernels walk.
#pragma once

#include "binned_builder.h"
#include "kernels/kernel_abi.h"
#include "unfilled.h"

#include <cstdint>
#include <vector>

namespace rc {

struct WideTree {
    Unfilled<kernel::WideNode> nodes;  // a parent stands before its children
    std::uint32_t root = kernel::kEmptyTree;
};

// BLAS leaves are ranges of the tree's items (see kernel_abi.h).
[[nodiscard]] WideTree collapse_blas(const BinaryTree& tree);

// TLAS leaves are single items; `layers[item]` is gathered upwards.
[[nodiscard]] WideTree collapse_tlas(const BinaryTree& tree, const std::vector<std::uint32_t>& layers);

}  // namespace rc
