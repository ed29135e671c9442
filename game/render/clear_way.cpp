#include "render/clear_way.h"

#include "render/fresnel.h"
#include "render/sane.h"
#include "render/shading_point.h"
#include "render/transmittance.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr int kCrossingsOfAWay = 32;  // leaves and panes one behind the other; then it is dark

bool is_black(const glm::vec3& c) {
    return !(std::max({c.x, c.y, c.z}) > 0.0f);
}

}  // namespace

bool is_smooth_glass(const world::Material& material) {
    constexpr float kSmoothRoughness = 0.01f;  // as bsdf.cpp has it, squared
    return !(material.roughness >= kSmoothRoughness);
}

ClearWay follow(const SceneView& view, const rc::Ray& whole, const rc::Hit& first, const WayRules& rules) {
    ClearWay way;
    way.end = first;
    rc::Ray ray = whole;
    const glm::vec3 direction = glm::normalize(whole.direction);
    const world::Material* inside = rules.inside;
    glm::vec3 entry = rules.start;
    for (int i = 0; !way.end.is_miss(); ++i) {
        const std::uint32_t part = way.end.instance;
        if (part == rules.target || !view.prepared.parts[part].is_clear) break;
        const Clearness clear = clearness(view, way.end);
        const bool is_solid = view.prepared.parts[part].is_solid_glass;
        const bool passes_glass =
            clear.glass > 0.0f && is_smooth_glass(*clear.material) && (!is_solid || rules.passes_solid_glass);
        glm::vec3 share = sane_colour(clear.share);
        if (clear.glass > 0.0f) {
            const float cosine = std::abs(glm::dot(direction, clear.outward));
            const float mirrored = fresnel(cosine, sane(clear.material->ior, 1.0f, 5.0f)).reflectance;
            const float lost = passes_glass ? (is_solid ? mirrored : thin_sheet_reflectance(mirrored)) : 1.0f;
            // Holes let everything through, glass its share; both together only in holed glass.
            const glm::vec3 glass = sane_colour(clear.glass_share);
            share = glm::max(share - glass, glm::vec3(0.0f)) + glass * (1.0f - lost);
        }
        way.share *= share;
        if (i == kCrossingsOfAWay) way.share = glm::vec3(0.0f);
        if (is_black(way.share)) break;
        if (passes_glass && is_solid) {
            if (glm::dot(direction, clear.outward) < 0.0f) {
                inside = clear.material;
                entry = clear.surface.position;
            } else if (inside != nullptr) {
                way.share *= absorbed(*inside, glm::distance(entry, clear.surface.position));
                inside = nullptr;
            }
        }
        ray = onwards(ray, clear.surface);
        way.end = {};
        if (const auto next = rc::closest_hit(*view.snapshot.scene, ray, world::Light)) way.end = *next;
    }
    if (inside != nullptr && !is_black(way.share)) {
        const glm::vec3 end = way.end.is_miss() ? ray.origin + ray.direction * ray.t_max
                                                : view.snapshot.scene->surface(way.end).position;
        const float length = glm::distance(entry, end);
        if (length < rc::kInfinity) way.share *= absorbed(*inside, length);
    }
    return way;
}

}  // namespace gh::render
