#include "box_math.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rc::cast {

namespace {

constexpr double kFlat = 1e-6;       // axes whose sines are below this lie in a plane
constexpr double kParallel = 1e-24;  // squared sine of edges that have no direction across both
constexpr double kBetter =
    1e-9;  // a later way out must be shorter by this share, so that normals do not waver

// A polygon from clipping a triangle with six planes.
struct Polygon {
    std::array<glm::dvec3, 9> corner;
    std::size_t size = 0;
};

// Keeps what lies on the near side of sign * x[axis] = half.
Polygon clip(const Polygon& in, std::size_t axis, double sign, double half) {
    Polygon out;
    for (std::size_t i = 0; i < in.size; ++i) {
        const glm::dvec3 &a = in.corner[i], &b = in.corner[(i + 1) % in.size];
        const double over_a = sign * a[axis] - half, over_b = sign * b[axis] - half;
        if (over_a <= 0.0) out.corner[out.size++] = a;
        const bool crosses = (over_a < 0.0 && over_b > 0.0) || (over_a > 0.0 && over_b < 0.0);
        if (crosses && out.size < out.corner.size())
            out.corner[out.size++] = a + (over_a / (over_a - over_b)) * (b - a);
        if (out.size == out.corner.size()) break;
    }
    return out;
}

// The middle of those corners of the clipped triangle that reach farthest along `normal`.
glm::dvec3 deepest_point(const Corners& corners, const glm::dvec3& half, const glm::dvec3& normal) {
    Polygon inside;
    for (const glm::dvec3& corner : corners) inside.corner[inside.size++] = corner;
    for (std::size_t axis = 0; axis < 3 && inside.size > 0; ++axis) {
        for (const double sign : {1.0, -1.0}) inside = clip(inside, axis, sign, half[axis]);
    }
    if (inside.size == 0) return closest_points(glm::dvec3(0.0), corners, glm::dvec3(0.0)).on_triangle;
    double farthest = -std::numeric_limits<double>::infinity(), size = 0.0;
    for (std::size_t i = 0; i < inside.size; ++i) {
        farthest = std::max(farthest, glm::dot(normal, inside.corner[i]));
        size = std::max(size, glm::length(inside.corner[i]));
    }
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (std::size_t i = 0; i < inside.size; ++i) {
        if (glm::dot(normal, inside.corner[i]) < farthest - kBetter * size) continue;
        sum += inside.corner[i];
        count += 1.0;
    }
    return sum / count;
}

// The shortest move of the box that parts it from the triangle, over directions offered one by one.
class WayOut {
  public:
    WayOut(const Corners& corners, const glm::dvec3& half) : corners_(corners), half_(half) {}

    // false: in this direction they are apart, or do no more than touch.
    bool offer(const glm::dvec3& direction, double touch) {
        const double square = glm::dot(direction, direction);
        if (!(square > 0.0)) return true;
        const glm::dvec3 normal = direction / std::sqrt(square);
        const double reach = glm::dot(glm::abs(normal), half_);
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const glm::dvec3& corner : corners_) {
            const double at = glm::dot(normal, corner);
            low = std::min(low, at);
            high = std::max(high, at);
        }
        const double forwards = high + reach, backwards = reach - low;
        const double depth = std::min(forwards, backwards);
        if (!(depth > touch)) return false;
        if (depth < depth_ * (1.0 - kBetter)) {
            depth_ = depth;
            normal_ = forwards <= backwards ? normal : -normal;
        }
        return true;
    }

    [[nodiscard]] double depth() const { return depth_; }
    [[nodiscard]] const glm::dvec3& normal() const { return normal_; }

  private:
    const Corners& corners_;
    const glm::dvec3& half_;
    double depth_ = std::numeric_limits<double>::infinity();
    glm::dvec3 normal_{0.0};
};

// The triangle's plane first, so that what rests on a floor is pushed straight up.
bool offer_all(WayOut& way, const Corners& c, double touch) {
    const glm::dvec3 sides[3] = {c[1] - c[0], c[2] - c[1], c[0] - c[2]};
    if (!way.offer(glm::cross(sides[0], sides[1]), touch)) return false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        glm::dvec3 face(0.0);
        face[axis] = 1.0;
        if (!way.offer(face, touch)) return false;
        for (const glm::dvec3& side : sides) {
            const glm::dvec3 across = glm::cross(face, side);
            if (glm::dot(across, across) > kParallel * glm::dot(side, side) && !way.offer(across, touch))
                return false;
        }
    }
    return true;
}

// Gram and Schmidt: the first axis keeps its direction, the second its plane.
bool make_orthonormal(const glm::mat3& axes, std::array<glm::dvec3, 3>& out) {
    for (std::size_t i = 0; i < 3; ++i) {
        glm::dvec3 axis(axes[i]);
        const double length = glm::length(axis);
        if (!(length > 0.0)) return false;
        axis /= length;
        for (std::size_t k = 0; k < i; ++k) axis -= glm::dot(axis, out[k]) * out[k];
        const double left = glm::length(axis);
        if (!(left > kFlat)) return false;
        out[i] = axis / left;
    }
    return true;
}

}  // namespace

std::optional<PlacedBox> place(const OrientedBox& box) {
    const bool is_good = is_finite(box.centre) && is_finite(box.half) && is_finite(box.axes[0]) &&
                         is_finite(box.axes[1]) && is_finite(box.axes[2]) && box.half.x >= 0.0f &&
                         box.half.y >= 0.0f && box.half.z >= 0.0f;
    PlacedBox placed{
        .centre = glm::dvec3(box.centre), .axes = {}, .half = glm::dvec3(box.half), .touch = 0, .around = {}};
    if (!is_good || !make_orthonormal(box.axes, placed.axes)) return std::nullopt;
    glm::dvec3 reach(0.0);
    for (std::size_t i = 0; i < 3; ++i) reach += glm::abs(placed.axes[i]) * placed.half[i];
    const glm::dvec3 size = glm::abs(placed.centre) + reach;
    const double least = std::min({placed.half.x, placed.half.y, placed.half.z});
    placed.touch = std::min(4.0 * 0x1p-24 * std::max({size.x, size.y, size.z}), 0.5 * least);
    for (std::size_t a = 0; a < 3; ++a) {
        // One part in 2^22 outwards is more than the conversion can round inwards.
        const double low = placed.centre[a] - reach[a], high = placed.centre[a] + reach[a];
        placed.around.min[a] = static_cast<float>(low - std::abs(low) * 0x1p-22);
        placed.around.max[a] = static_cast<float>(high + std::abs(high) * 0x1p-22);
    }
    return placed;
}

std::optional<Contact> resting_contact(const PlacedBox& box, const std::array<glm::vec3, 3>& corners) {
    Corners local;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 from_centre = glm::dvec3(corners[i]) - box.centre;
        for (std::size_t a = 0; a < 3; ++a) local[i][a] = glm::dot(box.axes[a], from_centre);
    }
    WayOut way(local, box.half);
    if (!offer_all(way, local, box.touch)) return std::nullopt;
    const auto in_world = [&](const glm::dvec3& v) {
        return (v.x * box.axes[0] + v.y * box.axes[1]) + v.z * box.axes[2];
    };
    return Contact{.t = 0.0,
                   .depth = way.depth(),
                   .point = box.centre + in_world(deepest_point(local, box.half, way.normal())),
                   .normal = in_world(way.normal())};
}

}  // namespace rc::cast
