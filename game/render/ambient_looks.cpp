#include "render/ambient_looks.h"

#include "base/det_math.h"
#include "base/random.h"
#include "render/ambient_gleams.h"
#include "render/directions.h"
#include "render/light_math.h"
#include "render/octahedron.h"
#include "render/sampler.h"
#include "render/shading_point.h"
#include "render/sky.h"
#include "render/transmittance.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace gh::render {

namespace {

constexpr float kFaintestLook = 1e-4f;  // W/m2
// Of the faces a point sees: one that sees more insides of walls is in a wall, and one that sees more backs of anything,
// though a sheet may well have two sides, is in a piece of furniture.
constexpr float kMostWalls = 0.25f, kMostBacks = 0.6f;
constexpr std::size_t kFirstLooks =
    24;  // that tell whether a point is in the open, before the others are sent
constexpr int kCrossingsOfALook = 6;

// What leaves a patch towards a grid point, by the lamp group it is owed to.
struct Arrival {
    std::size_t group = 0;
    glm::vec3 radiance{0.0f};
};

// Which of a cube's sides a direction adds to along an axis.
std::size_t side_of(const glm::vec3& direction, std::size_t axis) {
    return 2 * axis + (direction[axis] < 0.0f ? 1 : 0);
}

std::size_t group_or(std::uint32_t group, std::size_t always) {
    return group == world::kNoIndex ? always : group;
}

// Follows a ray through glass to something opaque; `tint` becomes what is left of the light.
std::optional<rc::Hit> first_opaque(const SceneView& view, rc::Ray& ray, glm::vec3& tint) {
    for (int i = 0; i < kCrossingsOfALook; ++i) {
        const auto hit = rc::closest_hit(*view.snapshot.scene, ray, world::Light);
        if (!hit || !view.prepared.parts[hit->instance].is_clear) return hit;
        const Clearness clear = clearness(view, *hit);
        if (!(clear.share.x + clear.share.y + clear.share.z > 0.0f)) return hit;
        tint *= clear.share;
        ray = rc::spawn_ray(clear.surface, ray.direction);
    }
    return std::nullopt;
}

// Radiance that leaves the patch because one lamp shines on it; `seed` says which point of the lamp is asked.
glm::vec3 radiance_by(const Bake& bake, std::uint32_t id, const ShadingPoint& at, const glm::vec3& albedo,
                      std::uint32_t seed) {
    const world::Lamp& lamp = bake.view.level.lamps[id];
    const glm::vec3 irradiance = lamp_irradiance(lamp, at.surface.position, at.geometric);
    if (!(std::max({irradiance.x, irradiance.y, irradiance.z}) > kFaintestLook)) return glm::vec3(0.0f);
    const glm::vec3 target = lamp_point(lamp, at.surface.position, sobol_point(0, seed));
    if (lamp.shape != world::LampShape::Sun && glm::dot(target - at.surface.position, at.geometric) <= 0.0f)
        return glm::vec3(0.0f);
    const auto shadow = shadow_ray(lamp, bake.view.prepared.bulbs[id], at.surface, target);
    const glm::vec3 share =
        !shadow ? glm::vec3(1.0f)
        : rc::any_hit(*bake.view.snapshot.scene, *shadow, world::Light)
            ? (bake.view.prepared.has_clear_parts ? transmittance(bake.view, *shadow) : glm::vec3(0.0f))
            : glm::vec3(1.0f);
    return albedo * irradiance * share * kPerPi;
}

// The light of a glowing part that is no lamp.
Arrival glow_of(const Bake& bake, const ShadingPoint& at, const glm::vec3& tint) {
    const world::Part& part = bake.view.level.parts[at.part];
    const bool is_bulb = bake.view.prepared.parts[at.part].lamp != world::kNoIndex;
    return {group_or(part.lamp_group, bake.always), is_bulb ? glm::vec3(0.0f) : tint * at.emission};
}

void light_patch(Bake& bake, std::size_t point, std::size_t ray, const ShadingPoint& at,
                 const glm::vec3& tint, std::span<const AimedAt> gleams) {
    const glm::vec3& position = at.surface.position;
    const glm::vec3& direction = bake.directions[ray];
    const glm::vec3& albedo = bake.patches[point * bake.directions.size() + ray].albedo;
    for (const std::uint32_t id : bake.view.prepared.lamp_lists.at(position)) {
        if (is_left_out(gleams, id, position)) continue;
        const std::uint32_t seed =
            hash_u32(static_cast<std::uint32_t>(point), static_cast<std::uint32_t>(ray), id);
        const std::size_t group = group_or(bake.view.level.lamps[id].group, bake.always);
        add_light(bake.first[group][point], direction, radiance_by(bake, id, at, albedo, seed),
                  bake.per_side);
    }
    if (is_within_any(gleams, position)) return;
    const Arrival glow = glow_of(bake, at, tint);
    add_light(bake.first[glow.group][point], direction, glow.radiance, bake.per_side);
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

// A wall seen from within, or from outside the house: whatever glTF says of a shell's material, it has one side.
bool is_inside_of_wall(const SceneView& view, const ShadingPoint& at) {
    return !at.is_entering && (!at.material->is_double_sided || view.level.parts[at.part].is_shell);
}

// One ray of those all around: whether it met a face, whether the back of one, whether the inside of a wall.
struct Look {
    bool meets = false, is_back = false, is_wall = false;
};
Look look_along(Bake& bake, std::size_t point, std::size_t ray_index, const glm::vec3& eye,
                std::span<const AimedAt> gleams, float& distance) {
    const SceneView& view = bake.view;
    rc::Ray ray{.origin = eye, .direction = bake.directions[ray_index]};
    glm::vec3 tint(1.0f);
    const auto hit = first_opaque(view, ray, tint);
    if (!hit) {
        add_sky(bake, point, ray_index, tint);
        return {};
    }
    const float cone = std::sqrt(4.0f * kPi / static_cast<float>(bake.directions.size()));
    const float width = cone * glm::distance(eye, view.snapshot.scene->surface(*hit).position);
    const ShadingPoint at = shading_point(view, ray, *hit, width);
    distance = std::min(distance, glm::distance(eye, at.surface.position));
    if (is_inside_of_wall(view, at)) return {.meets = true, .is_back = true, .is_wall = true};  // dark
    const glm::vec3 albedo = tint * glm::clamp(at.base_color, 0.0f, 0.95f);
    bake.patches[point * bake.directions.size() + ray_index] = {at.surface.position, at.geometric, albedo};
    light_patch(bake, point, ray_index, at, tint, gleams);
    return {.meets = true, .is_back = !at.is_entering};
}

// Rays spread evenly over the cone that holds the gleam, each for its share of the cone.
void look_at_gleam(Bake& bake, std::size_t point, const glm::vec3& eye, std::span<const AimedAt> before,
                   const AimedAt& gleam) {
    constexpr float kGoldenRatio = 0.618033989f;
    const SceneView& view = bake.view;
    const Basis basis = basis_around(gleam.axis);
    const auto count = static_cast<float>(bake.settings.gleam_rays);
    const float share = kTwoPi * gleam.one_minus_cos / count;  // steradians
    const std::uint32_t seed = hash_u32(static_cast<std::uint32_t>(point), gleam.lamp, 0x61EA);
    const float start = static_cast<float>(seed >> 8) * 0x1p-24f;
    PerSide per_side;
    per_side.fill(share);
    for (int i = 0; i < bake.settings.gleam_rays; ++i) {
        const float turns = start + kGoldenRatio * static_cast<float>(i);
        const glm::vec2 u((static_cast<float>(i) + 0.5f) / count, turns - std::floor(turns));
        const glm::vec3 direction = basis.world_from_local(uniform_cone(u, gleam.one_minus_cos));
        rc::Ray ray{.origin = eye, .direction = direction};
        glm::vec3 tint(1.0f);
        const auto hit = first_opaque(view, ray, tint);
        if (!hit) continue;
        const ShadingPoint at = shading_point(view, ray, *hit, gleam.ball.radius / count);
        if (!gleam.holds(at.surface.position) || is_inside_of_wall(view, at)) continue;
        const glm::vec3 albedo = tint * glm::clamp(at.base_color, 0.0f, 0.95f);
        const std::size_t group = group_or(view.level.lamps[gleam.lamp].group, bake.always);
        const glm::vec3 radiance =
            radiance_by(bake, gleam.lamp, at, albedo, hash_u32(seed, static_cast<std::uint32_t>(i)));
        add_light(bake.first[group][point], direction, radiance, per_side);
        if (is_within_any(before, at.surface.position)) continue;  // two shades side by side: it was counted
        const Arrival glow = glow_of(bake, at, tint);
        add_light(bake.first[glow.group][point], direction, glow.radiance, per_side);
    }
}

// What a place sees, and, if it lies within a wall, how to get out of it.
struct Outlook {
    float faces = 0.0f, backs = 0.0f, walls = 0.0f;
    float nearest = rc::kInfinity;  // inside of a wall, metres
    glm::vec3 way_out{0.0f};        // unit

    [[nodiscard]] bool is_blind() const { return walls > kMostWalls * faces || backs > kMostBacks * faces; }
    [[nodiscard]] bool is_surely_blind() const {
        return walls > 2.0f * kMostWalls * faces || backs > 1.3f * kMostBacks * faces;
    }
};

Outlook look_from(Bake& bake, std::size_t point, const glm::vec3& eye) {
    const float farthest =
        2.0f * glm::length(bake.result.grid.spacing);  // beyond the cell it does not matter how far
    const std::size_t rays = bake.directions.size();
    std::vector<float> distances(rays, farthest);
    const AimedAtAll gleams = gleams_around(bake.view, eye);
    Outlook out;
    for (std::size_t i = 0; i < rays; ++i) {
        const Look look = look_along(bake, point, i, eye, gleams.all(), distances[i]);
        out.faces += look.meets ? 1.0f : 0.0f;
        out.backs += look.is_back ? 1.0f : 0.0f;
        out.walls += look.is_wall ? 1.0f : 0.0f;
        if (look.is_wall && distances[i] < out.nearest) {
            out.nearest = distances[i];
            out.way_out = bake.directions[i];
        }
        if (i + 1 == kFirstLooks && out.is_surely_blind()) break;
    }
    if (out.is_blind()) return out;
    for (std::size_t i = 0; i < gleams.count; ++i)
        look_at_gleam(bake, point, eye, gleams.all().first(i), gleams.gleam[i]);
    set_sight(bake.result.sights[point], bake.directions, distances);
    return out;
}

void forget(Bake& bake, std::size_t point) {
    for (std::vector<AmbientCube>& cubes : bake.first) cubes[point] = {};
    const std::size_t rays = bake.directions.size();
    std::fill_n(bake.patches.begin() + static_cast<std::ptrdiff_t>(point * rays), rays, Patch{});
}

}  // namespace

std::vector<glm::vec3> even_directions(int count) {
    constexpr float kGoldenAngle = 2.39996322972865332f;
    int step = std::max(1, count * 5 / 8);
    while (std::gcd(step, count) > 1) ++step;
    std::vector<glm::vec3> directions;
    directions.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
        const int i = k * step % count;
        const float y = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
        const auto [sine, cosine] = det::sin_cos(kGoldenAngle * static_cast<float>(i));
        const float radius = std::sqrt(1.0f - y * y);
        directions.emplace_back(radius * cosine, y, radius * sine);
    }
    return directions;
}

