// comparators/kd_tree.h - a kD-tree by the surface-area heuristic: the classic for static scenes, and an oracle that
// shares nothing with raycore's trees.
//
// Cost      build O(n log n), one thread; a walk O(log n).
// Exact     a walk offers every triangle that any rounding of the ray could meet (ray_walk.h), some of them repeatedly.
#pragma once

#include "comparators/ray_walk.h"

#include <cstdint>
#include <span>
#include <vector>

namespace comparators {

class KdTree {
  public:
    explicit KdTree(const Soup& soup);

    [[nodiscard]] const Soup& soup() const { return soup_; }
    [[nodiscard]] std::size_t byte_size() const;

    // Calls visit(soup index) for every triangle near the ray, roughly from near to far. visit returns beyond which t
    // nothing is wanted any more.
    template <class Visit>
    void walk(const rc::Ray& ray, Visit&& visit) const;

  private:
    static constexpr std::uint32_t kLeaf = 3;
    static constexpr int kMaxDepth = 60;

    struct Node {
        float plane = 0;
        std::uint32_t axis = kLeaf;
        std::uint32_t first = 0;  // of two children in a row, or of a leaf's items
        std::uint32_t count = 0;
    };
    struct Split {
        double cost;
        std::uint32_t axis;  // kLeaf: none is worth it
        float plane;
    };

    void build(std::uint32_t node, const Bounds& box, std::vector<std::uint32_t>&& items, int depth);
    [[nodiscard]] Split best_split(const Bounds& box, std::span<const std::uint32_t> items) const;

    const Soup& soup_;
    std::vector<Bounds> boxes_;  // while building
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_;
    int depth_limit_ = 0;
};

template <class Visit>
void KdTree::walk(const rc::Ray& ray, Visit&& visit) const {
    const ThickRay thick(ray, soup_.reach);
    const std::optional<Interval> whole = thick.within(soup_.bounds);
    if (!whole || soup_.corners.empty()) return;
    struct Waiting {
        std::uint32_t node;
        Interval span;
    };
    Waiting stack[kMaxDepth + 2];
    int top = 0;
    stack[top++] = {0, *whole};
    double wanted = whole->far;
    while (top > 0) {
        auto [index, span] = stack[--top];
        if (span.near > wanted + thick.t_pad) continue;
        while (nodes_[index].axis != kLeaf) {
            const Node& node = nodes_[index];
            const std::size_t axis = node.axis;
            const double plane = static_cast<double>(node.plane), speed = thick.direction[axis];
            const double x0 = thick.at(span.near, axis), x1 = thick.at(span.far, axis);
            const double pad = 2 * thick.pad;
            const bool is_low = std::min(x0, x1) - pad <= plane, is_high = std::max(x0, x1) + pad >= plane;
            if (!is_low || !is_high) {
                index = node.first + (is_low ? 0 : 1);
                continue;
            }
            const std::uint32_t near = speed < 0.0 ? 1 : 0;
            Interval first = span, second = span;
            if (speed != 0.0) {
                const double slack = pad / std::abs(speed), cross = (plane - thick.origin[axis]) / speed;
                first.far = std::min(first.far, cross + slack);
                second.near = std::max(second.near, cross - slack);
            }
            stack[top++] = {node.first + 1 - near, second};
            index = node.first + near;
            span = first;
        }
        for (std::uint32_t i = 0; i < nodes_[index].count; ++i)
            wanted = std::min(wanted, visit(items_[nodes_[index].first + i]));
    }
}

}  // namespace comparators
