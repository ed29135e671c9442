#include "spatial_builder.h"

#include "clip.h"
#include "dispatch.h"
#include "parallel.h"
#include "reinsert.h"
#include "top_down_builder.h"

#include <algorithm>

namespace rc {

namespace {

using build::Plot;
using build::Range;
using kernel::Bins;
using kernel::SlabGrid;
using kernel::Split;

constexpr std::size_t kParallelRange = 65536;
constexpr std::size_t kPiecesAtATime = 16384;
constexpr std::size_t kParallelGather = 4096;
// Planes are tried where the best halves' boxes overlap by more than these shares of the root's surface and of their
// own range's. Lower shares cost time and memory and gain little: 1e-5 alone doubles the build for the same cost of rays,
// 1e-4 makes the museum's trees a twentieth larger and 2 % of one of four kinds of rays faster.
constexpr float kOverlapOfRoot = 1e-3f;
constexpr float kOverlapOfRange = 0.2f;
// And a plane is worth its pieces only where it costs less than this share of the best halves: what gains less scatters
// walls, which any-hit rays had better meet whole and early.
constexpr float kWorthPieces = 0.9f;
constexpr std::int32_t kSlabs = 8;  // 16 take a tenth longer and lead to no better trees

float overlap(const GrowingBox& a, const GrowingBox& b) {
    GrowingBox both;
    for (int i = 0; i < 4; ++i) both.neg_min[i] = std::min(a.neg_min[i], b.neg_min[i]);
    for (int i = 0; i < 4; ++i) both.max[i] = std::min(a.max[i], b.max[i]);
    for (int i = 0; i < 3; ++i)
        if (!(-both.neg_min[i] <= both.max[i])) return 0.0f;
    return build::half_area(both);
}

SlabGrid slabs_over(const GrowingBox& box) {
    SlabGrid grid{};
    grid.count = kSlabs;
    for (int a = 0; a < 3; ++a) {
        const float extent = box.max[a] + box.neg_min[a];
        const float scale = float(kSlabs) * 0.9999f / extent;
        grid.origin[a] = 0.0f - box.neg_min[a];
        if (!(extent > 0.0f && scale < build::kHuge)) continue;
        grid.scale[a] = scale;
        grid.width[a] = 1.0f / scale;
    }
    return grid;
}

class SpatialBuilder {
  public:
    SpatialBuilder(Unfilled<BuildRef> refs, const MeshView& mesh, const SplitCosts& costs)
        : count_(refs.size()),
          refs_(std::move(refs)),
          mesh_(mesh),
          arrays_{&mesh.positions[0].x, &mesh.triangles[0].x},
          cutter_(make_room(), costs),
          pool_(refs_.size()),
          kernels_(active_build_kernels()) {}

    BinaryTree run() {
        const Range whole = cutter_.whole(count_);
        root_area_ = build::half_area(whole.boxes);
        const auto cut = [this](const Plot& plot, int depth, Plot& left, Plot& right) {
            if (plot.range.size() == 1 || !cut_range(plot, depth, left.range, right.range)) return false;
            deal_out(plot, left, right);
            return true;
        };
        build::Growth(pool_, cut).grow({whole, refs_.size()});
        BinaryTree tree = pool_.release({});
        reinsert(tree);
        tree.items.resize(tree.nodes[0].size());
        gather(tree.nodes.data(), 0, 0, tree.items);
        return tree;
    }

  private:
    std::span<BuildRef> make_room() {
        refs_.resize(most_pieces_of(count_));
        return refs_;
    }

    // False when the range had better be a leaf.
    bool cut_range(const Plot& plot, int depth, Range& left, Range& right) {
        const Range& range = plot.range;
        if (range.size() <= kernel::kFewRefs && build::RangeCutter::leaves_depth_for_few(depth))
            return cutter_.cut_few(range, left, right);
        const build::ObjectSplit split = cutter_.object_split(range);
        if (cut_by_plane(plot, split.best, depth, left, right)) return true;
        if (!cutter_.pays(range, split.best.cost)) return false;
        if (split.best.axis >= 0) {
            cutter_.cut_at(split, range, left, right);
            if (build::RangeCutter::leaves_depth(depth, left.size(), right.size())) return true;
        }
        cutter_.halve(range, left, right);
        return true;
    }

