// morton_builder.h - a binary tree in the order of a space-filling curve (Lauterbach 2009): for rebuilding every tick.
//
// The upper levels part refs where the codes of their centres, twelve bits an axis, first differ; ranges of few refs,
// and those whose centres share one cell, are cut by the surface-area heuristic.
//
// Cost      O(n): a radix sort, then one pass. A build takes two thirds of the default one, rays cost 4 to 10 percent more.
// Same bits one tree per input, whatever the thread count: the sort is stable and its blocks have a fixed size.
// Depth     as binned_builder.h: 36 levels of codes, and the refs that share one can be halved in the 28 that are left.
#pragma once

#include "binned_builder.h"

namespace rc {

// `refs` are reordered; not empty.
[[nodiscard]] BinaryTree build_morton_tree(std::span<BuildRef> refs, const SplitCosts& costs);

}  // namespace rc
