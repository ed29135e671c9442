#include "render/lamp_lists.h"

#include "base/random.h"
#include "render/lamp.h"
#include "render/sampler.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kFaintest = 1e-4f;  // W/m2: a lamp that can not give more is not looked for
constexpr int kMostCrossings = 8;

bool lets_light_by(const world::Level& level, const rc::Hit& hit) {
    const world::Part& part = level.parts[hit.instance];
    if (part.mover != world::Mover::None) return true;
    const world::Mesh& mesh = level.meshes[part.mesh];
    const world::Material& material = level.materials[mesh.materials[hit.primitive]];
    return material.transmission > 0.0f || material.alpha_mode != world::AlphaMode::Opaque;
}

bool sees(const world::Level& level, const rc::Scene& scene, const world::Lamp& lamp, std::uint32_t lamp_part,
          rc::Ray ray) {
    for (int i = 0; i < kMostCrossings; ++i) {
        const auto hit = rc::closest_hit(scene, ray, world::Light);
        if (!hit || hit->instance == lamp_part) return true;
        if (!lets_light_by(level, *hit)) return false;
        const rc::SurfacePoint point = scene.surface(*hit);
        ray = lamp.shape == world::LampShape::Sun
                  ? rc::spawn_ray(point, ray.direction)
                  : rc::spawn_ray_to(point, ray.origin + ray.direction * ray.t_max);
    }
    return true;
}

// From somewhere in the cell to somewhere on the lamp.
rc::Ray look(const Grid& grid, const glm::ivec3& cell, const world::Lamp& lamp, Random& random) {
    const glm::vec3 inside(random.unit(), random.unit(), random.unit());
    const glm::vec3 from = grid.origin + grid.spacing * (glm::vec3(cell) + inside);
    if (lamp.shape == world::LampShape::Sun) return {.origin = from, .direction = -lamp.direction};
    const glm::vec2 u(random.unit(), random.unit());
    const glm::vec3 to = lamp_point(lamp, from, u) - from;
    return {.origin = from, .direction = to, .t_max = 1.0f};
}

float distance_to_cell(const Grid& grid, const glm::ivec3& cell, const glm::vec3& position) {
    const glm::vec3 low = grid.point_position(cell), high = grid.point_position(cell + 1);
    return glm::distance(position, glm::clamp(position, low, high));
}

std::vector<std::uint8_t> cells_that_see(const world::Level& level, const rc::Scene& scene, const Grid& grid,
                                         std::uint32_t lamp_id, int rays) {
    const world::Lamp& lamp = level.lamps[lamp_id];
    std::vector<std::uint8_t> is_seen(grid.cell_count(), 0);
    for (std::size_t c = 0; c < is_seen.size(); ++c) {
        const glm::ivec3 cell = grid.cell_from_index(c);
        const float distance = distance_to_cell(grid, cell, lamp.position);
        if (lamp.shape != world::LampShape::Sun && !(lamp_bound(lamp, distance) > kFaintest)) continue;
        Random random(hash_u32(lamp_id, static_cast<std::uint32_t>(c)));
        for (int i = 0; i < rays && is_seen[c] == 0; ++i) {
            const rc::Ray ray = look(grid, cell, lamp, random);
            if (glm::dot(ray.direction, ray.direction) > 0.0f)
                is_seen[c] = sees(level, scene, lamp, lamp.part, ray);
        }
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

LampLists find_lamp_lists(const world::Level& level, const world::Snapshot& snapshot, const Grid& grid,
                          int rays_per_pair, const Jobs& jobs) {
    std::vector<std::vector<std::uint8_t>> is_seen(level.lamps.size());
    jobs.run(is_seen.size(), [&](std::size_t lamp, int) {
        is_seen[lamp] = widened(grid, cells_that_see(level, *snapshot.scene, grid,
                                                     static_cast<std::uint32_t>(lamp), rays_per_pair));
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