    // False, and nothing moved, when no plane is better than `objects`, or there is no room for the pieces.
    bool cut_by_plane(const Plot& plot, const Split& objects, int depth, Range& left, Range& right) {
        if (plot.limit == plot.range.end) return false;
        if (objects.axis >= 0) {
            const float range_area = build::half_area(plot.range.boxes);
            const float worth = std::max(kOverlapOfRoot * root_area_, kOverlapOfRange * range_area);
            if (!(overlap(objects.left, objects.right) > worth)) return false;
        }
        const SlabGrid grid = slabs_over(plot.range.boxes);
        if (objects.axis >= 0 && looks_hopeless(plot.range, grid, objects.cost)) return false;
        const Split split = best_plane(plot.range, grid);
        if (split.axis < 0 || !(split.cost < kWorthPieces * objects.cost) ||
            !cutter_.pays(plot.range, split.cost))
            return false;
        if (!build::RangeCutter::leaves_depth(depth, split.left_count, split.right_count)) return false;

        const float plane = grid.origin[split.axis] + grid.width[split.axis] * float(split.bin);
        const Sides sides = count_sides(plot.range, split, plane);
        if (sides.left == 0 || sides.right == 0 || sides.both > plot.limit - plot.range.end) return false;
        if (!build::RangeCutter::leaves_depth(depth, sides.left + sides.both, sides.right + sides.both))
            return false;
        part(plot.range, split, plane, left, right);
        return true;
    }

    // Whether the best plane for one of sixteen refs costs more than halves do for all of them. Boxes of all are no smaller
    // than those of some, so a plane that is worth its pieces is rarely given up; others cost large ranges a pass for nothing.
    [[nodiscard]] bool looks_hopeless(const Range& range, const SlabGrid& grid, float cost) const {
        constexpr std::size_t kOneOf = 16, kAtATime = kPiecesAtATime / kOneOf;
        if (range.size() < kParallelRange) return false;
        Bins bins;
        kernels_.clear(bins, grid.count);
        std::size_t asked = 0;
        for (std::size_t i = range.begin; i + kAtATime <= range.end; i += kPiecesAtATime, asked += kAtATime)
            kernels_.bin_pieces(refs_.data() + i, kAtATime, arrays_, grid, bins);
        Split split;
        kernels_.best_plane(bins, split);
        return split.axis < 0 || split.cost * (float(range.size()) / float(asked)) > cost;
    }

    [[nodiscard]] Split best_plane(const Range& range, const SlabGrid& grid) const {
        Bins bins;
        kernels_.clear(bins, grid.count);
        const auto bin = [&](std::size_t begin, std::size_t end, Bins& into) {
            kernels_.bin_pieces(refs_.data() + begin, end - begin, arrays_, grid, into);
        };
        if (range.size() < kParallelRange) {
            bin(range.begin, range.end, bins);
        } else {
            bins = sum_in_parallel(
                BlockedRange(range.begin, range.end, kPiecesAtATime), bins,
                [&](const auto& part, Bins sum) {
                    bin(part.begin(), part.end(), sum);
                    return sum;
                },
                [](Bins a, const Bins& b) {
                    build::grow(a, b);
                    return a;
                });
        }
        Split split;
        kernels_.best_plane(bins, split);
        return split;
    }

    enum class Side { Left, Right, Both };
    struct Sides {
        std::size_t left = 0, right = 0, both = 0;
    };

    // What the plane passes through may still go to one side whole, when growing that side costs less than a piece
    // more on the other.
    [[nodiscard]] static Side side_of(const BuildRef& ref, const Split& split, float plane) {
        const int a = split.axis;
        if (ref.max[a] <= plane) return Side::Left;
        if (-ref.neg_min[a] >= plane) return Side::Right;
        GrowingBox left = split.left, right = split.right;
        for (int i = 0; i < 3; ++i) {
            left.neg_min[i] = std::max(left.neg_min[i], ref.neg_min[i]);
            left.max[i] = std::max(left.max[i], ref.max[i]);
            right.neg_min[i] = std::max(right.neg_min[i], ref.neg_min[i]);
            right.max[i] = std::max(right.max[i], ref.max[i]);
        }
        const float lefts = float(split.left_count), rights = float(split.right_count);
        const float area_left = build::half_area(split.left), area_right = build::half_area(split.right);
        const float as_both = area_left * lefts + area_right * rights;
        const float as_left = build::half_area(left) * lefts + area_right * (rights - 1.0f);
        const float as_right = area_left * (lefts - 1.0f) + build::half_area(right) * rights;
        if (as_both <= as_left && as_both <= as_right) return Side::Both;
        return as_left <= as_right ? Side::Left : Side::Right;
    }

