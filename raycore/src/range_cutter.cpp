#include "range_cutter.h"

#include "dispatch.h"
#include "kernels/kernel_abi.h"
#include "parallel.h"

#include <algorithm>
#include <bit>
#include <vector>

namespace rc::build {

namespace {

constexpr std::size_t kParallelRange = 65536;  // above it several threads bin and partition one range
constexpr std::size_t kRefsAtATime = 16384;    // what they take at a time, however many there are

}  // namespace

RangeCutter::RangeCutter(std::span<BuildRef> refs, const SplitCosts& costs)
    : refs_(refs.data()), costs_(costs), kernels_(active_build_kernels()) {}

Range RangeCutter::whole(std::size_t n) {
    const Range all = sum_in_parallel(
        BlockedRange(0, n, kRefsAtATime), Range{0, n, kNoBox, kNoBox},
        [&](const auto& part, Range sum) {
            kernels_.measure(refs_ + part.begin(), part.size(), sum.boxes, sum.centres);
            return sum;
        },
        [](Range a, const Range& b) {
            grow(a.boxes, b.boxes);
            grow(a.centres, b.centres);
            return a;
        });
    large_area_ = costs_.large * half_area(all.boxes);
    return all;
}

void RangeCutter::measure(std::size_t begin, std::size_t end, Range& range) const {
    range = {begin, end, kNoBox, kNoBox};
    kernels_.measure(refs_ + begin, end - begin, range.boxes, range.centres);
}

Range RangeCutter::measured(std::size_t begin, std::size_t end) const {
    Range range;
    measure(begin, end, range);
    return range;
}

bool RangeCutter::cut(const Range& range, int depth, Range& left, Range& right) {
    if (range.size() <= kernel::kFewRefs && leaves_depth_for_few(depth)) return cut_few(range, left, right);
    const ObjectSplit split = object_split(range);
    if (!pays(range, split.best.cost)) return false;
    if (split.best.axis >= 0) {
        cut_at(split, range, left, right);
        if (leaves_depth(depth, left.size(), right.size())) return true;
    }
    halve(range, left, right);
    return true;
}

bool RangeCutter::pays(const Range& range, float split_cost) const {
    if (range.size() > costs_.max_leaf) return true;
    const float area = half_area(range.boxes);
    const float as_leaf = area * (costs_.leaf + costs_.item * float(range.size()));
    const float step = area > large_area_ ? costs_.step_if_large : costs_.step;
    return area * (step + costs_.leaf) + costs_.item * split_cost < as_leaf;
}

kernel::Split RangeCutter::best_split(const Range& range, const kernel::BinGrid& grid) const {
    kernel::Bins bins;
    kernels_.clear(bins, grid.count);
    if (range.size() < kParallelRange) {
        kernels_.bin(refs_ + range.begin, range.size(), grid, bins);
    } else {
        bins = sum_in_parallel(
            BlockedRange(range.begin, range.end, kRefsAtATime), bins,
            [&](const auto& part, kernel::Bins sum) {
                kernels_.bin(refs_ + part.begin(), part.size(), grid, sum);
                return sum;
            },
            [](kernel::Bins a, const kernel::Bins& b) {
                grow(a, b);
                return a;
            });
    }
    kernel::Split split;
    kernels_.best_split(bins, split);
    return split;
}

ObjectSplit RangeCutter::object_split(const Range& range) const {
    ObjectSplit split;
    split.grid = grid_over(range.centres, range.size());
    split.best = best_split(range, split.grid);
    if (split.best.axis < 0) {  // all in one bin: look again, with a sharper eye
        split.grid = grid_over(measured(range.begin, range.end).centres, range.size());
        split.best = best_split(range, split.grid);
    }
    return split;
}

void RangeCutter::cut_at(const ObjectSplit& split, const Range& range, Range& left, Range& right) {
    const std::size_t middle = partition(range, split);
    const kernel::Split& best = split.best;
    left = {range.begin, middle, best.left, centres_within(range.centres, best.left)};
    right = {middle, range.end, best.right, centres_within(range.centres, best.right)};
    const int a = best.axis;
    const float border = split.grid.origin[a] + float(best.bin) / split.grid.scale[a];  // its bin's lower end
    left.centres.max[a] = std::min(left.centres.max[a], border);
    right.centres.neg_min[a] = std::min(right.centres.neg_min[a], -border);
}

bool RangeCutter::cut_few(const Range& range, Range& left, Range& right) {
    BuildRef* refs = refs_ + range.begin;
    const auto n = static_cast<std::uint32_t>(range.size());
    const std::uint32_t all = (1u << n) - 1;
    kernel::Subsets of;
    kernels_.measure_subsets(refs, n, of);
    std::uint32_t best = 1;
    for (std::uint32_t set = 2; set <= all / 2; ++set)  // those without the last ref: each way once
        if (of.costs[set] + of.costs[all ^ set] < of.costs[best] + of.costs[all ^ best]) best = set;
    if (!pays(range, of.costs[best] + of.costs[all ^ best])) return false;
    BuildRef sorted[kernel::kFewRefs];
    std::size_t count = 0;
    for (const std::uint32_t side : {best, all ^ best})
        for (std::uint32_t set = side; set != 0; set &= set - 1)
            sorted[count++] = refs[std::countr_zero(set)];
    std::copy_n(sorted, n, refs);
    const std::size_t middle = range.begin + static_cast<std::size_t>(std::popcount(best));
    left = {range.begin, middle, of.boxes[best], kNoBox};
    right = {middle, range.end, of.boxes[all ^ best], kNoBox};
    return true;
}

// Brings what goes left to the front; where the others begin.
std::size_t RangeCutter::partition(const Range& range, const ObjectSplit& split) {
    const auto sort = [&](std::size_t begin, std::size_t end) {
        return begin +
               kernels_.partition(refs_ + begin, end - begin, split.grid, split.best.axis, split.best.bin);
    };
    if (range.size() < kParallelRange) return sort(range.begin, range.end);

    std::vector<Run> lefts((range.size() + kRefsAtATime - 1) / kRefsAtATime), rights(lefts.size());
    for_in_parallel(lefts.size(), [&](std::size_t b) {
        const std::size_t begin = range.begin + b * kRefsAtATime,
                          end = std::min(begin + kRefsAtATime, range.end);
        const std::size_t middle = sort(begin, end);
        lefts[b] = {begin, middle};
        rights[b] = {middle, end};
    });
    std::size_t middle = range.begin;
    for (const Run& run : lefts) middle += run.end - run.begin;
    trade(lefts, rights, middle);
    return middle;
}

// Runs of lefts behind `middle` change places with runs of rights before it, a piece at a time, in order.
void RangeCutter::trade(std::span<Run> lefts, std::span<Run> rights, std::size_t middle) {
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
    for_in_parallel(pieces.size(), [&](std::size_t p) {
        const auto& [left, right, count] = pieces[p];
        std::swap_ranges(refs_ + left, refs_ + left + count, refs_ + right);
    });
}

// A total order, so that equal centres still have one answer.
void RangeCutter::halve(const Range& range, Range& left, Range& right) {
    const int axis = widest_axis(measured(range.begin, range.end).centres);
    const std::size_t middle = range.begin + range.size() / 2;
    std::nth_element(refs_ + range.begin, refs_ + middle, refs_ + range.end,
                     [&](const BuildRef& a, const BuildRef& b) {
                         const float ca = centre(a, axis), cb = centre(b, axis);
                         return ca != cb ? ca < cb : a.item < b.item;
                     });
    left = measured(range.begin, middle);
    right = measured(middle, range.end);
}

bool RangeCutter::leaves_depth(int depth, std::size_t left, std::size_t right) {
    return left > 0 && right > 0 && depth + 1 + ceil_log2(std::max(left, right)) <= kernel::kMaxDepth;
}

bool RangeCutter::leaves_depth_for_few(int depth) {
    return depth + kernel::kFewRefs <= kernel::kMaxDepth;
}

}  // namespace rc::build
