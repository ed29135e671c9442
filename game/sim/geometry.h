// sim/geometry.h - flat distances and directions, by sqrt alone; base/vectors.h says why not by glm.
#pragma once

#include "base/vectors.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace gh::sim {

using gh::length_of;  // for those outside who reckon with the simulation's geometry

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
