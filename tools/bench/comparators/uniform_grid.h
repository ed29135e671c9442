// comparators/uniform_grid.h - equal cells walked one after the other (Amanatides and Woo 1987): quick to build, good
// where triangles are spread evenly, lost in a stadium with a teapot. An oracle that shares nothing with raycore.
//
// Cost      build O(n), one thread; a walk O(cells passed).
// Exact     a walk offers every triangle that any rounding of the ray could meet: triangles are entered with a margin
//           that covers rays from up to 32 times the mesh's reach away; rays from farther are offered every triangle.
#pragma once

#include "comparators/ray_walk.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace comparators {

class UniformGrid {
  public:
    explicit UniformGrid(const Soup& soup);

    [[nodiscard]] const Soup& soup() const { return soup_; }
    [[nodiscard]] std::size_t byte_size() const;

    // As KdTree::walk.
    template <class Visit>
    void walk(const rc::Ray& ray, Visit&& visit) const;

  private:
    static constexpr double kFarthest = 32;

    struct CellRange {
        glm::ivec3 low, high;
    };
    [[nodiscard]] int cell_along(double x, std::size_t axis) const {
        const double cell = (x - box_.min[axis]) / cell_size_[axis];
        return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(cells_[axis] - 1)));
    }
    [[nodiscard]] std::size_t index_of(const glm::ivec3& c) const {
        return (static_cast<std::size_t>(c.z) * static_cast<std::size_t>(cells_.y) +
                static_cast<std::size_t>(c.y)) *
                   static_cast<std::size_t>(cells_.x) +
               static_cast<std::size_t>(c.x);
    }
    void choose_cells();
    template <class Enter>
    void for_each_cell(const Corners& corners, Enter&& enter) const;

    const Soup& soup_;
    Bounds box_;
    glm::dvec3 cell_size_{1.0};
    glm::ivec3 cells_{1};
    double margin_ = 0;
    std::vector<std::uint32_t> first_;  // of each cell's items, and one more
    std::vector<std::uint32_t> items_;
};

template <class Visit>
void UniformGrid::walk(const rc::Ray& ray, Visit&& visit) const {
    if (soup_.corners.empty()) return;
    if (reach_of(ray.origin) > kFarthest * soup_.reach) {
        for (std::uint32_t i = 0; i < soup_.corners.size(); ++i) (void)visit(i);
        return;
    }
    const ThickRay thick(ray, soup_.reach);
    const std::optional<Interval> span = thick.within(box_);
    if (!span) return;
    constexpr double kNever = std::numeric_limits<double>::infinity();
    glm::ivec3 cell(0), step(0);
    glm::dvec3 next(kNever), stride(0.0);  // t of the next wall along each axis, and from wall to wall
    for (std::size_t a = 0; a < 3; ++a) {
        cell[a] = cell_along(thick.at(span->near, a), a);
        if (thick.direction[a] == 0.0) continue;
        step[a] = thick.direction[a] < 0.0 ? -1 : 1;
        const double wall = box_.min[a] + cell_size_[a] * (cell[a] + (step[a] > 0 ? 1 : 0));
        next[a] = (wall - thick.origin[a]) / thick.direction[a];
        stride[a] = cell_size_[a] / std::abs(thick.direction[a]);
    }
    double wanted = span->far, entered = span->near;
    while (entered <= wanted + thick.t_pad) {
        const std::size_t at = index_of(cell);
        for (std::uint32_t i = first_[at]; i < first_[at + 1]; ++i)
            wanted = std::min(wanted, visit(items_[i]));
        const std::size_t axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
        entered = next[axis];
        if (!(entered < kNever)) return;
        next[axis] += stride[axis];
        cell[axis] += step[axis];
        if (cell[axis] < 0 || cell[axis] >= cells_[axis]) return;
    }
}

}  // namespace comparators
