#include "comparators/uniform_grid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace comparators {

namespace {

constexpr double kCellsPerTriangle = 4;
constexpr int kMostAlong = 256;

}  // namespace

UniformGrid::UniformGrid(const Soup& soup) : soup_(soup) {
    // Hits stray from the ray by ray_pad at most, the walk's own position by far less.
    margin_ = 2 * ray_pad(kFarthest * soup.reach, soup.reach);
    box_ = {soup.bounds.min - margin_, soup.bounds.max + margin_};
    choose_cells();
    const std::size_t cell_count = static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y) *
                                   static_cast<std::size_t>(cells_.z);
    first_.assign(cell_count + 1, 0);
    for (const Corners& corners : soup.corners)
        for_each_cell(corners, [&](std::size_t cell) { ++first_[cell + 1]; });
    for (std::size_t i = 0; i < cell_count; ++i) first_[i + 1] += first_[i];
    items_.resize(first_.back());
    std::vector<std::uint32_t> end(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < soup.corners.size(); ++i)
        for_each_cell(soup.corners[i], [&](std::size_t cell) { items_[end[cell]++] = i; });
}

// Cubes, as nearly as the box allows, a few for every triangle.
void UniformGrid::choose_cells() {
    const glm::dvec3 size = box_.max - box_.min;
    const double wanted = kCellsPerTriangle * static_cast<double>(soup_.corners.size());
    const double per_metre = std::cbrt(std::max(1.0, wanted) / std::max(size.x * size.y * size.z, 1e-300));
    for (std::size_t a = 0; a < 3; ++a) {
        cells_[a] = static_cast<int>(std::clamp(size[a] * per_metre, 1.0, static_cast<double>(kMostAlong)));
        cell_size_[a] = std::max(size[a] / cells_[a], 1e-300);
    }
}

std::size_t UniformGrid::byte_size() const {
    return (first_.size() + items_.size()) * sizeof(std::uint32_t) +
           soup_.corners.size() * (sizeof(Corners) + sizeof(std::uint32_t));
}

// Cells that the triangle's box and its plane both come near.
template <class Enter>
void UniformGrid::for_each_cell(const Corners& corners, Enter&& enter) const {
    const Bounds box = bounds_of(corners);
    glm::ivec3 low, high;
    for (std::size_t a = 0; a < 3; ++a) {
        low[a] = cell_along(box.min[a] - margin_, a);
        high[a] = cell_along(box.max[a] + margin_, a);
    }
    const glm::dvec3 corner(corners[0]);
    glm::dvec3 normal = glm::cross(glm::dvec3(corners[1]) - corner, glm::dvec3(corners[2]) - corner);
    const double length = glm::length(normal);
    normal = length > 0 ? normal / length : glm::dvec3(0.0);
    const double reach = glm::dot(glm::abs(normal), 0.5 * cell_size_ + margin_) * (1 + 1e-9);
    for (int z = low.z; z <= high.z; ++z) {
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                const glm::dvec3 centre = box_.min + cell_size_ * (glm::dvec3(x, y, z) + 0.5);
                if (std::abs(glm::dot(normal, centre - corner)) <= reach) enter(index_of({x, y, z}));
            }
        }
    }
}

}  // namespace comparators
