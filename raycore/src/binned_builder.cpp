#include "binned_builder.h"

#include "dispatch.h"
#include "kernels/kernel_abi.h"
#include "node_pool.h"
#include "tree_math.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <bit>
#include <vector>

namespace rc {

namespace {

using kernel::BinGrid;
using kernel::Bins;
using kernel::Split;

constexpr std::size_t kParallelSubtree = 4096;  // below it a task costs more than it gains
constexpr std::size_t kParallelRange = 65536;   // above it several threads bin and partition one range
constexpr std::size_t kBlock = 16384;           // what they take at a time, however many there are

// Refs that share a subtree.
struct Range {
    std::size_t begin, end;
    GrowingBox boxes;
    GrowingBox centres;  // holds every doubled centre; not always tight

    [[nodiscard]] std::size_t size() const { return end - begin; }
};

class Builder {
  public:
    Builder(std::span<BuildRef> refs, const SplitCosts& costs)
        : refs_(refs.data()), costs_(costs), pool_(refs.size()), kernels_(active_build_kernels()) {}

    BinaryTree run(const Range& whole) {
        build(whole, 0, 0, nullptr);
        return pool_.release();
    }

  private:
    void build(const Range& range, std::uint32_t at, int depth, build::PairSupply* supply) {
        const std::size_t n = range.size();
        BinaryNode& node = pool_[at];
        build::set_box(node, range.boxes);
        node.first = static_cast<std::uint32_t>(range.begin);
        node.count = static_cast<std::uint32_t>(n);
        Range left, right;
        if (n == 1 || !cut(range, depth, left, right)) return;

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

    // False when `range` had better be a leaf.
    bool cut(const Range& range, int depth, Range& left, Range& right) {
        const std::size_t n = range.size();
        const bool has_depth = depth + kernel::kFewRefs <= kernel::kMaxDepth;
        if (n <= kernel::kFewRefs && has_depth) return cut_few(range, left, right);
        BinGrid grid = build::grid_over(range.centres, n);
        Split split = best_split(range, grid);
        if (split.axis < 0) {  // all in one bin: look again, with a sharper eye
            grid = build::grid_over(measured(range.begin, range.end).centres, n);
            split = best_split(range, grid);
        }
        if (n <= costs_.max_leaf && !pays(range, split.cost)) return false;
        const std::size_t middle = split.axis < 0 ? range.begin : partition(range, grid, split);
        const std::size_t larger = std::max(middle - range.begin, range.end - middle);
        if (larger == n || depth + 1 + build::ceil_log2(larger) > kernel::kMaxDepth) {
            halve(range, left, right);
            return true;
        }
        left = {range.begin, middle, split.left, build::centres_within(range.centres, split.left)};
        right = {middle, range.end, split.right, build::centres_within(range.centres, split.right)};
        const int a = split.axis;
        const float border = grid.origin[a] + float(split.bin) / grid.scale[a];  // its bin's lower end
        left.centres.max[a] = std::min(left.centres.max[a], border);
        right.centres.neg_min[a] = std::min(right.centres.neg_min[a], -border);
        return true;
    }

    [[nodiscard]] bool pays(const Range& range, float split_cost) const {
        const float area = build::half_area(range.boxes);
        const float as_leaf = area * (costs_.leaf + costs_.item * float(range.size()));
        return area * (costs_.step + costs_.leaf) + costs_.item * split_cost < as_leaf;
    }

    // The best of all ways to part two to four refs.
    bool cut_few(const Range& range, Range& left, Range& right) {
        BuildRef* refs = refs_ + range.begin;
        const auto n = static_cast<std::uint32_t>(range.size());
        const std::uint32_t all = (1u << n) - 1;
        kernel::Subsets of;
        kernels_.measure_subsets(refs, n, of);
        std::uint32_t best = 1;
        for (std::uint32_t set = 2; set <= all / 2; ++set)  // those without the last ref: each way once
            if (of.costs[set] + of.costs[all ^ set] < of.costs[best] + of.costs[all ^ best]) best = set;
        if (n <= costs_.max_leaf && !pays(range, of.costs[best] + of.costs[all ^ best])) return false;
        BuildRef sorted[kernel::kFewRefs];
        std::size_t count = 0;
        for (const std::uint32_t side : {best, all ^ best})
            for (std::uint32_t set = side; set != 0; set &= set - 1)
                sorted[count++] = refs[std::countr_zero(set)];
        std::copy_n(sorted, n, refs);
        const std::size_t middle = range.begin + static_cast<std::size_t>(std::popcount(best));
        left = {range.begin, middle, of.boxes[best], {}};
        right = {middle, range.end, of.boxes[all ^ best], {}};
        return true;
    }

    [[nodiscard]] Split best_split(const Range& range, const BinGrid& grid) const {
        Bins bins;
        if (range.size() < kParallelRange) {
            kernels_.clear(bins, grid.count);
            kernels_.bin(refs_ + range.begin, range.size(), grid, bins);
        } else {
            kernels_.clear(bins, grid.count);
            bins = tbb::parallel_reduce(
                tbb::blocked_range<std::size_t>(range.begin, range.end, kBlock), bins,
                [&](const auto& part, Bins sum) {
                    kernels_.bin(refs_ + part.begin(), part.size(), grid, sum);
                    return sum;
                },
                [](Bins a, const Bins& b) {
                    build::grow(a, b);
                    return a;
                });
        }
        Split split;
        kernels_.best_split(bins, split);
        return split;
    }

    // Brings what goes left to the front; where the others begin.
    std::size_t partition(const Range& range, const BinGrid& grid, const Split& split) {
        const auto sort = [&](std::size_t begin, std::size_t end) {
            return begin + kernels_.partition(refs_ + begin, end - begin, grid, split.axis, split.bin);
        };
        if (range.size() < kParallelRange) return sort(range.begin, range.end);

        std::vector<Run> lefts((range.size() + kBlock - 1) / kBlock), rights(lefts.size());
        tbb::parallel_for(std::size_t{0}, lefts.size(), [&](std::size_t b) {
            const std::size_t begin = range.begin + b * kBlock, end = std::min(begin + kBlock, range.end);
            const std::size_t middle = sort(begin, end);
            lefts[b] = {begin, middle};
            rights[b] = {middle, end};
        });
        std::size_t middle = range.begin;
        for (const Run& run : lefts) middle += run.end - run.begin;
        trade(lefts, rights, middle);
        return middle;
    }

    struct Run {
        std::size_t begin, end;
    };

    // Runs of lefts behind `middle` change places with runs of rights before it, a piece at a time, in order.
    void trade(std::vector<Run>& lefts, std::vector<Run>& rights, std::size_t middle) {
        struct Piece {
            std::size_t left, right, count;
        };
        std::vector<Piece> pieces;
        for (Run& run : lefts) run.begin = std::max(run.begin, middle);
        for (Run& run : rights) run.end = std::min(run.end, middle);
        for (std::size_t l = 0, r = 0; l < lefts.size() && r < rights.size();) {
            Run &left = lefts[l], &right = rights[r];
            if (left.begin >= left.end) {
                ++l;
            } else if (right.begin >= right.end) {
                ++r;
            } else {
                const std::size_t count = std::min(left.end - left.begin, right.end - right.begin);
                pieces.push_back({left.begin, right.begin, count});
                left.begin += count;
                right.begin += count;
            }
        }
        tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t p) {
            const auto& [left, right, count] = pieces[p];
            std::swap_ranges(refs_ + left, refs_ + left + count, refs_ + right);
        });
    }

