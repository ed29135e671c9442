#include "sense/glass.h"

#include "base/det_math.h"
#include "base/vectors.h"
#include "sense/faces.h"
#include "world/layers.h"

#include <array>
#include <cmath>
#include <span>

namespace gh::sense {
namespace {

// What one surface leaves of the light.
glm::vec3 surface_share(const world::Material& material, float cosine, bool is_sheet) {
    if (!(material.transmission > 0.0f)) return glm::vec3(1.0f - material.base_color.a);
    const float once = fresnel_reflectance(cosine, material.ior);
    const float reflected =
        is_sheet ? 2.0f * once / (1.0f + once) : once;  // a sheet's two borders, summed up
    return glm::vec3(material.base_color) * (material.transmission * (1.0f - reflected));
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

// The face that closes what faces[i] opens, or opened what it closes, as brackets pair; kMaxFaces: a sheet has none.
std::size_t partner_of(std::span<const Face> faces, std::size_t i) {
    const std::size_t step = faces[i].enters ? std::size_t{1} : static_cast<std::size_t>(-1);
    int depth = 0;
    for (std::size_t j = i + step; j < faces.size(); j += step) {  // leaves the range at either end
        if (faces[j].part != faces[i].part) continue;
        if (faces[j].enters == faces[i].enters) {
            ++depth;
        } else if (depth-- == 0) {
            return j;
        }
    }
    return kMaxFaces;
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
    std::array<Face, kMaxFaces> storage;
    const Faces met = faces_between(level, scene, from, to, world::Light, storage);
    const std::span<const Face> faces = std::span(storage).first(met.count);
    const float metres = length_of(to - from);
    glm::vec3 share(1.0f);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (faces[i].part == source_part) return share;
        if (!lets_light_through(*faces[i].material)) return glm::vec3(0.0f);
        const std::size_t partner = partner_of(faces, i);
        share *= surface_share(*faces[i].material, faces[i].cosine, partner == kMaxFaces);
        if (partner < i) share *= inside_share(*faces[i].material, (faces[i].t - faces[partner].t) * metres);
    }
    return met.is_complete ? share : glm::vec3(0.0f);
}

}  // namespace gh::sense
