// sim/geometry.h - lengths and flat distances, by sqrt alone (glm's normalise and length may differ between
// versions of glm).
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace gh::sim {

[[nodiscard]] inline float length_of(const glm::vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

[[nodiscard]] inline glm::vec3 flat(const glm::vec3& v) { return {v.x, 0.0f, v.z}; }

[[nodiscard]] inline float flat_length(const glm::vec3& v) { return std::sqrt(v.x * v.x + v.z * v.z); }

// Unit, or zero when there is no direction to keep.
[[nodiscard]] inline glm::vec3 unit_or_zero(const glm::vec3& v) {
    const float length = length_of(v);
    return length > 1e-9f ? v / length : glm::vec3(0.0f);
}

// `from` moved towards `to` by at most `step`.
[[nodiscard]] inline float towards(float from, float to, float step) {
    return from + std::clamp(to - from, -step, step);
}

}  // namespace gh::sim
