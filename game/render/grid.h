// render/grid.h - a box cut into equal cells: where the precomputed light lives.
#pragma once

#include "world/level.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gh::render {

// Cell (x, y, z) covers [origin + cell * spacing, origin + (cell + 1) * spacing); its corners are grid points.
struct Grid {
    glm::vec3 origin{0.0f};
    glm::vec3 spacing{1.0f};
    glm::ivec3 cells{1};

    [[nodiscard]] std::size_t cell_count() const { return count(cells); }
    [[nodiscard]] std::size_t point_count() const { return count(cells + 1); }

    // Of the cell that holds `position`, or the nearest one.
    [[nodiscard]] glm::ivec3 cell_at(const glm::vec3& position) const {
        const glm::vec3 at = (position - origin) / spacing;
        glm::ivec3 cell;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto last = static_cast<float>(cells[axis] - 1);
            const float clamped = at[axis] > 0.0f ? std::min(at[axis], last) : 0.0f;  // NaN goes to 0
            cell[axis] = static_cast<int>(clamped);
        }
        return cell;
    }
    [[nodiscard]] std::size_t cell_index(const glm::ivec3& cell) const { return index(cell, cells); }
    [[nodiscard]] std::size_t point_index(const glm::ivec3& point) const { return index(point, cells + 1); }
    [[nodiscard]] glm::ivec3 cell_from_index(std::size_t i) const { return from_index(i, cells); }
    [[nodiscard]] glm::ivec3 point_from_index(std::size_t i) const { return from_index(i, cells + 1); }
    [[nodiscard]] glm::vec3 point_position(const glm::ivec3& point) const {
        return origin + spacing * glm::vec3(point);
    }

  private:
    [[nodiscard]] static std::size_t count(const glm::ivec3& n) {
        return static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z);
    }
    [[nodiscard]] static std::size_t index(const glm::ivec3& at, const glm::ivec3& n) {
        return (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(n.y) +
                static_cast<std::size_t>(at.y)) *
                   static_cast<std::size_t>(n.x) +
               static_cast<std::size_t>(at.x);
    }
    [[nodiscard]] static glm::ivec3 from_index(std::size_t i, const glm::ivec3& n) {
        const auto nx = static_cast<std::size_t>(n.x), ny = static_cast<std::size_t>(n.y);
        return {static_cast<int>(i % nx), static_cast<int>(i / nx % ny), static_cast<int>(i / nx / ny)};
    }
};

// Cells of about `spacing` metres over the box and half a cell beyond it on all sides, so that no grid point lies on a
// wall that bounds it; wider cells where there would be more than `max_cells`.
[[nodiscard]] Grid make_grid(const world::Aabb& box, float spacing, std::size_t max_cells);

}  // namespace gh::render
