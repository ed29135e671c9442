#include "render/ambient_bake.h"

#include "base/det_math.h"
#include "base/random.h"
#include "render/octahedron.h"
#include "render/sampler.h"
#include "render/shading_point.h"
#include "render/sky.h"
#include "render/transmittance.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kPerPi = 1.0f / kPi;
constexpr float kFaintest = 1e-4f;       // W/m2
constexpr float kMostBackFaces = 0.25f;  // of the faces it sees; a point that sees more is inside a wall
constexpr int kMostCrossings = 6;
constexpr std::size_t kMostGroups = world::kMaxLampGroups + 1;

// Where one ray from a grid point ended, and what is needed to light it again for the next bounce.
struct Patch {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
    glm::vec3 albedo{0.0f};  // 0: nothing comes back from here
};

using PerSide = std::array<float, 6>;

struct Bake {
    const SceneView& view;
    BakeSettings settings;
    std::vector<glm::vec3> directions;
    PerSide per_side;
    std::size_t always;  // index of the group that no switch turns off
    AmbientBake result;
    std::vector<Patch> patches;                       // [point][ray]
    std::vector<std::vector<AmbientCube>> first;      // light that came off one wall: [group][point]
    std::vector<std::bitset<kMostGroups>> is_lit_by;  // [point]
};

// Evenly over the sphere (a spherical Fibonacci lattice).
std::vector<glm::vec3> even_directions(int count) {
    constexpr float kGoldenAngle = 2.39996322972865332f;
    std::vector<glm::vec3> directions;
    directions.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const float y = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
        const auto [sine, cosine] = det::sin_cos(kGoldenAngle * static_cast<float>(i));
        const float radius = std::sqrt(1.0f - y * y);
        directions.emplace_back(radius * cosine, y, radius * sine);
    }
    return directions;
}

std::size_t group_or(std::uint32_t group, std::size_t always) {
    return group == world::kNoIndex ? always : group;
}

// Which of a cube's sides a direction adds to along an axis.
std::size_t side_of(const glm::vec3& direction, std::size_t axis) {
    return 2 * axis + (direction[axis] < 0.0f ? 1 : 0);
}

// One cosine-weighted share of a cube's sides.
void add_light(AmbientCube& cube, const glm::vec3& direction, const glm::vec3& radiance,
               const PerSide& per_side) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t side = side_of(direction, axis);
        cube.face[side] += radiance * (std::abs(direction[axis]) * per_side[side]);
    }
}

// pi over the sum of the cosines towards each side: uniform light comes out exactly.
PerSide light_per_side(const std::vector<glm::vec3>& directions) {
    PerSide sum{};
    for (const glm::vec3& d : directions) {
        for (std::size_t axis = 0; axis < 3; ++axis) sum[side_of(d, axis)] += std::abs(d[axis]);
    }
    for (float& side : sum) side = kPi / std::max(side, 1e-20f);
    return sum;
}

// Follows a ray through glass to something opaque; `tint` becomes what is left of the light.
std::optional<rc::Hit> first_opaque(const SceneView& view, rc::Ray& ray, glm::vec3& tint) {
    for (int i = 0; i < kMostCrossings; ++i) {
        const auto hit = rc::closest_hit(*view.snapshot.scene, ray, world::Light);
        if (!hit || !view.prepared.parts[hit->instance].is_clear) return hit;
        const Clearness clear = clearness(view, *hit);
        if (!(clear.share.x + clear.share.y + clear.share.z > 0.0f)) return hit;
        tint *= clear.share;
        ray = rc::spawn_ray(clear.surface, ray.direction);
    }
    return std::nullopt;
}

// Radiance that leaves the patch because lamps shine on it, added to the point's cubes.
void light_patch(Bake& bake, std::size_t point, std::size_t ray, const ShadingPoint& at,
                 const glm::vec3& albedo) {
    const world::Level& level = bake.view.level;
    for (const std::uint32_t id : bake.view.prepared.lamp_lists.at(at.surface.position)) {
        const world::Lamp& lamp = level.lamps[id];
        const glm::vec3 irradiance = lamp_irradiance(lamp, at.surface.position, at.geometric);
        if (!(std::max({irradiance.x, irradiance.y, irradiance.z}) > kFaintest)) continue;
        const std::uint32_t seed =
            hash_u32(static_cast<std::uint32_t>(point), static_cast<std::uint32_t>(ray), id);
        const glm::vec3 target = lamp_point(lamp, at.surface.position, sobol_point(0, seed));
        if (lamp.shape != world::LampShape::Sun &&
            glm::dot(target - at.surface.position, at.geometric) <= 0.0f)
            continue;
        const auto shadow = shadow_ray(lamp, bake.view.prepared.bulbs[id], at.surface, target);
        const glm::vec3 share =
            !shadow ? glm::vec3(1.0f)
            : rc::any_hit(*bake.view.snapshot.scene, *shadow, world::Light)
                ? (bake.view.prepared.has_clear_parts ? transmittance(bake.view, *shadow) : glm::vec3(0.0f))
                : glm::vec3(1.0f);
        add_light(bake.first[group_or(lamp.group, bake.always)][point], bake.directions[ray],
                  albedo * irradiance * share * kPerPi, bake.per_side);
    }
}

