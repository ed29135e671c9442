// range_cutter.h - how builders by the surface-area heuristic cut a range of refs in two, in place.
//
// Same bits a range is cut the same whatever the number of threads: bins hold minima, maxima and counts, which do not
//           care about order; partitioning works in blocks of fixed size.
#pragma once

#include "binned_builder.h"
#include "tree_math.h"

namespace rc::build {

// Refs that share a subtree.
struct Range {
    std::size_t begin, end;
    GrowingBox boxes;
    GrowingBox centres;  // holds every doubled centre; not always tight

    [[nodiscard]] std::size_t size() const { return end - begin; }
};

struct ObjectSplit {
    kernel::BinGrid grid;
    kernel::Split best;
};

class RangeCutter {
  public:
    RangeCutter(std::span<BuildRef> refs, const SplitCosts& costs);

    // All refs, measured by several threads: the root, whose surface tells from here on which ranges are large. (A cutter
    // that was never asked for it takes none for large.)
    [[nodiscard]] Range whole(std::size_t n);
    // Tight boxes and centres of a part.
    [[nodiscard]] Range measured(std::size_t begin, std::size_t end) const;
    // The same in place. (Where the value returned was assigned, GCC 12 under the thread sanitizer gave the temporary half
    // of its alignment in one place, spatial_builder's `part`, and AVX trapped.)
    void measure(std::size_t begin, std::size_t end, Range& range) const;

    // The best way to part `range` at `depth`; false when it had better be a leaf.
    bool cut(const Range& range, int depth, Range& left, Range& right);

    // Its steps, for builders that know more ways. Whether parting `range` at this cost (half areas times counts) beats
    // making it a leaf; always, when it can be none.
    [[nodiscard]] bool pays(const Range& range, float split_cost) const;

    // The best border between bins of centres; axis -1 when all centres are one.
    [[nodiscard]] ObjectSplit object_split(const Range& range) const;
    void cut_at(const ObjectSplit& split, const Range& range, Range& left, Range& right);

    // The best of all ways to part two to four refs; false when it does not pay.
    bool cut_few(const Range& range, Range& left, Range& right);

    // By count, along the widest axis: always possible.
    void halve(const Range& range, Range& left, Range& right);

    // Neither part would be so large that, below `depth` levels, halving could not part it within the stacks' height.
    [[nodiscard]] static bool leaves_depth(int depth, std::size_t left, std::size_t right);
    [[nodiscard]] static bool leaves_depth_for_few(int depth);

  private:
    struct Run {
        std::size_t begin, end;
    };
    [[nodiscard]] kernel::Split best_split(const Range& range, const kernel::BinGrid& grid) const;
    std::size_t partition(const Range& range, const ObjectSplit& split);
    void trade(std::span<Run> lefts, std::span<Run> rights, std::size_t middle);

    BuildRef* refs_;
    SplitCosts costs_;
    float large_area_ = kHuge;
    const kernel::BuildKernels& kernels_;
};

}  // namespace rc::build