    // By count, along the widest axis; a total order, so that equal centres still have one answer.
    void halve(const Range& range, Range& left, Range& right) {
        const int axis = build::widest_axis(measured(range.begin, range.end).centres);
        const std::size_t middle = range.begin + range.size() / 2;
        std::nth_element(refs_ + range.begin, refs_ + middle, refs_ + range.end,
                         [&](const BuildRef& a, const BuildRef& b) {
                             const float ca = build::centre(a, axis), cb = build::centre(b, axis);
                             return ca != cb ? ca < cb : a.item < b.item;
                         });
        left = measured(range.begin, middle);
        right = measured(middle, range.end);
    }

    [[nodiscard]] Range measured(std::size_t begin, std::size_t end) const {
        Range range{begin, end, build::kNoBox, build::kNoBox};
        kernels_.measure(refs_ + begin, end - begin, range.boxes, range.centres);
        return range;
    }

    BuildRef* refs_;
    SplitCosts costs_;
    build::NodePool pool_;
    const kernel::BuildKernels& kernels_;
};

// Minima and maxima come out the same however the refs are cut.
Range whole(std::span<const BuildRef> refs) {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, refs.size(), kBlock),
        Range{0, refs.size(), build::kNoBox, build::kNoBox},
        [&](const auto& part, Range sum) {
            active_build_kernels().measure(&refs[part.begin()], part.size(), sum.boxes, sum.centres);
            return sum;
        },
        [](Range a, const Range& b) {
            build::grow(a.boxes, b.boxes);
            build::grow(a.centres, b.centres);
            return a;
        });
}

}  // namespace

BinaryTree build_binary_tree(std::span<BuildRef> refs, const SplitCosts& costs) {
    return Builder(refs, costs).run(whole(refs));
}

}  // namespace rc
