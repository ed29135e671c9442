// kernels/build_abi.h - what the builders' inner loops share with the builders: plain layouts and one table.
//
// Same bits the loops compare, add and multiply in single precision, never fused: every ISA finds the same split.
#pragma once

#include "kernels/kernel_abi.h"

#include <cstdint>

namespace rc {

// Beyond 2^60 products of differences would leave single precision; such a vertex counts as infinite.
inline constexpr float kLargestCoordinate = 0x1p60f;

// A box as -min and max: both grow by taking the larger, eight floats at a time. The fourth of each four means nothing.
struct alignas(32) GrowingBox {
    float neg_min[4];
    float max[4];
};

// How far the boxes around a triangle reach beyond it, in shares of its largest extent: what its corners' own roundings
// can move a hit by (README.md, "Why culling never decides"). What the way to the triangle does is forgiven by the ray.
inline constexpr float kSlack = 0x1p-21f;

// A box to be sorted into a tree.
struct alignas(32) BuildRef {
    float neg_min[3];
    std::uint32_t item;
    float max[3];
    std::uint32_t unused;
};
static_assert(sizeof(BuildRef) == sizeof(GrowingBox));

struct alignas(32) BinaryNode {
    float min[3];
    std::uint32_t
        first;  // leaf: first of its items; inner: index of the left child, the right one being next
    float max[3];
    std::uint32_t count;  // items of a leaf; kInner and how many items are below it for an inner node

    static constexpr std::uint32_t kInner = 0x80000000u;
    [[nodiscard]] bool is_leaf() const { return (count & kInner) == 0; }
    [[nodiscard]] std::uint32_t size() const { return count & ~kInner; }
};
static_assert(sizeof(BinaryNode) == 32);

namespace kernel {

inline constexpr int kMaxBins = 16;
inline constexpr int kFewRefs = 4;

// Which bin a doubled centre falls into, per axis: (centre - origin) * scale, clamped to 0 ... count - 1.
struct BinGrid {
    float origin[4];
    float scale[4];  // 0 where there is nothing to tell apart
    std::int32_t count;
};

// What lies in a bin, or in a slab, along each axis.
struct Bin {
    GrowingBox boxes[3];
    std::uint32_t entries[4];  // of things that begin in it
    std::uint32_t exits[4];    // that end in it; refs, which are put by their centres, have none of their own
};
static_assert(sizeof(Bin) == 128);  // a shift finds it

struct Bins {
    Bin at[kMaxBins];
    std::int32_t used;
};

struct Split {
    std::int32_t axis;  // -1 when all refs lie in one bin
    std::int32_t bin;   // this bin and those above go right
    float cost;         // half areas times counts
    std::uint32_t left_count, right_count;
    GrowingBox left, right;
};

// Boxes and costs of all subsets of up to kFewRefs refs; bit i of an index is ref i.
struct Subsets {
    GrowingBox boxes[1 << kFewRefs];
    float costs[1 << kFewRefs];
};

// Slabs between planes at origin + k * width; what lies outside counts as in the nearest slab.
struct SlabGrid {
    float origin[4];
    float scale[4];  // 0 where there is nothing to cut
    float width[4];
    std::int32_t count;
};

struct MeshArrays {
    const float* positions;  // three a vertex
    const std::uint32_t* triangles;
};

// What a binary subtree costs when it may take up to i + 1 lanes of the wide node above it: the surfaces of all wide nodes
// and leaves in it, in shares of the root's and times what they cost (infinite where it can not take as many), and how many
// nodes they are.
struct LaneCosts {
    float area[kWidth];
    std::uint32_t nodes[kWidth];
    std::int32_t lanes;  // more than its binary leaves it can not take
};

// At most kWidth of a tree's items, which name triangles.
struct LeafItems {
    const std::uint32_t* items;  // of the tree
    std::uint32_t size;          // so many
    std::uint32_t first, count;
};

// The corners of a leaf's triangles, each once, in the order they come; `halves` as a block has them. More than
// kMaxCorners are too many for a leaf, and what the half words then say means nothing.
inline constexpr std::uint32_t kMostOfLeaf = 3 * kWidth;
struct SharedCorners {
    std::uint32_t vertices[kMostOfLeaf];
    std::uint16_t halves[kWidth];
    std::uint32_t count;
};

struct BuildKernels {
    void (*clear)(Bins& bins, std::int32_t used);
    void (*bin)(const BuildRef* refs, std::uint64_t n, const BinGrid& grid, Bins& bins);
    // The cheapest border between bins with something on both sides.
    void (*best_split)(const Bins& bins, Split& split);
    // Brings what goes left to the front; how many.
    std::uint64_t (*partition)(BuildRef* refs, std::uint64_t n, const BinGrid& grid, std::int32_t axis,
                               std::int32_t bin);
    // Grows `boxes` by the refs and `centres` by their doubled centres.
    void (*measure)(const BuildRef* refs, std::uint64_t n, GrowingBox& boxes, GrowingBox& centres);
    void (*measure_subsets)(const BuildRef* refs, std::uint32_t n, Subsets& subsets);
    // Cuts triangles (a ref's item) at every plane; rounded to nearest, good for choosing a plane and no more.
    void (*bin_pieces)(const BuildRef* refs, std::uint64_t n, const MeshArrays& mesh, const SlabGrid& grid,
                       Bins& bins);
    void (*best_plane)(const Bins& bins, Split& split);
    // How two or more lanes are best shared by two subtrees: lefts[i] of i + 1 go to the left one; 0 where one lane less is as
    // good. Of one lane nothing is told.
    void (*share_lanes)(const LaneCosts& left, const LaneCosts& right, LaneCosts& both,
                        std::uint8_t (&lefts)[kWidth]);
    // Orders children by surface an item below and writes their boxes into a node's lanes.
    void (*fill_boxes)(const BinaryNode* (&children)[kWidth], WideNode& node);
    // What the triangles of a leaf share: corners are one where they are one vertex, or else where they lie at one place,
    // to the bit.
    void (*share_corners)(const LeafItems& leaf, const MeshArrays& mesh, bool by_vertex,
                          SharedCorners& shared);
    // Brings the corners of a leaf that knows its vertices to where these are; the box of the triangles that
    // triangle_check.h finds no fault with, and with their slack. The others can not be met.
    void (*fit_block)(float* block, std::uint32_t corners, const float* positions, GrowingBox& box,
                      GrowingBox& with_slack);
    // Boxes with slack around those of the triangles [first, end) that triangle_check.h finds no fault with, in order; how
    // many. Grows `bounds` by the triangles themselves. There are so many `vertices`.
    std::uint64_t (*box_triangles)(const MeshArrays& mesh, std::uint64_t vertices, std::uint64_t first,
                                   std::uint64_t end, BuildRef* refs, GrowingBox& bounds);
    // The box of what `node`'s lanes hold, and their half areas.
    void (*measure_lanes)(const WideNode& node, GrowingBox& box, float (&half_areas)[kWidth]);
};

extern const BuildKernels kScalarBuildKernels;
extern const BuildKernels kAvx2BuildKernels;

}  // namespace kernel
}  // namespace rc
