#include "morton_builder.h"

#include "kernels/kernel_abi.h"
#include "node_pool.h"
#include "parallel.h"
#include "radix_sort.h"
#include "range_cutter.h"

#include <algorithm>
#include <bit>

namespace rc {

namespace {

using build::Range;

constexpr std::size_t kParallelSubtree = 4096;
constexpr std::size_t kCodesAtATime = 16384;
constexpr std::size_t kCutByCost = kernel::kFewRefs;  // ranges of so few refs; larger ones follow the curve
constexpr int kBitsOfIndex = 28;                      // kMaxTriangles needs no more
constexpr int kBitsOfAxis = 12;

// The bits of x, two free ones behind each.
std::uint64_t spread(std::uint32_t x) {
    std::uint64_t bits = x;
    bits = (bits | bits << 16) & 0x0000FF0000FFu;
    bits = (bits | bits << 8) & 0x00F00F00F00Fu;
    bits = (bits | bits << 4) & 0x0C30C30C30C3u;
    return (bits | bits << 2) & 0x249249249249u;
}

class MortonBuilder {
  public:
    MortonBuilder(std::span<BuildRef> refs, const SplitCosts& costs)
        : refs_(refs.size()),
          keys_(refs.size()),
          items_(refs.size()),
          cutter_(refs_, costs),
          pool_(refs.size()) {
        sort(refs);
    }

    BinaryTree run() {
        build(0, refs_.size(), 0, 0, nullptr);
        return pool_.release(std::move(items_));
    }

  private:
    template <class Body>
    static void for_blocks(std::size_t n, const Body& body) {
        for_in_parallel(BlockedRange(0, n, kCodesAtATime), [&](const auto& block) {
            for (std::size_t i = block.begin(); i < block.end(); ++i) body(i);
        });
    }

    void sort(std::span<BuildRef> refs) {
        build::RangeCutter unsorted(refs, {});
        const kernel::BinGrid grid = code_grid(unsorted.whole(refs.size()).centres);
        for_blocks(refs.size(), [&](std::size_t i) {
            std::uint64_t code = 0;
            for (int a = 0; a < 3; ++a) {
                const float at = (build::centre(refs[i], a) - grid.origin[a]) * grid.scale[a];
                const float last = float(grid.count - 1);
                code |= spread(static_cast<std::uint32_t>(std::max(0.0f, std::min(at, last)))) << a;
            }
            keys_[i] = code << kBitsOfIndex | i;
        });
        Unfilled<std::uint64_t> spare(keys_.size());
        build::radix_sort(keys_, spare, kBitsOfIndex, 3 * kBitsOfAxis / 12);
        for_blocks(refs.size(), [&](std::size_t i) {
            refs_[i] = refs[keys_[i] & ((std::uint64_t{1} << kBitsOfIndex) - 1)];
        });
    }

    // As many cells an axis as the code has bits for, cubes by the widest axis: the curve is to be fair to all three.
    static kernel::BinGrid code_grid(const GrowingBox& centres) {
        kernel::BinGrid grid{};
        grid.count = 1 << kBitsOfAxis;
        const int widest = build::widest_axis(centres);
        const float scale = float(grid.count) * 0.9999f / (centres.max[widest] + centres.neg_min[widest]);
        for (int a = 0; a < 3; ++a) {
            grid.origin[a] = 0.0f - centres.neg_min[a];
            grid.scale[a] = scale < build::kHuge ? scale : 0.0f;
        }
        return grid;
    }

    [[nodiscard]] std::uint64_t code(std::size_t i) const { return keys_[i] >> kBitsOfIndex; }

    // Where the highest bit in which codes of the range differ turns from 0 to 1; `begin` when none differs.
    [[nodiscard]] std::size_t border(std::size_t begin, std::size_t end) const {
        const std::uint64_t difference = code(begin) ^ code(end - 1);
        if (difference == 0) return begin;
        const std::uint64_t bit = std::bit_floor(difference) << kBitsOfIndex;
        const auto at = std::partition_point(keys_.begin() + static_cast<std::ptrdiff_t>(begin),
                                             keys_.begin() + static_cast<std::ptrdiff_t>(end),
                                             [&](std::uint64_t key) { return (key & bit) == 0; });
        return static_cast<std::size_t>(at - keys_.begin());
    }

    GrowingBox build(std::size_t begin, std::size_t end, std::uint32_t at, int depth,
                     build::PairSupply* supply) {
        const std::size_t n = end - begin, middle = n > kCutByCost ? border(begin, end) : begin;
        if (n >= kParallelSubtree && middle != begin) return branch(begin, middle, end, at, depth);
        build::PairSupply own(pool_, n);
        build::PairSupply& pairs = supply != nullptr ? *supply : own;
        if (!build::RangeCutter::leaves_depth(depth, middle - begin, end - middle)) {
            const Range range = cutter_.measured(begin, end);
            cut_by_cost(range, at, depth, pairs);
            return range.boxes;
        }
        BinaryNode& node = pool_[at];
        node.count = BinaryNode::kInner | static_cast<std::uint32_t>(n);
        node.first = pairs.take();
        GrowingBox box = build(begin, middle, node.first, depth + 1, &pairs);
        build::grow(box, build(middle, end, node.first + 1, depth + 1, &pairs));
        build::set_box(node, box);
        return box;
    }

    GrowingBox branch(std::size_t begin, std::size_t middle, std::size_t end, std::uint32_t at, int depth) {
        BinaryNode& node = pool_[at];
        node.count = BinaryNode::kInner | static_cast<std::uint32_t>(end - begin);
        node.first = pool_.take_pairs(1);
        GrowingBox left, right;
        both_in_parallel([&] { left = build(begin, middle, node.first, depth + 1, nullptr); },
                         [&] { right = build(middle, end, node.first + 1, depth + 1, nullptr); });
        build::grow(left, right);
        build::set_box(node, left);
        return left;
    }

    void cut_by_cost(const Range& range, std::uint32_t at, int depth, build::PairSupply& pairs) {
        BinaryNode& node = pool_[at];
        build::set_box(node, range.boxes);
        node.first = static_cast<std::uint32_t>(range.begin);
        node.count = static_cast<std::uint32_t>(range.size());
        Range left, right;
        if (range.size() == 1 || !cutter_.cut(range, depth, left, right)) {
            for (std::size_t i = range.begin; i < range.end; ++i) items_[i] = refs_[i].item;
            return;
        }
        node.count |= BinaryNode::kInner;
        node.first = pairs.take();
        cut_by_cost(left, node.first, depth + 1, pairs);
        cut_by_cost(right, node.first + 1, depth + 1, pairs);
    }

    Unfilled<BuildRef> refs_;       // in the order of keys_
    Unfilled<std::uint64_t> keys_;  // code, and the place it had before sorting
    Unfilled<std::uint32_t> items_;
    build::RangeCutter cutter_;
    build::NodePool pool_;
};

}  // namespace

BinaryTree build_morton_tree(std::span<BuildRef> refs, const SplitCosts& costs) {
    return MortonBuilder(refs, costs).run();
}

}  // namespace rc