void add_sky(Bake& bake, std::size_t point, std::size_t ray, const glm::vec3& tint) {
    for (const world::Lamp& lamp : bake.view.level.lamps) {
        if (lamp.shape != world::LampShape::Sun) continue;
        if (lamp.group == world::kNoIndex && !lamp.starts_on) continue;
        const glm::vec3 radiance = tint * sky_radiance(lamp.intensity, bake.directions[ray]);
        add_light(bake.first[group_or(lamp.group, bake.always)][point], bake.directions[ray], radiance,
                  bake.per_side);
    }
}

// How far the point sees, blurred over a cone for every texel of its map.
void set_sight(SightMap& sight, const std::vector<glm::vec3>& directions,
               const std::vector<float>& distances) {
    for (int y = 0; y < kSightSide; ++y) {
        for (int x = 0; x < kSightSide; ++x) {
            const glm::vec3 axis = octahedral_direction(x, y, kSightSide);
            glm::vec2 sum(0.0f);
            float weights = 0.0f;
            for (std::size_t i = 0; i < directions.size(); ++i) {
                const float cosine = std::max(0.0f, glm::dot(axis, directions[i]));
                const float c2 = cosine * cosine, c4 = c2 * c2, c8 = c4 * c4, weight = c8 * c8 * c8;
                sum += glm::vec2(distances[i], distances[i] * distances[i]) * weight;
                weights += weight;
            }
            sight.moments[octahedral_index(x, y, kSightSide)] = sum / std::max(weights, 1e-20f);
        }
    }
}

void look_round(Bake& bake, std::size_t point) {
    const SceneView& view = bake.view;
    const Grid& grid = bake.result.grid;
    const glm::vec3 eye = grid.point_position(grid.point_from_index(point));
    const float farthest = 2.0f * glm::length(grid.spacing);  // beyond the cell it does not matter how far
    const float cone = std::sqrt(4.0f * kPi / static_cast<float>(bake.settings.rays));
    std::vector<float> distances(bake.directions.size(), farthest);
    int faces = 0, back_faces = 0;
    for (std::size_t i = 0; i < bake.directions.size(); ++i) {
        rc::Ray ray{.origin = eye, .direction = bake.directions[i]};
        glm::vec3 tint(1.0f);
        const auto hit = first_opaque(view, ray, tint);
        if (!hit) {
            add_sky(bake, point, i, tint);
            continue;
        }
        const float width = cone * glm::distance(eye, view.snapshot.scene->surface(*hit).position);
        const ShadingPoint at = shading_point(view, ray, *hit, width);
        ++faces;
        distances[i] = std::min(farthest, glm::distance(eye, at.surface.position));
        if (!at.is_entering && !at.material->is_double_sided) {
            ++back_faces;
            continue;  // the inside of a wall: dark
        }
        const glm::vec3 albedo = tint * glm::clamp(at.base_color, 0.0f, 0.95f);
        bake.patches[point * bake.directions.size() + i] = {at.surface.position, at.geometric, albedo};
        light_patch(bake, point, i, at, albedo);
        if (view.prepared.parts[at.part].lamp == world::kNoIndex) {  // bulbs are lamps and no part of this
            const std::size_t group = group_or(view.level.parts[at.part].lamp_group, bake.always);
            add_light(bake.first[group][point], bake.directions[i], tint * at.emission, bake.per_side);
        }
    }
    SightMap& sight = bake.result.sights[point];
    const float share = static_cast<float>(back_faces) / static_cast<float>(std::max(1, faces));
    bake.result.validity[point] = share > kMostBackFaces ? 0.0f : 1.0f;
    set_sight(sight, bake.directions, distances);
}

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
    for (std::size_t i = 0; i < rays; ++i) {
        const Patch& patch = bake.patches[point * rays + i];
        if (!(patch.albedo.x + patch.albedo.y + patch.albedo.z > 0.0f)) continue;
        const GridWeights weights = bake.result.weights(patch.position, patch.normal);
        std::bitset<kMostGroups> groups;
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

// A point inside a wall takes what those around it have, and counts a thousandth of them: for corners that see no other.
void fill_blind_points(AmbientBake& bake) {
    constexpr float kBlind = 1e-3f;
    const Grid& grid = bake.grid;
    const std::vector<float> sees = bake.validity;
    for (std::size_t point = 0; point < sees.size(); ++point) {
        if (sees[point] > 0.0f) continue;
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
              .is_lit_by = std::vector<std::bitset<kMostGroups>>(points)};
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
