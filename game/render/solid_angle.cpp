#include "render/solid_angle.h"

#include "base/det_math.h"
#include "render/directions.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kSmall = 0.03f;  // steradians, about: below, the shape is picked by area

// By area: what a square metre at `offset` covers.
float density_by_area(float area, const glm::vec3& normal, const glm::vec3& offset) {
    const float distance2 = glm::dot(offset, offset);
    const float facing = std::abs(glm::dot(normal, offset)) * area;
    return facing > 0.0f ? distance2 * std::sqrt(distance2) / facing : 0.0f;
}

float rect_area(const RectShape& rect) {
    return 4.0f * glm::length(rect.half_u) * glm::length(rect.half_v);
}

bool is_small(const RectShape& rect, const glm::vec3& from, float area) {
    const glm::vec3 offset = rect.centre - from;
    return area < kSmall * glm::dot(offset, offset);
}

// An angle as the point of the unit circle it turns to: sums of angles are products, which need no arc functions.
struct Turned {
    float cos = 1.0f, sin = 0.0f;
};
Turned operator*(const Turned& a, const Turned& b) {
    return {a.cos * b.cos - a.sin * b.sin, a.sin * b.cos + a.cos * b.sin};
}

// The rectangle in its own frame, seen from the origin, and the spherical rectangle's angles (Urena et al. 2013). The
// planes through the eye and each edge have normals with one coordinate along an edge and one along z, so that the cosine
// between two neighbours is a product; their four angles' sum is 2 pi + the solid angle.
struct SphericalRect {
    glm::vec3 x, y, z;
    float x0, x1, y0, y1, z0;
    float b0, b1, solid_angle;
    Turned k;  // where the picked angle starts: minus the two angles at x0

    SphericalRect(const RectShape& rect, const glm::vec3& from) {
        const float half_width = glm::length(rect.half_u), half_height = glm::length(rect.half_v);
        x = rect.half_u / half_width;
        y = rect.half_v / half_height;
        z = rect.normal;
        const glm::vec3 offset = rect.centre - from;
        z0 = glm::dot(offset, z);
        if (z0 > 0.0f) {
            z = -z;
            z0 = -z0;
        }
        const float cx = glm::dot(offset, x), cy = glm::dot(offset, y);
        x0 = cx - half_width;
        x1 = cx + half_width;
        y0 = cy - half_height;
        y1 = cy + half_height;
        const Edge low_y = edge(-y0), high_x = edge(x1), high_y = edge(y1), low_x = edge(-x0);
        b0 = low_y.cos;
        b1 = high_y.cos;
        const Turned beside = corner(high_y, low_x) * corner(low_x, low_y);
        const Turned all = corner(low_y, high_x) * corner(high_x, high_y) * beside;
        k = {beside.cos, -beside.sin};
        solid_angle = det::atan2(all.sin, all.cos);
        if (solid_angle < 0.0f) solid_angle += kTwoPi;
    }

    [[nodiscard]] glm::vec3 point(const glm::vec2& u) const {
        const det::SinCos share = det::sin_cos(u.x * solid_angle);
        const Turned turned = Turned{share.cos, share.sin} * k;
        const float slope = (turned.cos * b0 - b1) / turned.sin;
        const float cu =
            std::clamp(std::copysign(1.0f / std::sqrt(slope * slope + b0 * b0), slope), -1.0f, 1.0f);
        const float xu = std::clamp(-(cu * z0) / std::max(std::sqrt(1.0f - cu * cu), 1e-7f), x0, x1);
        const float d2 = xu * xu + z0 * z0;
        const float h0 = y0 / std::sqrt(d2 + y0 * y0), h1 = y1 / std::sqrt(d2 + y1 * y1);
        const float h = h0 + u.y * (h1 - h0);
        const float yv = h * h < 1.0f - 1e-6f ? h * std::sqrt(d2) / std::sqrt(1.0f - h * h) : y1;
        return x * xu + y * std::clamp(yv, y0, y1) + z * z0;
    }

  private:
    // How the plane through an edge `off` from the foot of the eye leans.
    struct Edge {
        float cos, sin2;
    };
    [[nodiscard]] Edge edge(float off) const {
        const float length2 = off * off + z0 * z0;
        return {off / std::sqrt(length2), z0 * z0 / length2};
    }
    // The angle between neighbours; 1 - (ab)^2 written so that nothing cancels.
    [[nodiscard]] static Turned corner(const Edge& a, const Edge& b) {
        return {-a.cos * b.cos, std::sqrt(a.sin2 + a.cos * a.cos * b.sin2)};
    }
};

