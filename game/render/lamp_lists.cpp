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

constexpr float kFaintestLamp = 1e-4f;  // W/m2: a lamp that can not give more is not looked for

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

// For each cell, the share of looks at the lamp that met nothing.
std::vector<float> open_shares(const Search& search, std::uint32_t lamp_id) {
    const world::Lamp& lamp = search.level.lamps[lamp_id];
    const Grid& grid = search.grid;
    std::vector<float> open(grid.cell_count(), 0.0f);
    std::vector<rc::Ray> rays;
    std::vector<std::uint8_t> is_blocked;
    for (std::size_t c = 0; c < open.size(); ++c) {
        const glm::ivec3 cell = grid.cell_from_index(c);
        const float distance = distance_to_cell(grid, cell, lamp.position);
        if (lamp.shape != world::LampShape::Sun && !(lamp_bound(lamp, distance) > kFaintestLamp)) continue;
        Random random(hash_u32(lamp_id, static_cast<std::uint32_t>(c)));
        rays.clear();
        for (int i = 0; i < search.rays; ++i) {
            const rc::Ray ray = look(grid, cell, lamp, search.bulbs[lamp_id], random);
            if (glm::dot(ray.direction, ray.direction) > 0.0f) rays.push_back(ray);
        }
        is_blocked.resize(rays.size());
        rc::any_hits(search.walls, rays, rc::kAllLayers, is_blocked);
        const auto free = std::count(is_blocked.begin(), is_blocked.end(), 0);
        if (free > 0) open[c] = static_cast<float>(free) / static_cast<float>(rays.size());
    }
    return open;
}

// Half of what a cell sees itself and half of what it and its 26 neighbours see: 0 only where none of them sees any.
std::vector<float> widened(const Grid& grid, const std::vector<float>& open) {
    std::vector<float> wide(open.size());
    for (std::size_t c = 0; c < wide.size(); ++c) {
        const glm::ivec3 cell = grid.cell_from_index(c);
        const glm::ivec3 low = glm::max(cell - 1, glm::ivec3(0)), high = glm::min(cell + 1, grid.cells - 1);
        float sum = 0.0f;
        int count = 0;
        for (int z = low.z; z <= high.z; ++z) {
            for (int y = low.y; y <= high.y; ++y) {
                for (int x = low.x; x <= high.x; ++x, ++count) sum += open[grid.cell_index({x, y, z})];
            }
        }
        wide[c] = 0.5f * (open[c] + sum / static_cast<float>(count));
    }
    return wide;
}

}  // namespace

LampLists::Near LampLists::of_cell(std::size_t cell) const {
    const std::size_t first = begin[cell], count = begin[cell + 1] - first;
    return {std::span(lamps).subspan(first, count), std::span(open).subspan(first, count)};
}

LampLists find_lamp_lists(const world::Level& level, const world::Snapshot& snapshot,
                          const std::vector<BulbClearance>& bulbs, const Grid& grid, int rays_per_pair,
                          const Jobs& jobs) {
    const std::shared_ptr<const rc::Scene> walls = lasting_walls(level, *snapshot.scene);
    const Search search{level, *walls, bulbs, grid, rays_per_pair};
    std::vector<std::vector<float>> open(level.lamps.size());
    jobs.run(open.size(), [&](std::size_t lamp, int) {
        open[lamp] = widened(grid, open_shares(search, static_cast<std::uint32_t>(lamp)));
    });
    LampLists lists{.grid = grid, .begin = {0}, .lamps = {}, .open = {}};
    lists.begin.reserve(grid.cell_count() + 1);
    for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
        for (std::uint32_t lamp = 0; lamp < open.size(); ++lamp) {
            if (!(open[lamp][cell] > 0.0f)) continue;
            lists.lamps.push_back(lamp);
            lists.open.push_back(open[lamp][cell]);
        }
        lists.begin.push_back(static_cast<std::uint32_t>(lists.lamps.size()));
    }
    return lists;
}

}  // namespace gh::render