PerSide light_per_side(const std::vector<glm::vec3>& directions) {
    PerSide sum{};
    for (const glm::vec3& d : directions) {
        for (std::size_t axis = 0; axis < 3; ++axis) sum[side_of(d, axis)] += std::abs(d[axis]);
    }
    for (float& side : sum) side = kPi / std::max(side, 1e-20f);
    return sum;
}

void add_light(AmbientCube& cube, const glm::vec3& direction, const glm::vec3& radiance,
               const PerSide& per_side) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t side = side_of(direction, axis);
        cube.face[side] += radiance * (std::abs(direction[axis]) * per_side[side]);
    }
}

void look_round(Bake& bake, std::size_t point) {
    constexpr float kClear = 0.15f;    // metres beyond the wall
    constexpr float kFarthest = 0.5f;  // of the least spacing
    constexpr float kMoved = 0.25f;    // what it says counts less than what is seen from the point itself
    const Grid& grid = bake.result.grid;
    const glm::vec3 eye = grid.point_position(grid.point_from_index(point));
    const Outlook here = look_from(bake, point, eye);
    bake.result.validity[point] = here.is_blind() ? 0.0f : 1.0f;
    if (!here.is_blind()) return;
    forget(bake, point);
    if (!(here.nearest + kClear < kFarthest * std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z})))
        return;
    const Outlook there = look_from(bake, point, eye + here.way_out * (here.nearest + kClear));
    if (there.is_blind()) {
        forget(bake, point);
    } else {
        bake.result.validity[point] = kMoved;
    }
}

}  // namespace gh::render