ShapeSample towards(const glm::vec3& offset, float density) {
    const float distance = glm::length(offset);
    if (!(distance > 0.0f) || !(density > 0.0f)) return {};
    return {offset / distance, distance, density};
}

// One minus the cosine of the ball's cone. Precondition: `from` is outside.
float missing_cap(const BallShape& ball, float distance2) {
    const float sin2 = ball.radius * ball.radius / distance2;
    return sin2 / (1.0f + std::sqrt(1.0f - sin2));
}

// A triangle's corners as unit directions, the angles at them and what they cover.
struct SphericalTriangle {
    glm::vec3 a, b, c;
    float alpha = 0.0f, solid_angle = 0.0f;

    SphericalTriangle(const TriangleShape& triangle, const glm::vec3& from)
        : a(glm::normalize(triangle.corner[0] - from)),
          b(glm::normalize(triangle.corner[1] - from)),
          c(glm::normalize(triangle.corner[2] - from)) {
        // Van Oosterom and Strackee 1983.
        const float volume = std::abs(glm::dot(a, glm::cross(b, c)));
        const float sum = 1.0f + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a);
        solid_angle = 2.0f * det::atan2(volume, sum);
        const glm::vec3 ab = glm::cross(a, b), ac = glm::cross(a, c);
        const float lengths = glm::length(ab) * glm::length(ac);
        if (lengths > 0.0f) alpha = det::acos(std::clamp(glm::dot(ab, ac) / lengths, -1.0f, 1.0f));
    }

    // Unit.
    [[nodiscard]] glm::vec3 direction(const glm::vec2& u) const {
        const auto [sin_phi_full, cos_phi_full] = det::sin_cos(u.x * solid_angle - alpha);
        const auto [sin_alpha, cos_alpha] = det::sin_cos(alpha);
        const float cos_c = glm::dot(a, b);
        const float k1 = cos_phi_full - cos_alpha, k2 = sin_phi_full + sin_alpha * cos_c;
        const float above = (k2 * cos_phi_full - k1 * sin_phi_full) * cos_alpha - k2;
        const float below = (k2 * sin_phi_full + k1 * cos_phi_full) * sin_alpha;
        const float cos_b = std::clamp(below != 0.0f ? above / below : 1.0f, -1.0f, 1.0f);
        const glm::vec3 off = c - a * glm::dot(a, c);
        const float off_length = glm::length(off);
        const glm::vec3 corner =
            off_length > 0.0f ? a * cos_b + off * (std::sqrt(1.0f - cos_b * cos_b) / off_length) : c;
        const float cosine = 1.0f - u.y * (1.0f - glm::dot(corner, b));
        const glm::vec3 across = corner - b * glm::dot(corner, b);
        const float across_length = glm::length(across);
        if (!(across_length > 0.0f)) return b;
        return b * cosine + across * (std::sqrt(std::max(0.0f, 1.0f - cosine * cosine)) / across_length);
    }
};

struct TriangleMeasure {
    float area;
    glm::vec3 normal;
};
TriangleMeasure measure(const TriangleShape& triangle) {
    const glm::vec3 n =
        glm::cross(triangle.corner[1] - triangle.corner[0], triangle.corner[2] - triangle.corner[0]);
    const float length = glm::length(n);
    return {0.5f * length, length > 0.0f ? n / length : glm::vec3(0.0f)};
}

bool is_small(const TriangleShape& triangle, const glm::vec3& from, float area) {
    const glm::vec3 offset = (triangle.corner[0] + triangle.corner[1] + triangle.corner[2]) / 3.0f - from;
    return area < kSmall * glm::dot(offset, offset);
}

}  // namespace

ShapeSample pick(const RectShape& rect, const glm::vec3& from, const glm::vec2& u) {
    const float area = rect_area(rect);
    if (is_small(rect, from, area)) {
        const glm::vec3 offset =
            rect.centre + rect.half_u * (2.0f * u.x - 1.0f) + rect.half_v * (2.0f * u.y - 1.0f) - from;
        return towards(offset, density_by_area(area, rect.normal, offset));
    }
    const SphericalRect seen(rect, from);
    if (!(seen.solid_angle > 0.0f) || !(seen.z0 < 0.0f)) return {};
    return towards(seen.point(u), 1.0f / seen.solid_angle);
}

