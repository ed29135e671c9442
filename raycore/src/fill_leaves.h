// fill_leaves.h - the leaves' blocks, from a tree and the items its leaves name.
#pragma once

#include "data.h"

#include "raycore/mesh.h"

#include <cstdint>
#include <span>

namespace rc {

// Gives every leaf its block and every primitive its leaf, by several threads. Of `blas`, the tree must stand, its leaves
// being ranges of items (collapse.h), and leaf_of_primitive be kNone throughout; every item must be a triangle of `mesh`
// without fault. False where a leaf has more corners than a block holds, or the blocks more words than a leaf's name.
[[nodiscard]] bool fill_leaves(Blas::Data& blas, std::span<const std::uint32_t> items, const MeshView& mesh);

}  // namespace rc
