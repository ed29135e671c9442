#include "binned_builder.h"

#include "kernels/kernel_abi.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

namespace rc {

namespace {

constexpr int kMaxBins = 16;
constexpr std::size_t kParallelSubtree = 4096;  // below it a task costs more than it gains
constexpr std::size_t kParallelBinning = 65536;
constexpr float kHuge = std::numeric_limits<float>::max();

// Three axes and a lane that means nothing, in the compiler's own vectors: four floats are in every ISA.
typedef float Quad __attribute__((vector_size(16)));
typedef std::int32_t QuadBits __attribute__((vector_size(16)));

Quad min_of(Quad a, Quad b) {
    return a < b ? a : b;
}
Quad max_of(Quad a, Quad b) {
    return a > b ? a : b;
}
Quad quad_of(float a) {
    return Quad{a, a, a, a};
}

// The lane behind the axes holds an integer; read as a float it may be denormal, which makes arithmetic slow.
Quad load(const float* p) {
    QuadBits bits;
    std::memcpy(&bits, p, sizeof(bits));
    return reinterpret_cast<Quad>(bits & QuadBits{-1, -1, -1, 0});
}

struct Bounds {
    Quad min = quad_of(kHuge);
    Quad max = quad_of(-kHuge);

    void grow(Quad low, Quad high) {
        min = min_of(low, min);
        max = max_of(high, max);
    }
    void grow(const Bounds& other) { grow(other.min, other.max); }
};

float half_area(const Bounds& b) {
    const Quad d = b.max - b.min;
    return (d[0] * d[1] + d[1] * d[2]) + d[2] * d[0];
}

// Twice the centre: no rounding but one, and only its order matters.
Quad centre(const BuildRef& ref) {
    return load(ref.min) + load(ref.max);
}

struct RangeBounds {
    Bounds boxes;
    Bounds centres;

    void add(const BuildRef& ref) {
        const Quad low = load(ref.min), high = load(ref.max);
        boxes.grow(low, high);
        centres.grow(low + high, low + high);
    }
    void add(const RangeBounds& other) {
        boxes.grow(other.boxes);
        centres.grow(other.centres);
    }
};

// Few things need few bins: most ranges are small, and their bins are most of a build.
struct Binning {
    int count;
    Quad origin;
    Quad scale;  // 0 where all centres agree

    Binning(const Bounds& centres, std::size_t n)
        : count(static_cast<int>(std::min<std::size_t>(kMaxBins, 4 + n / 8))), origin(centres.min) {
        const Quad extent = centres.max - centres.min;
        const Quad raw = quad_of(float(count) * 0.9999f) / extent;
        scale = ((extent > quad_of(0.0f)) & (raw < quad_of(kHuge))) ? raw : quad_of(0.0f);
    }
    QuadBits bins(Quad c) const {
        const QuadBits b = __builtin_convertvector((c - origin) * scale, QuadBits);
        const QuadBits last = {count - 1, count - 1, count - 1, count - 1};
        return b < last ? b : last;
    }
};

struct Bins {
    int used = 0;
    Bounds bounds[3][kMaxBins];
    std::uint32_t count[3][kMaxBins] = {};

    void add(const BuildRef& ref, const Binning& binning) {
        const Quad low = load(ref.min), high = load(ref.max);
        const QuadBits at = binning.bins(low + high);
        used = binning.count;
        for (int a = 0; a < 3; ++a) {
            bounds[a][at[a]].grow(low, high);
            ++count[a][at[a]];
        }
    }
    void add(const Bins& other) {
        used = std::max(used, other.used);
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < kMaxBins; ++b) {
                bounds[a][b].grow(other.bounds[a][b]);
                count[a][b] += other.count[a][b];
            }
        }
    }
};

// Minima, maxima and counts come out the same however the range is cut.
template <class Sum, class Add>
Sum sum_over(std::span<const BuildRef> refs, const Add& add) {
    const auto serial = [&](std::size_t begin, std::size_t end, Sum sum) {
        for (std::size_t i = begin; i < end; ++i) add(sum, refs[i]);
        return sum;
    };
    if (refs.size() < kParallelBinning) return serial(0, refs.size(), Sum{});
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, refs.size(), kParallelBinning / 4), Sum{},
        [&](const auto& range, Sum sum) { return serial(range.begin(), range.end(), std::move(sum)); },
        [](Sum a, const Sum& b) {
            a.add(b);
            return a;
        });
}

struct Split {
    int axis = -1;
    int bin = 0;  // this bin and those above go right
    float cost = std::numeric_limits<float>::infinity();
};

Split best_split(const Bins& bins) {
    Split best;
    for (int a = 0; a < 3; ++a) {
        float right_cost[kMaxBins];
        Bounds right;
        std::uint32_t n = 0;
        for (int b = bins.used - 1; b > 0; --b) {
            right.grow(bins.bounds[a][b]);
            n += bins.count[a][b];
            right_cost[b] = n > 0 ? half_area(right) * float(n) : -1.0f;
        }
        Bounds left;
        n = 0;
        for (int b = 1; b < bins.used; ++b) {
            left.grow(bins.bounds[a][b - 1]);
            n += bins.count[a][b - 1];
            if (n == 0 || right_cost[b] < 0.0f) continue;
            const float cost = half_area(left) * float(n) + right_cost[b];
            if (cost < best.cost) best = {a, b, cost};
        }
    }
    return best;
}

