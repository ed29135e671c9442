// render/directions.h - uniform numbers turned into directions: circles, discs, hemispheres, cones, spheres; and the
// frame of a surface to have them in.
//
// Cost      a few nanoseconds each: no call into a maths library.
// Same bits additions, multiplications and square roots only.
#pragma once

#include "base/det_math.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

// Right-handed, orthonormal; a surface's `normal` is its z.
struct Basis {
    glm::vec3 tangent{1.0f, 0.0f, 0.0f};
    glm::vec3 bitangent{0.0f, 1.0f, 0.0f};
    glm::vec3 normal{0.0f, 0.0f, 1.0f};

    [[nodiscard]] glm::vec3 world_from_local(const glm::vec3& v) const {
        return tangent * v.x + bitangent * v.y + normal * v.z;
    }
    [[nodiscard]] glm::vec3 local_from_world(const glm::vec3& v) const {
        return {glm::dot(v, tangent), glm::dot(v, bitangent), glm::dot(v, normal)};
    }
};

// Around a unit normal, without a direction where it fails (Duff et al. 2017).
[[nodiscard]] inline Basis basis_around(const glm::vec3& normal) {
    const float sign = std::copysign(1.0f, normal.z);
    const float a = -1.0f / (sign + normal.z);
    const float b = normal.x * normal.y * a;
    return {{1.0f + sign * normal.x * normal.x * a, sign * b, -sign * normal.x},
            {b, sign + normal.y * normal.y * a, -normal.y},
            normal};
}

// (cos, sin) of `turns` full turns, for turns in [0, 1]; within 2e-7 of the truth.
[[nodiscard]] inline glm::vec2 circle_point(float turns) {
    const float quarters = std::floor(turns * 4.0f + 0.5f);
    const float x = (turns - quarters * 0.25f) * kTwoPi;  // within an eighth of a turn
    const float x2 = x * x;
    const float sine =
        x * (1.0f + x2 * (-1.0f / 6.0f + x2 * (1.0f / 120.0f + x2 * (-1.0f / 5040.0f + x2 / 362880.0f))));
    const float cosine =
        1.0f + x2 * (-0.5f + x2 * (1.0f / 24.0f + x2 * (-1.0f / 720.0f + x2 * (1.0f / 40320.0f))));
    switch (static_cast<int>(quarters) & 3) {
        case 0:
            return {cosine, sine};
        case 1:
            return {-sine, cosine};
        case 2:
            return {-cosine, -sine};
        default:
            return {sine, -cosine};
    }
}

// In the hemisphere around z, in proportion to the cosine; its density is z / pi.
[[nodiscard]] inline glm::vec3 cosine_hemisphere(const glm::vec2& u) {
    const float radius = std::sqrt(u.x);
    const glm::vec2 p = circle_point(u.y) * radius;
    return {p.x, p.y, std::sqrt(std::max(0.0f, 1.0f - u.x))};
}

// Evenly in the cone around z whose opening is given by `one_minus_cos` of its half angle, which keeps its digits in
// narrow cones; its density is 1 / (2 pi one_minus_cos).
[[nodiscard]] inline glm::vec3 uniform_cone(const glm::vec2& u, float one_minus_cos) {
    const float height = u.x * one_minus_cos;  // of the missing cap
    const float radius = std::sqrt(std::max(0.0f, height * (2.0f - height)));
    const glm::vec2 p = circle_point(u.y) * radius;
    return {p.x, p.y, 1.0f - height};
}

}  // namespace gh::render
