// render/lamp_lists.h - which lamps can be seen at all from each cell of the level, and about how much of each, so that a
// pixel asks for the few lamps of its room instead of all, and most for those that it is likely to see.
//
// Found once a level by rays between points of a cell and points of a lamp. What moves (doors, guards, turning
// mirrors) and what is clear is ignored, and a cell takes over its neighbours' lamps, so that only light through
// openings far smaller than a cell can be missed.
#pragma once

#include "base/jobs.h"
#include "render/grid.h"
#include "render/lamp.h"
#include "world/level.h"
#include "world/snapshot.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gh::render {

struct LampLists {
    Grid grid;
    std::vector<std::uint32_t> begin;  // cell c has lamps[begin[c]] .. lamps[begin[c + 1]], ids rising
    std::vector<std::uint32_t> lamps;
    std::vector<float> open;  // of each of these: the share of looks from in and around it that met nothing

    struct Near {
        std::span<const std::uint32_t> lamps;
        std::span<const float> open;
    };
    [[nodiscard]] Near of_cell(std::size_t cell) const;
    [[nodiscard]] Near near(const glm::vec3& position) const {
        return of_cell(grid.cell_index(grid.cell_at(position)));
    }
    [[nodiscard]] std::span<const std::uint32_t> at(const glm::vec3& position) const {
        return near(position).lamps;
    }
};

// `rays_per_pair`: looks from a cell to a lamp before it counts as hidden.
[[nodiscard]] LampLists find_lamp_lists(const world::Level& level, const world::Snapshot& snapshot,
                                        const std::vector<BulbClearance>& bulbs, const Grid& grid,
                                        int rays_per_pair, const Jobs& jobs);

}  // namespace gh::render
