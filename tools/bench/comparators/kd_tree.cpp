#include "comparators/kd_tree.h"

#include <array>
#include <bit>

namespace comparators {

namespace {

constexpr int kBins = 32;
constexpr double kStep = 1.0;  // cost of a node
constexpr double kItem = 1.5;  // cost of a triangle
constexpr double kEmptyBonus = 0.8;
constexpr std::size_t kSmallLeaf = 2;

double area_of(const Bounds& box) {
    const glm::dvec3 d = box.max - box.min;
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

struct Bins {
    std::array<std::uint32_t, kBins> starts{}, ends{};
};

// Counts in which bin each item begins and ends.
Bins count_bins(const Bounds& box, std::size_t axis, std::span<const std::uint32_t> items,
                const std::vector<Bounds>& boxes) {
    Bins bins;
    const double width = box.max[axis] - box.min[axis];
    const auto bin_of = [&](double x) {
        const double share = (x - box.min[axis]) / width * kBins;
        return static_cast<std::size_t>(std::clamp(share, 0.0, kBins - 1.0));
    };
    for (const std::uint32_t item : items) {
        ++bins.starts[bin_of(boxes[item].min[axis])];
        ++bins.ends[bin_of(boxes[item].max[axis])];
    }
    return bins;
}

}  // namespace

KdTree::KdTree(const Soup& soup) : soup_(soup) {
    for (const Corners& corners : soup.corners) boxes_.push_back(bounds_of(corners));
    const auto count = static_cast<std::uint32_t>(boxes_.size());
    depth_limit_ =
        std::min(kMaxDepth, static_cast<int>(8.0 + 1.3 * static_cast<double>(std::bit_width(count))));
    std::vector<std::uint32_t> all(count);
    for (std::uint32_t i = 0; i < count; ++i) all[i] = i;
    nodes_.emplace_back();
    build(0, soup.bounds, std::move(all), 0);
    boxes_ = {};
}

std::size_t KdTree::byte_size() const {
    return nodes_.size() * sizeof(Node) + items_.size() * sizeof(std::uint32_t) +
           soup_.corners.size() * (sizeof(Corners) + sizeof(std::uint32_t));
}

KdTree::Split KdTree::best_split(const Bounds& box, std::span<const std::uint32_t> items) const {
    Split best{kItem * static_cast<double>(items.size()), kLeaf, 0};
    const double whole = area_of(box);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double width = box.max[axis] - box.min[axis];
        if (!(width > 0) || !(whole > 0)) continue;
        const Bins bins = count_bins(box, axis, items, boxes_);
        std::size_t low = 0, high = items.size();
        for (std::size_t bin = 1; bin < kBins; ++bin) {
            low += bins.starts[bin - 1];
            high -= bins.ends[bin - 1];
            Bounds left = box, right = box;
            const auto plane = static_cast<float>(box.min[axis] + width * static_cast<double>(bin) / kBins);
            left.max[axis] = right.min[axis] = static_cast<double>(plane);
            const double items_cost =
                (area_of(left) * static_cast<double>(low) + area_of(right) * static_cast<double>(high)) /
                whole;
            const double cost = kStep + kItem * items_cost * (low == 0 || high == 0 ? kEmptyBonus : 1.0);
            const bool is_inside = left.max[axis] > box.min[axis] && left.max[axis] < box.max[axis];
            if (is_inside && cost < best.cost) best = {cost, static_cast<std::uint32_t>(axis), plane};
        }
    }
    return best;
}

void KdTree::build(std::uint32_t node, const Bounds& box, std::vector<std::uint32_t>&& items, int depth) {
    const Split split =
        items.size() <= kSmallLeaf || depth >= depth_limit_ ? Split{0, kLeaf, 0} : best_split(box, items);
    if (split.axis == kLeaf) {
        nodes_[node] = {0, kLeaf, static_cast<std::uint32_t>(items_.size()),
                        static_cast<std::uint32_t>(items.size())};
        items_.insert(items_.end(), items.begin(), items.end());
        return;
    }
    const double plane = static_cast<double>(split.plane);
    std::vector<std::uint32_t> low, high;
    for (const std::uint32_t item : items) {  // what lies in the plane goes both ways
        if (boxes_[item].min[split.axis] <= plane) low.push_back(item);
        if (boxes_[item].max[split.axis] >= plane) high.push_back(item);
    }
    std::vector<std::uint32_t>().swap(items);
    const auto first = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node] = {split.plane, split.axis, first, 0};
    Bounds left = box, right = box;
    left.max[split.axis] = right.min[split.axis] = plane;
    build(first, left, std::move(low), depth + 1);
    build(first + 1, right, std::move(high), depth + 1);
}

}  // namespace comparators
