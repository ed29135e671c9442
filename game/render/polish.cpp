#include "render/polish.h"

#include "render/fresnel.h"

#include <glm/common.hpp>

#include <algorithm>

namespace gh::render {

namespace {

// Roughness: below the first pair a bulb is seen in the mirrored ray, above it as a highlight; above the second pair
// no ray is sent and the ambient light stands in for what is mirrored.
constexpr float kMirrorBelow = kClearMirror, kHighlightAbove = 0.14f;
constexpr float kRayBelow = 0.15f;                                // dielectrics
constexpr float kMetalRayBelow = 0.25f, kNoMetalRayAbove = 0.4f;  // whose reflection is all they show
constexpr float kDull = 0.6f,
                kDullest = 0.8f;  // highlights of rough dielectrics fade into their diffuse light

float smooth_step(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

}  // namespace

Polish polish_of(const GlossTable& gloss, const glm::vec3& f0, float metallic, float roughness,
                 float cos_eye) {
    Polish polish;
    polish.f0 = f0;
    polish.f90 = grazing_share(f0);
    polish.glossy = gloss.albedo(f0, polish.f90, cos_eye, roughness);
    polish.ray_share = 1.0f - smooth_step(glm::mix(kRayBelow, kMetalRayBelow, metallic),
                                          glm::mix(kDullDielectric, kNoMetalRayAbove, metallic), roughness);
    polish.highlight_share = smooth_step(kMirrorBelow, kHighlightAbove, roughness);
    polish.shine =
        polish.highlight_share * (1.0f - (1.0f - metallic) * smooth_step(kDull, kDullest, roughness));
    return polish;
}

}  // namespace gh::render
