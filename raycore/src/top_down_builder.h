// top_down_builder.h - the loop that builders which cut from the top have in common: a range becomes a leaf or is cut in two,
// and its halves are grown side by side while they are large.
//
// Same bits a node's place depends on the thread that made it, but nobody looks at places: collapse.h follows children.
#pragma once

#include "node_pool.h"
#include "parallel.h"
#include "range_cutter.h"

namespace rc::build {

// Refs, and the room behind them that pieces of them may take: [range.end, limit).
struct Plot {
    Range range;
    std::size_t limit;
};

// `cut(plot, depth, left, right)` is false when the plot had better be a leaf, which keeps the place of its refs.
template <class Cut>
class Growth {
  public:
    Growth(NodePool& pool, const Cut& cut) : pool_(pool), cut_(cut) {}

    void grow(const Plot& plot) { grow(plot, 0, 0, nullptr); }

  private:
    static constexpr std::size_t kParallelSubtree = 4096;  // below it a task costs more than it gains

    void grow(const Plot& plot, std::uint32_t at, int depth, PairSupply* supply) {
        pool_.height_of(at) = 0;
        const std::size_t n = plot.range.size();
        BinaryNode& node = pool_[at];
        set_box(node, plot.range.boxes);
        node.first = static_cast<std::uint32_t>(plot.range.begin);
        node.count = static_cast<std::uint32_t>(n);
        Plot left, right;
        if (!cut_(plot, depth, left, right)) return;

        if (supply != nullptr || n < kParallelSubtree) {
            PairSupply own(pool_, plot.limit - plot.range.begin);
            PairSupply& pairs = supply != nullptr ? *supply : own;
            node.first = pairs.take();
            grow(left, node.first, depth + 1, &pairs);
            grow(right, node.first + 1, depth + 1, &pairs);
        } else {
            node.first = pool_.take_pairs(1);
            both_in_parallel([&] { grow(left, node.first, depth + 1, nullptr); },
                             [&] { grow(right, node.first + 1, depth + 1, nullptr); });
        }
        // Pieces count as well, which were not there yet when the plot was.
        node.count = BinaryNode::kInner | (pool_[node.first].size() + pool_[node.first + 1].size());
        const std::uint8_t below = std::max(pool_.height_of(node.first), pool_.height_of(node.first + 1));
        pool_.height_of(at) = static_cast<std::uint8_t>(1 + below);
    }

    NodePool& pool_;
    const Cut& cut_;
};

}  // namespace rc::build
