// render/microfacets.h - GGX microfacets in a surface's own frame (z its normal): how many there are, how many can be
// seen, and how to pick one of those.
//
// `alpha` is roughness squared, > 0. Directions are unit, from the surface outwards; `eye.z` > 0.
// Same bits additions, multiplications, square roots.
#pragma once

#include "base/det_math.h"
#include "render/directions.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

// Density of facets that face `half`. Written with the sine, so that the narrowest lobes keep their digits.
[[nodiscard]] inline float facet_density(const glm::vec3& half, float alpha) {
    const float sin2 = half.x * half.x + half.y * half.y, cos2 = half.z * half.z;
    const float d = sin2 / alpha + cos2 * alpha;
    return 1.0f / (kPi * d * d);
}

// Smith's Lambda: facets in shadow for one in the light.
[[nodiscard]] inline float smith_lambda(const glm::vec3& way, float alpha) {
    const float tan2 = (way.x * way.x + way.y * way.y) / (way.z * way.z);
    return 0.5f * (std::sqrt(1.0f + alpha * alpha * tan2) - 1.0f);
}

// Density over solid angle of half vectors that pick_facet gives.
[[nodiscard]] inline float visible_density(const glm::vec3& eye, const glm::vec3& half, float alpha) {
    const float facing = std::max(0.0f, glm::dot(eye, half));
    return facet_density(half, alpha) * facing / ((1.0f + smith_lambda(eye, alpha)) * eye.z);
}

// A facet in proportion to how much of it the eye sees: a point on the spherical cap that the stretched hemisphere's
// reflections fill evenly (Dupuy and Benyoub 2023).
[[nodiscard]] inline glm::vec3 pick_facet(const glm::vec3& eye, float alpha, const glm::vec2& u) {
    const glm::vec3 stretched = glm::normalize(glm::vec3(alpha * eye.x, alpha * eye.y, eye.z));
    const glm::vec2 around = circle_point(u.x);
    const float z = (1.0f - u.y) * (1.0f + stretched.z) - stretched.z;
    const float sine = std::sqrt(std::clamp(1.0f - z * z, 0.0f, 1.0f));
    const glm::vec3 half(sine * around.x + stretched.x, sine * around.y + stretched.y, z + stretched.z);
    const glm::vec3 facet(alpha * half.x, alpha * half.y, std::max(half.z, 1e-9f));
    return glm::normalize(facet);
}

// The same four for facets that are drawn out: `alpha.x` along the frame's x, `alpha.y` along its y.
[[nodiscard]] inline float facet_density(const glm::vec3& half, const glm::vec2& alpha) {
    const float across = alpha.x * alpha.y;
    const float d = half.x * half.x * (alpha.y / alpha.x) + half.y * half.y * (alpha.x / alpha.y) +
                    half.z * half.z * across;
    return across / (kPi * d * d);
}

[[nodiscard]] inline float smith_lambda(const glm::vec3& way, const glm::vec2& alpha) {
    const float x = alpha.x * way.x, y = alpha.y * way.y;
    return 0.5f * (std::sqrt(1.0f + (x * x + y * y) / (way.z * way.z)) - 1.0f);
}

[[nodiscard]] inline float visible_density(const glm::vec3& eye, const glm::vec3& half,
                                           const glm::vec2& alpha) {
    const float facing = std::max(0.0f, glm::dot(eye, half));
    return facet_density(half, alpha) * facing / ((1.0f + smith_lambda(eye, alpha)) * eye.z);
}

[[nodiscard]] inline glm::vec3 pick_facet(const glm::vec3& eye, const glm::vec2& alpha, const glm::vec2& u) {
    const glm::vec3 stretched = glm::normalize(glm::vec3(alpha.x * eye.x, alpha.y * eye.y, eye.z));
    const glm::vec2 around = circle_point(u.x);
    const float z = (1.0f - u.y) * (1.0f + stretched.z) - stretched.z;
    const float sine = std::sqrt(std::clamp(1.0f - z * z, 0.0f, 1.0f));
    const glm::vec3 half(sine * around.x + stretched.x, sine * around.y + stretched.y, z + stretched.z);
    return glm::normalize(glm::vec3(alpha.x * half.x, alpha.y * half.y, std::max(half.z, 1e-9f)));
}

// What is left of the light of a facet that the eye sees when the other direction may be shadowed as well, correlated by
// height (Heitz 2014).
[[nodiscard]] inline float unshadowed_share(float lambda_eye, float lambda_light) {
    return (1.0f + lambda_eye) / (1.0f + lambda_eye + lambda_light);
}

}  // namespace gh::render
