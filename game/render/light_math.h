// render/light_math.h - small sums of light and of frames that many have in common.
#pragma once

#include "base/det_math.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>

namespace gh::render {

// Of the light that falls on it, what a white surface shows each way.
inline constexpr float kPerPi = 1.0f / kPi;

[[nodiscard]] inline float mean(const glm::vec3& c) {
    return (c.x + c.y + c.z) / 3.0f;
}

[[nodiscard]] inline glm::mat3 linear_part(const glm::mat4x3& m) {
    return glm::mat3(m[0], m[1], m[2]);
}

// Turns normals.
[[nodiscard]] inline glm::mat3 cofactors(const glm::mat3& m) {
    const glm::mat3 c(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return glm::dot(m[0], c[0]) < 0.0f ? -c : c;
}

}  // namespace gh::render
