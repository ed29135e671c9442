// spatial_builder.h - a binary tree by the surface-area heuristic that may cut triangles as well as sets of them.
//
// Where the best parting of whole triangles leaves two boxes that overlap, a plane is tried: triangles it passes through
// go to both sides, each side's box holding its piece only (Stich, Friedrich, Dietrich 2009). Long thin triangles gain
// most. A piece names the whole triangle, so no answer changes: a triangle met twice is met at the same t.
//
// Cost      about half as much again as the default builder's; at most kMostPieces refs for every triangle.
// Same bits one tree per input, whatever the thread count: room for pieces is dealt out by the sizes of subtrees.
// Depth     as binned_builder.h, counting pieces.
#pragma once

#include "binned_builder.h"

#include "raycore/mesh.h"

#include <algorithm>
#include <cstddef>

namespace rc {

inline constexpr double kMostPieces = 1.3;  // refs a triangle, over the whole tree

// No more than a mesh may have triangles: so many lie within reach of a leaf's name, each in a leaf of its own.
[[nodiscard]] inline std::size_t most_pieces_of(std::size_t triangles) {
    const auto pieces = static_cast<std::size_t>(kMostPieces * double(triangles));
    return std::max(triangles, std::min(pieces, kMaxTriangles));
}

// `refs` become the tree's; not empty. Room for most_pieces_of them that was reserved before saves moving them.
[[nodiscard]] BinaryTree build_spatial_tree(Unfilled<BuildRef> refs, const MeshView& mesh,
                                            const SplitCosts& costs);

}  // namespace rc
