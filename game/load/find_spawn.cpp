#include "load/defaults.h"
#include "load/part_geometry.h"
#include "world/layers.h"

#include "raycore/query.h"
#include "raycore/scene.h"

#include <array>
#include <cmath>
#include <limits>

namespace gh::load {
namespace {

constexpr float kHeadroom = 1.85f;   // metres over the ground
constexpr float kElbowRoom = 0.45f;  // to every side, at knee and chest
constexpr float kEyeHeight = 1.6f;
constexpr float kLevelEnough = 0.64f;  // cosine of 50 degrees
constexpr float kDiagonal = 0.70710678f;
constexpr std::array<glm::vec2, 8> kWays{{{0, -1},
                                          {-kDiagonal, -kDiagonal},
                                          {-1, 0},
                                          {-kDiagonal, kDiagonal},
                                          {0, 1},
                                          {kDiagonal, kDiagonal},
                                          {1, 0},
                                          {kDiagonal, -kDiagonal}}};
constexpr float kEighth = 0.78539816f;  // radians: way i looks along yaw i eighths of a turn

std::shared_ptr<const rc::Scene> solid_scene(const world::Level& level) {
    std::vector<std::shared_ptr<const rc::Blas>> trees(level.meshes.size());
    rc::SceneBuilder builder;
    for (const world::Part& part : level.parts) {
        if ((part.layers & world::Solid) == 0 || part.mover == world::Mover::Guard) continue;
        std::shared_ptr<const rc::Blas>& tree = trees[part.mesh];
        const world::Mesh& mesh = level.meshes[part.mesh];
        if (!tree) tree = rc::build_blas({mesh.positions, mesh.triangles}, {rc::BuildQuality::Fast});
        builder.add({tree, world_from_part_at_rest(level, part), part.layers});
    }
    return builder.commit();
}

bool is_free(const rc::Scene& scene, const glm::vec3& from, const glm::vec3& way) {
    return !rc::any_hit(scene, {.origin = from, .direction = way, .t_max = 1.0f}, world::Solid);
}

bool has_elbow_room(const rc::Scene& scene, const glm::vec3& feet) {
    for (const float height : {0.5f, 1.3f}) {
        for (const glm::vec2& way : kWays) {
            const glm::vec3 aside(way.x * kElbowRoom, 0.0f, way.y * kElbowRoom);
            if (!is_free(scene, feet + glm::vec3(0.0f, height, 0.0f), aside)) return false;
        }
    }
    return true;
}

float farthest_yaw(const rc::Scene& scene, const glm::vec3& feet, float reach) {
    float best_yaw = 0.0f, best = -1.0f;
    for (std::size_t i = 0; i < kWays.size(); ++i) {
        const rc::Ray look{.origin = feet + glm::vec3(0.0f, kEyeHeight, 0.0f),
                           .direction = {kWays[i].x, 0.0f, kWays[i].y},
                           .t_max = reach};
        const std::optional<rc::Hit> hit = rc::closest_hit(scene, look, world::kEverything);
        const float distance =
            hit ? hit->t : 0.5f * reach;  // looking out of the place is worth less than a long room
        if (distance <= best) continue;
        best = distance;
        best_yaw = kEighth * static_cast<float>(i);
    }
    return best_yaw;
}

struct Search {
    const rc::Scene& scene;
    rc::Box box;
    float size;
    float best_cost = std::numeric_limits<float>::infinity();
    std::optional<glm::vec3> best;
    std::optional<glm::vec3> highest;  // the fallback: the first thing met from above nearest the middle
};

// Looks at every floor below (x, z): near the middle, low, and under a roof is better.
void try_column(Search& search, float x, float z, float from_middle) {
    std::array<rc::Hit, 64> hits;
    const glm::vec3 top(x, search.box.max.y + 1.0f, z), bottom(x, search.box.min.y - 1.0f, z);
    const std::size_t count = rc::crossings(search.scene, top, bottom, world::Solid, hits);
    for (std::size_t i = 0; i < count; ++i) {
        const rc::SurfacePoint ground = search.scene.surface(hits[i]);
        if (!search.highest) search.highest = ground.position;
        if (std::abs(ground.normal.y) < kLevelEnough) continue;
        const bool has_roof = i > 0;
        const float cost =
            from_middle + 2.0f * (ground.position.y - search.box.min.y) + (has_roof ? 0.0f : search.size);
        if (!(cost < search.best_cost)) continue;
        const rc::Ray up = rc::spawn_ray(ground, {0.0f, 1.0f, 0.0f}, kHeadroom);
        if (rc::any_hit(search.scene, up, world::Solid) || !has_elbow_room(search.scene, ground.position))
            continue;
        search.best_cost = cost;
        search.best = ground.position;
    }
}

}  // namespace

world::Spawn find_spawn(const world::Level& level) {
    const std::shared_ptr<const rc::Scene> scene = solid_scene(level);
    const rc::Box box = scene->bounds();
    if (!(box.min.x <= box.max.x)) return {};
    const glm::vec3 extent = box.max - box.min, middle = 0.5f * (box.min + box.max);
    Search search{*scene, box, std::max(extent.x, extent.z), std::numeric_limits<float>::infinity(), {}, {}};
    constexpr int kHalf = 6;  // columns on either side of the middle
    for (int ring = 0; ring <= kHalf; ++ring) {
        for (int i = -ring; i <= ring; ++i) {
            for (int k = -ring; k <= ring; ++k) {
                if (std::max(std::abs(i), std::abs(k)) != ring) continue;
                const glm::vec2 off = glm::vec2(extent.x, extent.z) * (0.5f / (kHalf + 0.5f)) *
                                      glm::vec2(static_cast<float>(i), static_cast<float>(k));
                try_column(search, middle.x + off.x, middle.z + off.y,
                           std::sqrt(off.x * off.x + off.y * off.y));
            }
        }
    }
    const glm::vec3 on_top(middle.x, box.max.y, middle.z);
    const glm::vec3 feet = search.best.value_or(search.highest.value_or(on_top));
    return {feet, farthest_yaw(*scene, feet, search.size)};
}

}  // namespace gh::load
