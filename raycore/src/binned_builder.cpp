#include "binned_builder.h"

#include "kernels/kernel_abi.h"
#include "node_pool.h"
#include "range_cutter.h"

#include <tbb/task_group.h>

namespace rc {

namespace {

using build::Range;

constexpr std::size_t kParallelSubtree = 4096;  // below it a task costs more than it gains

class Builder {
  public:
    Builder(std::span<BuildRef> refs, const SplitCosts& costs)
        : refs_(refs), cutter_(refs, costs), pool_(refs.size()), items_(refs.size()) {}

    BinaryTree run() {
        build(cutter_.whole(refs_.size()), 0, 0, nullptr);
        return pool_.release(std::move(items_));
    }

  private:
    void build(const Range& range, std::uint32_t at, int depth, build::PairSupply* supply) {
        const std::size_t n = range.size();
        BinaryNode& node = pool_[at];
        build::set_box(node, range.boxes);
        node.first = static_cast<std::uint32_t>(range.begin);
        node.count = static_cast<std::uint32_t>(n);
        Range left, right;
        if (n == 1 || !cutter_.cut(range, depth, left, right)) {
            for (std::size_t i = range.begin; i < range.end; ++i) items_[i] = refs_[i].item;
            return;
        }
        node.count |= BinaryNode::kInner;
        if (supply != nullptr || n < kParallelSubtree) {
            build::PairSupply own(pool_, n);
            build::PairSupply& pairs = supply != nullptr ? *supply : own;
            node.first = pairs.take();
            build(left, node.first, depth + 1, &pairs);
            build(right, node.first + 1, depth + 1, &pairs);
            return;
        }
        node.first = pool_.take_pairs(1);
        tbb::task_group group;
        group.run([&] { build(left, node.first, depth + 1, nullptr); });
        build(right, node.first + 1, depth + 1, nullptr);
        group.wait();
    }

    std::span<BuildRef> refs_;
    build::RangeCutter cutter_;
    build::NodePool pool_;
    Unfilled<std::uint32_t> items_;
};

}  // namespace

BinaryTree build_binary_tree(std::span<BuildRef> refs, const SplitCosts& costs) {
    return Builder(refs, costs).run();
}

}  // namespace rc
