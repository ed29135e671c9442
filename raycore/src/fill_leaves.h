// fill_leaves.h - the leaves' blocks, from a tree and the items its leaves name.
#pragma once

#include "data.h"

#include "raycore/mesh.h"

#include <cstdint>
#include <span>

namespace rc {

// Gives every block its triangles and every primitive its leaf, by several threads. Of `blas`, the tree must stand
// and leaf_of_primitive be kNone throughout; every item must be a triangle of `mesh` without fault.
void fill_leaves(Blas::Data& blas, std::span<const std::uint32_t> items, const MeshView& mesh);

}  // namespace rc
