// binned_builder.h - a binary tree over boxes by the binned surface-area heuristic (Wald 2007).
//
// Cost      O(n log n); subtrees run in parallel in the caller's task arena.
// Same bits one tree per input, whatever the thread count: bins hold minima, maxima and counts, which do not care
//           about order; a range is partitioned by one thread; a subtree's nodes have a place reserved beforehand.
// Depth     at most kernel::kMaxDepth: a split by cost is taken only while the larger half could still be halved
//           by count within the depth that is left; otherwise the range is halved by count.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

namespace rc {

// A box to be sorted into the tree.
struct alignas(32) BuildRef {
    float min[3];
    std::uint32_t item;
    float max[3];
    std::uint32_t unused;
};
static_assert(sizeof(BuildRef) == 32);

struct alignas(32) BinaryNode {
    float min[3];
    std::uint32_t first;  // leaf: first of its refs; inner: index of the right child, the left one being next
    float max[3];
    std::uint32_t count;  // refs of a leaf; 0 for an inner node

    [[nodiscard]] bool is_leaf() const { return count != 0; }
};
static_assert(sizeof(BinaryNode) == 32);

struct SplitCosts {
    std::uint32_t max_leaf = 8;
    float step = 0.5f;  // of a binary node
    float leaf = 1.0f;  // of a leaf whatever it holds
    float item = 0.3f;  // of each thing in it
};

// Half the surface, which is what costs are proportional to.
template <class Bounded>
[[nodiscard]] float half_area(const Bounded& b) {
    const float x = b.max[0] - b.min[0], y = b.max[1] - b.min[1], z = b.max[2] - b.min[2];
    return (x * y + y * z) + z * x;
}

// Reorders `refs` so that every leaf is a range of them. Node 0 is the root; refs must not be empty.
[[nodiscard]] std::unique_ptr<BinaryNode[]> build_binary_tree(std::span<BuildRef> refs,
                                                              const SplitCosts& costs);

}  // namespace rc
