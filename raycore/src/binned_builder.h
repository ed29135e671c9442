// binned_builder.h - a binary tree over boxes by the binned surface-area heuristic (Wald 2007).
//
// Cost      O(n log n); ranges above a few thousand refs are cut in parallel, in the caller's task arena. Works in
//           place: besides the refs there are only the nodes, packed as they are made.
// Same bits one tree per input, whatever the thread count: bins hold minima, maxima and counts, which do not care
//           about order; a range is partitioned in blocks of fixed size. Only where a node lies among the others
//           differs; nobody may look at that.
// Depth     at most kernel::kMaxDepth: a split by cost is taken only while the larger half could still be halved
//           by count within the depth that is left; otherwise the range is halved by count.
#pragma once

#include "kernels/build_abi.h"
#include "unfilled.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace rc {

struct BinaryTree {
    Unfilled<BinaryNode> nodes;      // the root first; room for more than there are
    Unfilled<std::uint8_t> heights;  // of nodes: 0 of a leaf; only of those that are cut from the top
    std::size_t size = 0;
    Unfilled<std::uint32_t> items;  // of refs, leaf by leaf
};

struct SplitCosts {
    std::uint32_t max_leaf = kernel::kMaxCorners / 3;  // fit into one whatever they share
    float step = 0.7f;  // of a binary node; collapse.cpp puts together again what is not worth a wide one
    // Of one whose surface is more than this share of the root's: so many rays come by that it stays in the caches, and
    // there are few of them. What is cut there ends the large leaves that nearly every ray would look into for nothing.
    float step_if_large = 0.4f;
    float large = 1e-3f;
    float leaf = 1.0f;  // of a leaf whatever it holds
    float item = 0.3f;  // of each thing in it
};

// Half the surface, which is what costs are proportional to.
template <class Bounded>
[[nodiscard]] float half_area(const Bounded& b) {
    const float x = b.max[0] - b.min[0], y = b.max[1] - b.min[1], z = b.max[2] - b.min[2];
    return (x * y + y * z) + z * x;
}

// Reorders `refs`, which must not be empty.
[[nodiscard]] BinaryTree build_binary_tree(std::span<BuildRef> refs, const SplitCosts& costs);

}  // namespace rc
