#include "cast_math.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rc::cast {

namespace {

// Where `point` projects into the triangle, as the shares of its two edges from corner 0; false when outside.
bool projects_inside(const glm::dvec3& point, const Corners& c, const glm::dvec3& cross, glm::dvec3& foot) {
    const glm::dvec3 e1 = c[1] - c[0], e2 = c[2] - c[0], p = point - c[0];
    const double area = square(cross);
    const double u = glm::dot(glm::cross(p, e2), cross) / area;
    const double v = glm::dot(glm::cross(e1, p), cross) / area;
    if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) return false;
    foot = c[0] + u * e1 + v * e2;
    return true;
}

// Whether the foot is where the height says, as far as doubles can tell. In triangles 1e9 times longer than wide it may
// not be; their edges are as near as the face then.
bool is_below(const glm::dvec3& point, const glm::dvec3& foot, double height, const Corners& c) {
    const double size = std::sqrt(std::max({square(c[1] - c[0]), square(c[2] - c[0]), square(point - c[0])}));
    return square(point - foot) <= (1.001 * height + 1e-9 * size) * (1.001 * height + 1e-9 * size);
}

struct Pair {
    glm::dvec3 on_axis;
    glm::dvec3 on_edge;
};

// Nearest points of the segments from 0 to `axis` and from `a` to `b`. The parameter on the first is found
// from cross products, which do not cancel when the two are nearly parallel.
Pair closest_of_segments(const glm::dvec3& axis, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 edge = b - a;
    const double axis_square = square(axis), edge_square = square(edge);
    const auto share_on_edge = [&](const glm::dvec3& from) {
        return edge_square > 0.0 ? std::clamp(glm::dot(from - a, edge) / edge_square, 0.0, 1.0) : 0.0;
    };
    if (!(axis_square > 0.0)) return {glm::dvec3(0.0), a + share_on_edge(glm::dvec3(0.0)) * edge};

    const glm::dvec3 both = glm::cross(axis, edge);
    const double both_square = square(both);
    double s = 0.0;  // parallel: any will do as a start
    if (both_square > 0.0) s = std::clamp(glm::dot(glm::cross(a, edge), both) / both_square, 0.0, 1.0);
    const double t = share_on_edge(s * axis);
    const glm::dvec3 on_edge = a + t * edge;
    // Where the edge's end was the limit, another point of the axis is nearer.
    const double nearer = std::clamp(glm::dot(on_edge, axis) / axis_square, 0.0, 1.0);
    return {nearer * axis, on_edge};
}

// Whether the axis goes through the triangle: then its parts on both sides say which way out is shorter.
bool find_crossing(const glm::dvec3& axis, const Corners& c, const glm::dvec3& cross,
                   const glm::dvec3& towards, Closest& out) {
    const glm::dvec3 normal = unit_normal(c);
    const double from = glm::dot(normal, -c[0]);
    const double to = glm::dot(normal, axis - c[0]);
    const bool is_on_both_sides = (from <= 0.0 && to >= 0.0) || (from >= 0.0 && to <= 0.0);
    if (!is_on_both_sides) return false;
    const double share = from == to ? 0.0 : from / (from - to);
    const glm::dvec3 at = share * axis;
    glm::dvec3 foot;
    if (!projects_inside(at, c, cross, foot)) return false;

    const double up = -std::min(from, to);  // lifted by this all of the axis is above
    const double down = std::max(from, to);
    const bool is_up = up < down || (up == down && glm::dot(normal, towards) <= 0.0);
    out = {.distance = 0.0,
           .on_axis = at,
           .on_triangle = foot,
           .normal = is_up ? normal : -normal,
           .way_out = is_up ? up : down,
           .goes_through = true};
    return true;
}

// Keeps in `best` the nearer pair. A distance within rounding of 0 has no direction: then the axis goes
// through.
void keep_nearer(const Pair& pair, const glm::dvec3& normal_if_through, Closest& best) {
    const glm::dvec3 between = pair.on_axis - pair.on_edge;
    const double distance = std::sqrt(square(between));
    if (!(distance < best.distance)) return;
    const bool goes_through = distance <= 0x1p-48 * std::sqrt(square(pair.on_axis) + square(pair.on_edge));
    best.distance = goes_through ? 0.0 : distance;
    best.on_axis = pair.on_axis;
    best.on_triangle = pair.on_edge;
    best.normal = goes_through ? normal_if_through : between / distance;
    best.goes_through = goes_through;
}

}  // namespace

glm::dvec3 unit_normal(const Corners& c) {
    const glm::dvec3 cross = glm::cross(c[1] - c[0], c[2] - c[0]);
    const double length = std::sqrt(square(cross));
    return length > 0.0 ? cross / length : glm::dvec3(0.0);
}

Closest closest_points(const glm::dvec3& axis, const Corners& c, const glm::dvec3& towards) {
    const glm::dvec3 cross = glm::cross(c[1] - c[0], c[2] - c[0]);
    const bool has_area = square(cross) > 0.0;
    Closest best;
    if (has_area && find_crossing(axis, c, cross, towards, best)) return best;

    best.distance = std::numeric_limits<double>::infinity();
    const glm::dvec3 normal = unit_normal(c);
    if (has_area) {
        for (const glm::dvec3& end : {glm::dvec3(0.0), axis}) {
            const double height = glm::dot(normal, end - c[0]);
            glm::dvec3 foot;
            if (!(std::abs(height) < best.distance) || !projects_inside(end, c, cross, foot)) continue;
            if (!is_below(end, foot, std::abs(height), c)) continue;
            // The plane's own normal, not the difference of two near points: it does not waver along a floor.
            best.distance = std::abs(height);
            best.on_axis = end;
            best.on_triangle = foot;
            best.normal = height > 0.0 ? normal : -normal;
        }
    }
    const glm::dvec3 back = glm::dot(normal, towards) <= 0.0 ? normal : -normal;
    for (std::size_t i = 0; i < 3; ++i)
        keep_nearer(closest_of_segments(axis, c[i], c[(i + 1) % 3]), back, best);
    return best;
}

}  // namespace rc::cast
