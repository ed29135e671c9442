#include "sense/glass.h"

#include "base/det_math.h"
#include "world/layers.h"
#include "world/lookup.h"

#include "raycore/query.h"

#include <array>
#include <cmath>
#include <span>

namespace gh::sense {
namespace {

constexpr std::size_t kMaxSurfaces = 32;  // sixteen panes in a row are a wall

float length_of(const glm::vec3& v) {
    return std::sqrt((v.x * v.x + v.y * v.y) + v.z * v.z);
}

// What one surface leaves of the light.
glm::vec3 surface_share(const world::Material& material, float cosine) {
    const glm::vec3 through = material.transmission > 0.0f
                                  ? glm::vec3(material.base_color) * material.transmission
                                  : glm::vec3(1.0f - material.base_color.a);
    const float reflected = material.transmission > 0.0f ? fresnel_reflectance(cosine, material.ior) : 0.0f;
    return through * (1.0f - reflected);
}

// What `metres` of the inside leave of it.
glm::vec3 inside_share(const world::Material& material, float metres) {
    if (!(material.attenuation_distance < rc::kInfinity)) return glm::vec3(1.0f);
    const float exponent = metres / material.attenuation_distance;
    glm::vec3 share(0.0f);
    for (glm::length_t c = 0; c < 3; ++c) {
        const float colour = material.attenuation_color[c];
        if (colour > 0.0f) share[c] = colour >= 1.0f ? 1.0f : det::exp(exponent * det::log(colour));
    }
    return share;
}

// How far back along the hits the light entered the part that it leaves at hit `leaving`; none: it never entered.
float metres_inside(std::span<const rc::Hit> hits, std::span<const std::uint8_t> enters, std::size_t leaving,
                    float metres_per_t) {
    int depth = 0;
    for (std::size_t i = leaving; i-- > 0;) {
        if (hits[i].instance != hits[leaving].instance) continue;
        if (enters[i] == 0) {
            ++depth;
        } else if (depth-- == 0) {
            return (hits[leaving].t - hits[i].t) * metres_per_t;
        }
    }
    return 0.0f;
}

}  // namespace

bool lets_light_through(const world::Material& material) {
    return material.transmission > 0.0f ||
           (material.alpha_mode == world::AlphaMode::Blend && material.base_color.a < 1.0f);
}

float fresnel_reflectance(float cosine, float ior) {
    const float cos_i = cosine < 1.0f ? cosine : 1.0f;
    const float sin2_t = (1.0f - cos_i * cos_i) / (ior * ior);
    if (!(sin2_t < 1.0f)) return 1.0f;
    const float cos_t = std::sqrt(1.0f - sin2_t);
    const float parallel = (ior * cos_i - cos_t) / (ior * cos_i + cos_t);
    const float across = (cos_i - ior * cos_t) / (cos_i + ior * cos_t);
    return 0.5f * (parallel * parallel + across * across);
}

glm::vec3 light_transmittance(const world::Level& level, const rc::Scene& scene, const glm::vec3& from,
                              const glm::vec3& to, std::uint32_t source_part) {
    std::array<rc::Hit, kMaxSurfaces> hits;
    std::array<std::uint8_t, kMaxSurfaces> enters{};
    const std::size_t count = rc::crossings(scene, from, to, world::Light, hits);
    const glm::vec3 way = to - from;
    const float metres = length_of(way);
    glm::vec3 share(1.0f);
    for (std::size_t i = 0; i < count; ++i) {
        if (hits[i].instance == source_part) return share;
        const world::Material& material = world::material_at(level, hits[i]);
        if (!lets_light_through(material)) return glm::vec3(0.0f);
        const glm::vec3 normal = scene.surface(hits[i]).normal;
        const float along = (normal.x * way.x + normal.y * way.y) + normal.z * way.z;
        enters[i] = along < 0.0f ? 1 : 0;
        share *= surface_share(material, metres > 0.0f ? std::abs(along) / metres : 1.0f);
        if (enters[i] == 0) share *= inside_share(material, metres_inside(hits, enters, i, metres));
    }
    return count == kMaxSurfaces ? glm::vec3(0.0f) : share;
}

}  // namespace gh::sense
