// render/gloss.h - GGX (Walter et al. 2007): highlights, and how much a glossy surface mirrors in all.
//
// `alpha` is roughness squared, as in glTF. Directions are given by their cosines with the normal, > 0.
// Same bits pure.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>

namespace gh::render {

// Density of microfacets that face the half vector.
[[nodiscard]] float ggx_density(float cos_half, float alpha);

// Shadowing and masking of both directions, correlated (Heitz 2014), over 4 cos cos.
[[nodiscard]] float ggx_visibility(float cos_eye, float cos_light, float alpha);

// Share of the light from everywhere that a glossy surface sends to the eye, by roughness and angle; integrated
// numerically once.
class GlossTable {
  public:
    GlossTable();

    // For Fresnel f0 head on and f90 at grazing angles; never more than 1.
    [[nodiscard]] glm::vec3 albedo(const glm::vec3& f0, float f90, float cos_eye, float roughness) const;

  private:
    static constexpr int kSide = 24;
    struct Share {
        float of_f0;
        float of_f90;
    };
    std::array<Share, static_cast<std::size_t>(kSide) * kSide> shares_{};  // [roughness][cosine]
};

}  // namespace gh::render
