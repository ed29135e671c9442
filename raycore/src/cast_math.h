// cast_math.h - one moving ball or capsule against one triangle, exactly. Private to raycore.
//
// The body is all points within `radius` of the segment from 0 to `axis`; it moves by `displacement`.
// Triangles come relative to the axis' start, in the world's frame: subtracted in double, so that far from
// the origin nothing is lost that a float still knew. Everything is +, -, *, / and sqrt in double: the same
// bits everywhere.
//
// Method    what the axis sweeps past is a point moving towards K, the triangle swept by -axis: a convex body
//           of two triangles and three parallelograms. K thickened by the radius is K's faces moved outwards,
//           cylinders round its edges and balls round its corners; the body touches first where the point
//           first enters one of them. Faces and cylinders are tested a trifle (1e-12 of their size) beyond
//           their ends, so that rounding leaves no gap between them, and nothing is iterated that could give
//           up.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace rc::cast {

[[nodiscard]] inline double square(const glm::dvec3& v) {
    return glm::dot(v, v);
}

[[nodiscard]] inline bool is_finite(const glm::vec3& v) {
    constexpr float kMax = std::numeric_limits<float>::max();
    return std::abs(v.x) <= kMax && std::abs(v.y) <= kMax && std::abs(v.z) <= kMax;
}

struct Body {
    glm::dvec3 axis{0.0};  // zero: a ball
    double radius = 0.0;
    glm::dvec3 displacement{0.0};
    // An overlap up to this is rounding of the body's own position: it counts as touching, not as
    // overlapping.
    double touch = 0.0;
};

using Corners = std::array<glm::dvec3, 3>;

struct Contact {
    double t = 0.0;      // in [0, 1]
    double depth = 0.0;  // >= 0, at t == 0
    glm::dvec3 point{0.0};
    glm::dvec3 normal{0.0};  // unit, from the triangle towards the axis
};

// Where the body first meets the triangle. A body that overlaps it at the start (deeper than `touch`) meets
// it at 0; one that touches it meets it at 0 when moving closer, and not at all when moving along it or away.
// A way that, even continued, never leads deeper than `touch` only grazes, and meets nothing.
[[nodiscard]] std::optional<Contact> first_contact(const Body& body, const Corners& triangle);

// How the body overlaps the triangle where it stands (deeper than `touch`), t = 0.
[[nodiscard]] std::optional<Contact> resting_contact(const Body& body, const Corners& triangle);

// The nearest points of a segment from 0 to `axis` and a triangle.
struct Closest {
    double distance = 0.0;
    glm::dvec3 on_axis{0.0};
    glm::dvec3 on_triangle{0.0};
    glm::dvec3 normal{0.0};  // unit, from triangle to axis
    double way_out =
        0.0;  // when the axis goes through: how far along `normal` until all of it is on one side
    bool goes_through = false;  // distance is 0 and the normal is that of the triangle
};

// `towards` breaks the tie when both sides are equally near: the way out is against it.
[[nodiscard]] Closest closest_points(const glm::dvec3& axis, const Corners& triangle,
                                     const glm::dvec3& towards);

// The triangle's unit normal, or zero when it has no area.
[[nodiscard]] glm::dvec3 unit_normal(const Corners& triangle);

}  // namespace rc::cast
