#include "render/lamp_lists.h"

#include "base/random.h"
#include "world/clear_parts.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <memory>

namespace gh::render {

namespace {

constexpr float kFaintest = 1e-4f;  // W/m2: a lamp that can not give more is not looked for

struct Search {
    const world::Level& level;
    const rc::Scene& walls;
    const std::vector<BulbClearance>& bulbs;
    const Grid& grid;
    int rays;
};

// What stays where it is and lets no light through.
std::shared_ptr<const rc::Scene> lasting_walls(const world::Level& level, const rc::Scene& scene) {
    rc::SceneBuilder builder;
    for (std::uint32_t i = 0; i < level.parts.size(); ++i) {
        const world::Part& part = level.parts[i];
        const bool stays = part.mover == world::Mover::None && (part.layers & world::Light) != 0;
        if (stays && !world::has_clear_triangles(level, level.meshes[part.mesh]))
            builder.add(scene.instance(i));
    }
    return builder.commit();
}

// From somewhere in the cell to somewhere on the lamp, up to its bulb.
rc::Ray look(const Grid& grid, const glm::ivec3& cell, const world::Lamp& lamp, const BulbClearance& bulb,
             Random& random) {
    const glm::vec3 inside(random.unit(), random.unit(), random.unit());
    const glm::vec3 from = grid.origin + grid.spacing * (glm::vec3(cell) + inside);
    if (lamp.shape == world::LampShape::Sun) return {.origin = from, .direction = -lamp.direction};
    const glm::vec2 u(random.unit(), random.unit());
    const glm::vec3 way = lamp_point(lamp, from, u) - from;
    const float length = glm::length(way);
    const float kept_off = lamp.shape == world::LampShape::Rect ? bulb.front : bulb.radius;
    return {.origin = from, .direction = way, .t_max = std::max(0.0f, 1.0f - 2.0f * kept_off / length)};
}

float distance_to_cell(const Grid& grid, const glm::ivec3& cell, const glm::vec3& position) {
    const glm::vec3 low = grid.point_position(cell), high = grid.point_position(cell + 1);
    return glm::distance(position, glm::clamp(position, low, high));
}

std::vector<std::uint8_t> cells_that_see(const Search& search, std::uint32_t lamp_id) {
    const world::Lamp& lamp = search.level.lamps[lamp_id];
    const Grid& grid = search.grid;
    std::vector<std::uint8_t> is_seen(grid.cell_count(), 0);
    std::vector<rc::Ray> rays;
    std::vector<std::uint8_t> is_blocked;
    for (std::size_t c = 0; c < is_seen.size(); ++c) {
        const glm::ivec3 cell = grid.cell_from_index(c);
        const float distance = distance_to_cell(grid, cell, lamp.position);
        if (lamp.shape != world::LampShape::Sun && !(lamp_bound(lamp, distance) > kFaintest)) continue;
        Random random(hash_u32(lamp_id, static_cast<std::uint32_t>(c)));
        rays.clear();
        for (int i = 0; i < search.rays; ++i) {
            const rc::Ray ray = look(grid, cell, lamp, search.bulbs[lamp_id], random);
            if (glm::dot(ray.direction, ray.direction) > 0.0f) rays.push_back(ray);
        }
        is_blocked.resize(rays.size());
        rc::any_hits(search.walls, rays, rc::kAllLayers, is_blocked);
        is_seen[c] = std::find(is_blocked.begin(), is_blocked.end(), 0) != is_blocked.end() ? 1 : 0;
    }
    return is_seen;
}

// Every cell also gets what its 26 neighbours see.
std::vector<std::uint8_t> widened(const Grid& grid, const std::vector<std::uint8_t>& is_seen) {
    std::vector<std::uint8_t> wide(is_seen.size(), 0);
    for (std::size_t c = 0; c < wide.size(); ++c) {
        const glm::ivec3 cell = grid.cell_from_index(c);
        const glm::ivec3 low = glm::max(cell - 1, glm::ivec3(0)), high = glm::min(cell + 1, grid.cells - 1);
        for (int z = low.z; z <= high.z; ++z) {
            for (int y = low.y; y <= high.y; ++y) {
                for (int x = low.x; x <= high.x; ++x) wide[c] |= is_seen[grid.cell_index({x, y, z})];
            }
        }
    }
    return wide;
}

}  // namespace

std::span<const std::uint32_t> LampLists::at(const glm::vec3& position) const {
    const std::size_t cell = grid.cell_index(grid.cell_at(position));
    return std::span(lamps).subspan(begin[cell], begin[cell + 1] - begin[cell]);
}

LampLists find_lamp_lists(const world::Level& level, const world::Snapshot& snapshot,
                          const std::vector<BulbClearance>& bulbs, const Grid& grid, int rays_per_pair,
                          const Jobs& jobs) {
    const std::shared_ptr<const rc::Scene> walls = lasting_walls(level, *snapshot.scene);
    const Search search{level, *walls, bulbs, grid, rays_per_pair};
    std::vector<std::vector<std::uint8_t>> is_seen(level.lamps.size());
    jobs.run(is_seen.size(), [&](std::size_t lamp, int) {
        is_seen[lamp] = widened(grid, cells_that_see(search, static_cast<std::uint32_t>(lamp)));
    });
    LampLists lists{.grid = grid, .begin = {0}, .lamps = {}};
    lists.begin.reserve(grid.cell_count() + 1);
    for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
        for (std::uint32_t lamp = 0; lamp < is_seen.size(); ++lamp) {
            if (is_seen[lamp][cell] != 0) lists.lamps.push_back(lamp);
        }
        lists.begin.push_back(static_cast<std::uint32_t>(lists.lamps.size()));
    }
    return lists;
}

}  // namespace gh::render
