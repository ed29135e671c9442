#include "render/ambient_bake.h"

#include "base/det_math.h"
#include "render/ambient_looks.h"
#include "render/light_math.h"

#include <glm/common.hpp>

#include <bitset>
#include <utility>
#include <vector>

namespace gh::render {

namespace {

void note_lit_groups(Bake& bake, std::size_t point) {
    bake.is_lit_by[point].reset();
    for (std::size_t group = 0; group < bake.result.cubes.size(); ++group) {
        for (const glm::vec3& side : bake.result.cubes[group][point].face) {
            if (side.x + side.y + side.z > 0.0f) bake.is_lit_by[point].set(group);
        }
    }
}

// What the point's patches give back of the light the last round found there, on top of the first.
void bounce(const Bake& bake, std::size_t point, std::vector<std::vector<AmbientCube>>& next) {
    const std::size_t rays = bake.directions.size();
    for (std::size_t group = 0; group < next.size(); ++group) next[group][point] = bake.first[group][point];
    if (!(bake.result.validity[point] > 0.0f)) return;
    for (std::size_t i = 0; i < rays; ++i) {
        const Patch& patch = bake.patches[point * rays + i];
        if (!(patch.albedo.x + patch.albedo.y + patch.albedo.z > 0.0f)) continue;
        const GridWeights weights = bake.result.weights(patch.position, patch.normal);
        std::bitset<kMostBakedGroups> groups;
        for (std::size_t k = 0; k < 8; ++k) {
            if (weights.weight[k] > 0.0f) groups |= bake.is_lit_by[weights.point[k]];
        }
        for (std::size_t group = 0; group < next.size(); ++group) {
            if (!groups.test(group)) continue;
            glm::vec3 irradiance(0.0f);
            for (std::size_t k = 0; k < 8; ++k) {
                if (!(weights.weight[k] > 0.0f)) continue;
                irradiance +=
                    bake.result.cubes[group][weights.point[k]].irradiance(patch.normal) * weights.weight[k];
            }
            add_light(next[group][point], bake.directions[i], patch.albedo * irradiance * kPerPi,
                      bake.per_side);
        }
    }
}

// Of the 26 points around one, those that see anything.
std::vector<std::size_t> seeing_around(const Grid& grid, const std::vector<float>& sees, std::size_t point) {
    const glm::ivec3 at = grid.point_from_index(point);
    const glm::ivec3 low = glm::max(at - 1, glm::ivec3(0)), high = glm::min(at + 1, grid.cells);
    std::vector<std::size_t> around;
    for (int z = low.z; z <= high.z; ++z) {
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                const std::size_t other = grid.point_index({x, y, z});
                if (sees[other] > 0.0f) around.push_back(other);
            }
        }
    }
    return around;
}

// A point inside a wall takes what those around it have, and counts a thousandth of them: for corners that see no other.
void fill_blind_points(AmbientBake& bake) {
    constexpr float kBlind = 1e-3f;
    const Grid& grid = bake.grid;
    const std::vector<float> sees = bake.validity;
    for (std::size_t point = 0; point < sees.size(); ++point) {
        if (sees[point] > 0.0f) continue;
        const std::vector<std::size_t> around = seeing_around(grid, sees, point);
        if (around.empty()) continue;
        const float share = 1.0f / static_cast<float>(around.size());
        bake.sights[point] = {};
        for (const std::size_t other : around) {
            for (std::size_t i = 0; i < kSightMoments / 2; ++i)
                bake.sights[point].moments[i] += bake.sights[other].moments[i] * share;
        }
        for (std::vector<AmbientCube>& cubes : bake.cubes) {
            cubes[point] = {};
            for (const std::size_t other : around) {
                for (std::size_t side = 0; side < 6; ++side)
                    cubes[point].face[side] += cubes[other].face[side] * share;
            }
        }
        bake.validity[point] = kBlind;
    }
}

}  // namespace

AmbientBake bake_ambient(const SceneView& view, const Grid& grid, const BakeSettings& settings,
                         const Jobs& jobs) {
    const std::size_t points = grid.point_count(), groups = view.level.lamp_groups.size() + 1;
    const std::vector<glm::vec3> directions = even_directions(settings.rays);
    Bake bake{.view = view,
              .settings = settings,
              .directions = directions,
              .per_side = light_per_side(directions),
              .always = groups - 1,
              .result = {.grid = grid,
                         .sights = std::vector<SightMap>(points),
                         .validity = std::vector<float>(points),
                         .cubes = {}},
              .patches = {},
              .first = {},
              .is_lit_by = std::vector<std::bitset<kMostBakedGroups>>(points)};
    bake.patches.resize(points * bake.directions.size());
    bake.first.assign(groups, std::vector<AmbientCube>(points));
    jobs.run(points, [&](std::size_t point, int) { look_round(bake, point); });

    bake.result.cubes = bake.first;
    for (int i = 1; i < settings.bounces; ++i) {
        jobs.run(points, [&](std::size_t point, int) { note_lit_groups(bake, point); });
        std::vector<std::vector<AmbientCube>> next(groups, std::vector<AmbientCube>(points));
        jobs.run(points, [&](std::size_t point, int) { bounce(bake, point, next); });
        bake.result.cubes = std::move(next);
    }
    fill_blind_points(bake.result);
    return std::move(bake.result);
}

}  // namespace gh::render
