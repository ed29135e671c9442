#include "binned_builder.h"

#include "top_down_builder.h"

namespace rc {

namespace {

using build::Plot;

class Builder {
  public:
    Builder(std::span<BuildRef> refs, const SplitCosts& costs)
        : refs_(refs), cutter_(refs, costs), pool_(refs.size()), items_(refs.size()) {}

    BinaryTree run() {
        const auto cut = [this](const Plot& plot, int depth, Plot& left, Plot& right) {
            return cut_or_settle(plot, depth, left, right);
        };
        build::Growth(pool_, cut).grow({cutter_.whole(refs_.size()), refs_.size()});
        return pool_.release(std::move(items_));
    }

  private:
    bool cut_or_settle(const Plot& plot, int depth, Plot& left, Plot& right) {
        const build::Range& range = plot.range;
        if (range.size() > 1 && cutter_.cut(range, depth, left.range, right.range)) {
            left.limit = left.range.end;
            right.limit = right.range.end;
            return true;
        }
        for (std::size_t i = range.begin; i < range.end; ++i) items_[i] = refs_[i].item;
        return false;
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
