// render/solid_angle.h - shapes as seen from a point: directions picked evenly over what they cover of the sky, and how
// dense that is. Small ones are picked by area, which there is the same but keeps its digits.
//
// Densities are over solid angle, 1/sr. Same bits base/det_math, square roots.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace gh::render {

struct ShapeSample {
    glm::vec3 direction{0.0f};  // unit
    float distance = 0.0f;
    float density = 0.0f;  // 0: the shape cannot be seen from there
};

// A rectangle; from both sides.
struct RectShape {
    glm::vec3 centre{0.0f};
    glm::vec3 half_u{0.0f}, half_v{0.0f};
    glm::vec3 normal{0.0f, 1.0f, 0.0f};  // unit
};
// By solid angle (Urena, Fajardo and King 2013).
[[nodiscard]] ShapeSample pick(const RectShape& rect, const glm::vec3& from, const glm::vec2& u);
// Of the point `at` on it.
[[nodiscard]] float density(const RectShape& rect, const glm::vec3& from, const glm::vec3& at);

// A ball: every direction in its cone; from inside, every direction there is.
struct BallShape {
    glm::vec3 centre{0.0f};
    float radius = 0.0f;
};
[[nodiscard]] ShapeSample pick(const BallShape& ball, const glm::vec3& from, const glm::vec2& u);
[[nodiscard]] float density(const BallShape& ball, const glm::vec3& from);
// Way along a unit direction into the ball, or out of it from inside; negative if it is missed.
[[nodiscard]] float distance_to(const BallShape& ball, const glm::vec3& from, const glm::vec3& direction);
// The same for a rectangle.
[[nodiscard]] float distance_to(const RectShape& rect, const glm::vec3& from, const glm::vec3& direction);

// A triangle; from both sides.
struct TriangleShape {
    std::array<glm::vec3, 3> corner{};
};
// By solid angle (Arvo 1995).
[[nodiscard]] ShapeSample pick(const TriangleShape& triangle, const glm::vec3& from, const glm::vec2& u);
[[nodiscard]] float density(const TriangleShape& triangle, const glm::vec3& from, const glm::vec3& at);

}  // namespace gh::render
