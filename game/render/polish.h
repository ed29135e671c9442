// render/polish.h - by its roughness, what of a surface's gloss a mirrored ray shows, what lamps' highlights do, and what the
// baked light stands in for.
//
// Same bits pure.
#pragma once

#include "render/gloss.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace gh::render {

struct Polish {
    glm::vec3 f0{0.0f};
    float f90 = 0.0f;
    glm::vec3 glossy{0.0f};        // share of the light from all around that gloss gives back
    float ray_share = 0.0f;        // of that, what a mirrored ray is sent for
    float highlight_share = 0.0f;  // of lamps' bulbs, that is a highlight and not in the mirrored ray
    float shine = 0.0f;            // how much of highlights shows
};

// `f0`: what it gives back head on. `cos_eye` > 0: of the way to the eye with the normal.
[[nodiscard]] Polish polish_of(const GlossTable& gloss, const glm::vec3& f0, float metallic, float roughness,
                               float cos_eye);

// From this roughness on a dielectric sends no mirrored ray.
inline constexpr float kDullDielectric = 0.25f;
// Up to this one a metal is looked into, not at.
inline constexpr float kClearMirror = 0.06f;

// The direction a mirror sends a ray on. Where a bent normal would send it into the surface it just grazes it. Normals
// are unit.
[[nodiscard]] inline glm::vec3 mirrored_direction(const glm::vec3& direction, const glm::vec3& normal,
                                                  const glm::vec3& geometric) {
    glm::vec3 mirrored = direction - normal * (2.0f * glm::dot(direction, normal));
    const float height = glm::dot(mirrored, geometric);
    if (height < 0.01f) mirrored += geometric * (0.01f - height);
    return glm::normalize(mirrored);
}

}  // namespace gh::render
