#include "render/transmittance.h"

#include "base/contracts.h"
#include "base/det_math.h"
#include "render/fresnel.h"
#include "render/shading_point.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr int kCrossingsOfARay = 24;  // leaves and panes one behind the other; then it is dark

}  // namespace

rc::Ray onwards(const rc::Ray& ray, const rc::SurfacePoint& point) {
    if (!(ray.t_max < rc::kInfinity)) return rc::spawn_ray(point, ray.direction);
    return rc::spawn_ray_to(point, ray.origin + ray.direction * ray.t_max);
}

glm::vec3 absorbed(const world::Material& glass, float length) {
    if (!(glass.attenuation_distance < rc::kInfinity)) return glm::vec3(1.0f);
    const float times = length / glass.attenuation_distance;
    return {det::pow(glass.attenuation_color.x, times), det::pow(glass.attenuation_color.y, times),
            det::pow(glass.attenuation_color.z, times)};
}

glm::vec3 transmittance(const SceneView& view, const rc::Ray& shadow_ray) {
    rc::Ray ray = shadow_ray;
    glm::vec3 share(1.0f);
    const glm::vec3 direction = glm::normalize(ray.direction);
    std::uint32_t inside = rc::kNone;  // the instance of glass the ray is in
    glm::vec3 entry(0.0f);
    for (int i = 0; i < kCrossingsOfARay; ++i) {
        const auto hit = rc::closest_hit(*view.snapshot.scene, ray, world::Light);
        if (!hit) return share;
        if (!view.prepared.parts[hit->instance].is_clear) return glm::vec3(0.0f);
        const Clearness clear = clearness(view, *hit);
        share *= clear.share;
        if (!(std::max({share.x, share.y, share.z}) > 0.0f)) return glm::vec3(0.0f);
        if (clear.glass > 0.0f) {
            const bool is_solid = view.prepared.parts[hit->instance].is_solid_glass;
            const float cosine = std::abs(glm::dot(direction, clear.outward));
            const float mirrored = fresnel(cosine, clear.material->ior).reflectance;
            share *= 1.0f - (is_solid ? mirrored : thin_sheet_reflectance(mirrored));
            const bool is_entering = glm::dot(direction, clear.outward) < 0.0f;
            if (is_solid && is_entering) {
                inside = hit->instance;
                entry = clear.surface.position;
            } else if (is_solid && inside == hit->instance) {
                share *= absorbed(*clear.material, glm::distance(entry, clear.surface.position));
                inside = rc::kNone;
            }
        }
        ray = onwards(ray, clear.surface);
    }
    return glm::vec3(0.0f);
}

void ShadowBatch::answer(const SceneView& view, std::span<const rc::Ray> rays, std::span<glm::vec3> shares) {
    EXPECTS(rays.size() == shares.size());
    looked_through_ = 0;
    is_blocked_.resize(rays.size());
    rc::any_hits(*view.snapshot.scene, rays, view.prepared.blocking_layers, is_blocked_);
    for (std::size_t i = 0; i < rays.size(); ++i) shares[i] = glm::vec3(is_blocked_[i] != 0 ? 0.0f : 1.0f);
    if (!view.prepared.has_clear_parts) return;
    if (view.prepared.blocking_layers == world::Blocker) {
        look_through_what_is_left(view, rays, shares);
    } else {
        look_through_what_is_blocked(view, rays, shares);
    }
}

void ShadowBatch::look_through_what_is_blocked(const SceneView& view, std::span<const rc::Ray> rays,
                                               std::span<glm::vec3> shares) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (is_blocked_[i] == 0) continue;
        shares[i] = transmittance(view, rays[i]);
        ++looked_through_;
    }
}

void ShadowBatch::look_through_what_is_left(const SceneView& view, std::span<const rc::Ray> rays,
                                            std::span<glm::vec3> shares) {
    left_.clear();
    left_index_.clear();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (is_blocked_[i] != 0) continue;
        left_.push_back(rays[i]);
        left_index_.push_back(i);
    }
    meets_glass_.resize(left_.size());
    rc::any_hits(*view.snapshot.scene, left_, world::Clear, meets_glass_);
    for (std::size_t i = 0; i < left_.size(); ++i) {
        if (meets_glass_[i] == 0) continue;
        shares[left_index_[i]] = transmittance(view, left_[i]);
        ++looked_through_;
    }
}

}  // namespace gh::render