int ceil_log2(std::size_t n) {
    return static_cast<int>(std::bit_width(n - 1));
}

class Builder {
  public:
    Builder(std::span<BuildRef> refs, const SplitCosts& costs, BinaryNode* nodes)
        : refs_(refs), costs_(costs), nodes_(nodes) {}

    void build(std::size_t begin, std::size_t end, std::size_t at, int depth, const RangeBounds& bounds) {
        const std::size_t n = end - begin;
        BinaryNode& node = nodes_[at];
        std::memcpy(node.min, &bounds.boxes.min, sizeof(node.min));
        std::memcpy(node.max, &bounds.boxes.max, sizeof(node.max));
        node.first = static_cast<std::uint32_t>(begin);
        node.count = static_cast<std::uint32_t>(n);
        if (n == 1) return;

        RangeBounds left, right;
        const std::size_t middle = cut(begin, end, depth, bounds, left, right);
        if (middle == end) return;

        // A range of m refs has at most 2 m - 1 nodes, so the right subtree's place is known before the left exists.
        const std::size_t right_at = at + 2 * (middle - begin);
        node.first = static_cast<std::uint32_t>(right_at);
        node.count = 0;
        if (n < kParallelSubtree) {
            build(begin, middle, at + 1, depth + 1, left);
            build(middle, end, right_at, depth + 1, right);
            return;
        }
        tbb::task_group tasks;
        tasks.run([&] { build(begin, middle, at + 1, depth + 1, left); });
        build(middle, end, right_at, depth + 1, right);
        tasks.wait();
    }

  private:
    // Where the range is cut in two, or its end when it is best left as a leaf.
    std::size_t cut(std::size_t begin, std::size_t end, int depth, const RangeBounds& bounds,
                    RangeBounds& left, RangeBounds& right) {
        const std::size_t n = end - begin;
        const std::span<BuildRef> range = refs_.subspan(begin, n);
        const Binning binning(bounds.centres, n);
        const Bins bins = sum_over<Bins>(range, [&](Bins& b, const BuildRef& ref) { b.add(ref, binning); });
        const Split split = best_split(bins);

        if (n <= costs_.max_leaf) {
            const float area = half_area(bounds.boxes);
            const float as_leaf = area * (costs_.leaf + costs_.item * float(n));
            const float as_split = area * (costs_.step + costs_.leaf) + costs_.item * split.cost;
            if (!(as_split < as_leaf)) return end;
        }
        std::size_t middle = split.axis < 0 ? begin : partition(begin, end, binning, split, left, right);
        const std::size_t larger = std::max(middle - begin, end - middle);
        if (larger == n || depth + 1 + ceil_log2(larger) > kernel::kMaxDepth) {
            middle = halve(begin, end, bounds.centres);
            left = right = {};
            for (std::size_t i = begin; i < middle; ++i) left.add(refs_[i]);
            for (std::size_t i = middle; i < end; ++i) right.add(refs_[i]);
        }
        return middle;
    }

    std::size_t partition(std::size_t begin, std::size_t end, const Binning& binning, const Split& split,
                          RangeBounds& left, RangeBounds& right) {
        const auto is_left = [&](const BuildRef& ref) {
            return binning.bins(centre(ref))[split.axis] < split.bin;
        };
        std::size_t i = begin, j = end;
        for (;;) {
            for (; i < j && is_left(refs_[i]); ++i) left.add(refs_[i]);
            for (; i < j && !is_left(refs_[j - 1]); --j) right.add(refs_[j - 1]);
            if (i == j) return i;
            std::swap(refs_[i], refs_[j - 1]);
        }
    }

    // By count, along the widest axis; a total order, so that equal centres still have one answer.
    std::size_t halve(std::size_t begin, std::size_t end, const Bounds& centres) {
        int axis = 0;
        for (int a = 1; a < 3; ++a)
            if (centres.max[a] - centres.min[a] > centres.max[axis] - centres.min[axis]) axis = a;
        const auto at = [&](std::size_t i) { return refs_.begin() + static_cast<std::ptrdiff_t>(i); };
        const std::size_t middle = begin + (end - begin) / 2;
        std::nth_element(at(begin), at(middle), at(end), [&](const BuildRef& a, const BuildRef& b) {
            const float ca = centre(a)[axis], cb = centre(b)[axis];
            return ca != cb ? ca < cb : a.item < b.item;
        });
        return middle;
    }

    std::span<BuildRef> refs_;
    SplitCosts costs_;
    BinaryNode* nodes_;
};

}  // namespace

std::unique_ptr<BinaryNode[]> build_binary_tree(std::span<BuildRef> refs, const SplitCosts& costs) {
    auto nodes = std::make_unique_for_overwrite<BinaryNode[]>(2 * refs.size());
    const RangeBounds bounds =
        sum_over<RangeBounds>(refs, [](RangeBounds& b, const BuildRef& ref) { b.add(ref); });
    Builder(refs, costs, nodes.get()).build(0, refs.size(), 0, 0, bounds);
    return nodes;
}

}  // namespace rc
