// render/sane.h - numbers from files made safe to compute with.
//
// Same bits pure.
#pragma once

#include <glm/vec3.hpp>

namespace gh::render {

// Within [low, high]; NaN counts as low.
[[nodiscard]] inline float sane(float x, float low, float high) {
    if (!(x > low)) return low;
    return x < high ? x : high;
}

[[nodiscard]] inline glm::vec3 sane_colour(const glm::vec3& c) {
    return {sane(c.x, 0.0f, 1.0f), sane(c.y, 0.0f, 1.0f), sane(c.z, 0.0f, 1.0f)};
}

// Light that is sent out: never negative, and small enough that sums stay finite.
[[nodiscard]] inline glm::vec3 sane_light(const glm::vec3& c) {
    constexpr float kMost = 1e12f;
    return {sane(c.x, 0.0f, kMost), sane(c.y, 0.0f, kMost), sane(c.z, 0.0f, kMost)};
}

}  // namespace gh::render
