// reinsert.h - makes a binary tree cheaper: takes its largest subtrees out, one after the other, and puts each back where the
// tree's surface grows least (Bittner, Hapala, Havran 2013). Places are looked for side by side and without taking anything
// out first (Meister, Bittner 2018).
//
// A builder that cuts from the top decides for the largest boxes first, when it knows least. What it decided wrongly there
// is met by most rays, and a few hundred moves mend most of it.
//
// Cost      as many searches as nodes are asked for, some twenty boxes each; a few hundredths of the build.
// Same bits one tree per input, whatever the thread count: searches only look; what they found is searched for once more and
//           moved one by one, in an order that does not depend on where nodes lie.
// Depth     never more than kernel::kMaxDepth: a move that would make the tree deeper is not made.
#pragma once

#include "binned_builder.h"

namespace rc {

// `tree.heights` tells every node's. Boxes above what was moved become those of their children.
void reinsert(BinaryTree& tree);

}  // namespace rc
