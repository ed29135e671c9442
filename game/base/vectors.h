// base/vectors.h - what sim, sense and spatial ask of three numbers, with the order of the sums written out.
//
// glm's dot and length may add in another order in another version of glm, and the order decides the last bit:
// what decides the game calls these.
//
// Threads   pure.
#pragma once

#include <glm/vec3.hpp>

#include <cmath>

namespace gh {

inline constexpr glm::vec3 kUp{0.0f, 1.0f, 0.0f};

[[nodiscard]] inline float dot_of(const glm::vec3& a, const glm::vec3& b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

[[nodiscard]] inline glm::vec3 cross_of(const glm::vec3& a, const glm::vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[nodiscard]] inline float length_of(const glm::vec3& v) {
    return std::sqrt(dot_of(v, v));
}

}  // namespace gh