float density(const RectShape& rect, const glm::vec3& from, const glm::vec3& at) {
    const float area = rect_area(rect);
    if (is_small(rect, from, area)) return density_by_area(area, rect.normal, at - from);
    const SphericalRect seen(rect, from);
    return seen.solid_angle > 0.0f && seen.z0 < 0.0f ? 1.0f / seen.solid_angle : 0.0f;
}

float distance_to(const RectShape& rect, const glm::vec3& from, const glm::vec3& direction) {
    const glm::vec3 offset = rect.centre - from;
    const float t = glm::dot(offset, rect.normal) / glm::dot(direction, rect.normal);
    if (!(t > 0.0f)) return -1.0f;
    const glm::vec3 at = direction * t - offset;
    const float u2 = glm::dot(rect.half_u, rect.half_u), v2 = glm::dot(rect.half_v, rect.half_v);
    const bool is_inside =
        std::abs(glm::dot(at, rect.half_u)) <= u2 && std::abs(glm::dot(at, rect.half_v)) <= v2;
    return is_inside ? t : -1.0f;
}

ShapeSample pick(const BallShape& ball, const glm::vec3& from, const glm::vec2& u) {
    const glm::vec3 offset = ball.centre - from;
    const float distance2 = glm::dot(offset, offset);
    if (!(distance2 > ball.radius * ball.radius)) {
        const glm::vec3 direction = uniform_cone(u, 2.0f);
        return {direction, distance_to(ball, from, direction), 0.25f / kPi};
    }
    const float cap = missing_cap(ball, distance2);
    const float distance = std::sqrt(distance2);
    const glm::vec3 direction =
        glm::normalize(basis_around(offset / distance).world_from_local(uniform_cone(u, cap)));
    const float entry = distance_to(ball, from, direction);
    return {direction, entry > 0.0f ? entry : distance, 1.0f / (kTwoPi * cap)};
}

float density(const BallShape& ball, const glm::vec3& from) {
    const glm::vec3 offset = ball.centre - from;
    const float distance2 = glm::dot(offset, offset);
    if (!(distance2 > ball.radius * ball.radius)) return 0.25f / kPi;
    return 1.0f / (kTwoPi * missing_cap(ball, distance2));
}

float distance_to(const BallShape& ball, const glm::vec3& from, const glm::vec3& direction) {
    const glm::vec3 offset = ball.centre - from;
    const float along = glm::dot(offset, direction);
    const glm::vec3 beside = offset - direction * along;
    const float root2 = ball.radius * ball.radius - glm::dot(beside, beside);
    if (!(root2 >= 0.0f)) return -1.0f;
    const bool is_inside = glm::dot(offset, offset) <= ball.radius * ball.radius;
    return is_inside ? along + std::sqrt(root2) : along - std::sqrt(root2);
}

ShapeSample pick(const TriangleShape& triangle, const glm::vec3& from, const glm::vec2& u) {
    const auto [area, normal] = measure(triangle);
    if (is_small(triangle, from, area)) {
        const float root = std::sqrt(u.x);
        const glm::vec3 offset = triangle.corner[0] * (1.0f - root) +
                                 triangle.corner[1] * (root * (1.0f - u.y)) +
                                 triangle.corner[2] * (root * u.y) - from;
        return towards(offset, density_by_area(area, normal, offset));
    }
    const SphericalTriangle seen(triangle, from);
    if (!(seen.solid_angle > 0.0f)) return {};
    const glm::vec3 direction = seen.direction(u);
    const float along = glm::dot(direction, normal);
    const float distance = glm::dot(triangle.corner[0] - from, normal) / along;
    return {direction, std::max(distance, 0.0f), 1.0f / seen.solid_angle};
}

float density(const TriangleShape& triangle, const glm::vec3& from, const glm::vec3& at) {
    const auto [area, normal] = measure(triangle);
    if (is_small(triangle, from, area)) return density_by_area(area, normal, at - from);
    const SphericalTriangle seen(triangle, from);
    return seen.solid_angle > 0.0f ? 1.0f / seen.solid_angle : 0.0f;
}

}  // namespace gh::render
