#include "bench_rays.h"

#include "support/random.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace bench {

namespace {

constexpr int kWidth = 1280, kHeight = 720, kTile = 8;

std::vector<rc::Ray> primary_rays(const Camera& camera, int keep) {
    const float cy = std::cos(camera.yaw), sy = std::sin(camera.yaw), cp = std::cos(camera.pitch),
                sp = std::sin(camera.pitch);
    const glm::vec3 forward(-sy * cp, sp, -cy * cp), right(cy, 0, -sy), up = glm::cross(right, forward);
    const float half = std::tan(0.5f * camera.fov);
    std::vector<rc::Ray> rays;
    int tile = 0;
    for (int ty = 0; ty < kHeight; ty += kTile) {
        for (int tx = 0; tx < kWidth; tx += kTile) {
            if (tile++ % keep != 0) continue;
            for (int i = 0; i < kTile * kTile; ++i) {
                const int column = tx + i % kTile, row = ty + i / kTile;
                const float x = (2.0f * (float(column) + 0.5f) - kWidth) / kHeight * half;
                const float y = (1.0f - 2.0f * (float(row) + 0.5f) / kHeight) * half;
                rays.push_back(
                    {.origin = camera.position, .direction = glm::normalize(forward + right * x + up * y)});
            }
        }
    }
    return rays;
}

glm::vec3 cosine_direction(test::Random& random, const glm::vec3& normal) {
    const glm::vec3 v = normal + random.direction() * 0.9999f;
    return glm::normalize(v);
}

}  // namespace

std::vector<RaySet> make_ray_sets(const BenchScene& scene, const rc::Scene& built, int keep) {
    test::Random random(5);
    RaySet primary{"primary", false, primary_rays(scene.camera, keep)};
    RaySet shadow{"shadow", true, {}}, occlusion{"ao", true, {}}, diffuse{"diffuse", false, {}};
    const rc::Box bounds = built.bounds();
    const float reach = glm::length(bounds.max - bounds.min) * 0.05f;
    const glm::vec3 lamp_size = scene.lamp_high - scene.lamp_low;
    for (const rc::Ray& ray : primary.rays) {
        const std::optional<rc::Hit> hit = rc::closest_hit(built, ray, rc::kAllLayers);
        if (!hit) continue;
        rc::SurfacePoint point = built.surface(*hit);
        if (glm::dot(point.normal, ray.direction) > 0) point.normal = -point.normal;
        const glm::vec3 share(random.unit(), random.unit(), random.unit());
        shadow.rays.push_back(rc::spawn_ray_to(point, scene.lamp_low + lamp_size * share));
        occlusion.rays.push_back(rc::spawn_ray(point, cosine_direction(random, point.normal), reach));
        diffuse.rays.push_back(rc::spawn_ray(point, cosine_direction(random, point.normal)));
    }
    std::vector<RaySet> sets;
    for (RaySet* set : {&primary, &shadow, &occlusion, &diffuse}) {
        for (rc::Ray& ray : set->rays) {  // peers know no skipping; nobody is asked to
            ray.skip_instance = ray.skip_primitive = rc::kNone;
        }
        sets.push_back(std::move(*set));
    }
    return sets;
}

}  // namespace bench