    [[nodiscard]] Sides count_sides(const Range& range, const Split& split, float plane) const {
        Sides sides;
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const Side side = side_of(refs_[i], split, plane);
            ++(side == Side::Left ? sides.left : side == Side::Right ? sides.right : sides.both);
        }
        return sides;
    }

    // Lefts and left pieces, then rights, then right pieces in the room behind.
    void part(const Range& range, const Split& split, float plane, Range& left, Range& right) {
        std::size_t middle = range.begin, rights_begin = range.end, end = range.end;
        while (middle < rights_begin) {
            BuildRef& ref = refs_[middle];
            switch (side_of(ref, split, plane)) {
                case Side::Left:
                    ++middle;
                    break;
                case Side::Right:
                    std::swap(ref, refs_[--rights_begin]);
                    break;
                case Side::Both: {
                    const glm::uvec3& t = mesh_.triangles[ref.item];
                    const glm::vec3 corners[3] = {mesh_.positions[t.x], mesh_.positions[t.y],
                                                  mesh_.positions[t.z]};
                    const BuildRef whole = ref;
                    build::clip(whole, corners, split.axis, plane, ref, refs_[end++]);
                    ++middle;
                    break;
                }
            }
        }
        cutter_.measure(range.begin, middle, left);
        cutter_.measure(middle, end, right);
    }

    // The refs of a part that may still be cut by planes. Halves of what is small overlap by less than is worth one.
    [[nodiscard]] std::size_t in_want_of_room(const Range& part) const {
        return build::half_area(part.boxes) > kOverlapOfRoot * root_area_ ? part.size() : 0;
    }

    // The room left over goes to both parts by their sizes; the right one moves behind the left one's.
    void deal_out(const Plot& plot, Plot& left, Plot& right) {
        const std::size_t lefts = in_want_of_room(left.range), rights = in_want_of_room(right.range);
        const std::size_t room = plot.limit - right.range.end;
        const std::size_t shift = lefts == 0 ? 0 : room * lefts / (lefts + rights);
        if (shift > 0) {
            std::move_backward(refs_.begin() + static_cast<std::ptrdiff_t>(right.range.begin),
                               refs_.begin() + static_cast<std::ptrdiff_t>(right.range.end),
                               refs_.begin() + static_cast<std::ptrdiff_t>(right.range.end + shift));
            right.range.begin += shift;
            right.range.end += shift;
        }
        left.limit = right.range.begin;
        right.limit = plot.limit;
    }

    // Leaf by leaf, from items[first] on; leaves then name ranges of `items`.
    void gather(BinaryNode* nodes, std::uint32_t at, std::uint32_t first, Unfilled<std::uint32_t>& items) {
        BinaryNode& node = nodes[at];
        if (node.is_leaf()) {
            for (std::uint32_t i = 0; i < node.count; ++i) items[first + i] = refs_[node.first + i].item;
            node.first = first;
            return;
        }
        const auto left = [&] { gather(nodes, node.first, first, items); };
        const auto right = [&] { gather(nodes, node.first + 1, first + nodes[node.first].size(), items); };
        if (node.size() >= kParallelGather) {
            both_in_parallel(left, right);
        } else {
            left();
            right();
        }
    }

    std::size_t count_;
    Unfilled<BuildRef> refs_;
    const MeshView& mesh_;
    kernel::MeshArrays arrays_;
    build::RangeCutter cutter_;
    build::NodePool pool_;
    const kernel::BuildKernels& kernels_;
    float root_area_ = 0.0f;
};

}  // namespace

BinaryTree build_spatial_tree(Unfilled<BuildRef> refs, const MeshView& mesh, const SplitCosts& costs) {
    return SpatialBuilder(std::move(refs), mesh, costs).run();
}

}  // namespace rc
