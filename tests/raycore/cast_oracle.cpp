#include "raycore/cast_oracle.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace test {

namespace {

constexpr int kSearchSteps = 48;  // to 1e-10 of the way
constexpr int kBisections = 44;

// The place in [0, 1] where a convex function is least, and a little about it: golden sections.
template <class F>
long double least_at(F&& f, int steps) {
    constexpr long double kGolden = 0.618033988749894848L;
    long double low = 0, high = 1;
    long double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
    long double fa = f(a), fb = f(b);
    for (int i = 0; i < steps; ++i) {
        if (fa <= fb) {
            high = b, b = a, fb = fa;
            a = high - kGolden * (high - low), fa = f(a);
        } else {
            low = a, a = b, fa = fb;
            b = low + kGolden * (high - low), fb = f(b);
        }
    }
    long double best = (low + high) / 2;
    for (const long double end : {0.0L, 1.0L})
        if (f(end) < f(best)) best = end;
    return best;
}

long double distance_to_segment(const Point& p, const Point& a, const Point& b) {
    const Point along = b - a;
    const long double square = glm::dot(along, along);
    const long double t = square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0.0L, 1.0L) : 0.0L;
    return glm::length(p - (a + t * along));
}

}  // namespace

// Inside the three planes that stand on the edges the plane is nearest, elsewhere an edge.
long double distance_to_triangle(const Point& p, const Triangle& triangle) {
    const Point c[3] = {Point(triangle[0]), Point(triangle[1]), Point(triangle[2])};
    const Point normal = glm::cross(c[1] - c[0], c[2] - c[0]);
    bool is_above = glm::dot(normal, normal) > 0;
    long double nearest = std::numeric_limits<long double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const Point& a = c[i];
        const Point& b = c[(i + 1) % 3];
        is_above = is_above && glm::dot(glm::cross(b - a, p - a), normal) >= 0;
        nearest = std::min(nearest, distance_to_segment(p, a, b));
    }
    return is_above ? std::abs(glm::dot(p - c[0], normal)) / glm::length(normal) : nearest;
}

long double distance_to_triangle(const Point& from, const Point& to, const Triangle& triangle) {
    const auto at = [&](long double s) { return distance_to_triangle(from + s * (to - from), triangle); };
    return at(from == to ? 0.0L : least_at(at, kSearchSteps));
}

long double distance_at(const rc::Segment& axis, const glm::vec3& way, long double t,
                        const Triangle& triangle) {
    const Point moved = t * Point(way);
    return distance_to_triangle(Point(axis.from) + moved, Point(axis.to) + moved, triangle);
}

OracleCast cast_by_search(const rc::Segment& axis, float radius, const glm::vec3& way,
                          const Triangle& triangle) {
    const auto at = [&](long double t) { return distance_at(axis, way, t, triangle); };
    const auto r = static_cast<long double>(radius);
    const long double least = least_at(at, kSearchSteps);
    OracleCast answer{.start_distance = at(0), .least_distance = at(least), .first_t = std::nullopt};
    if (answer.start_distance <= r) {
        answer.first_t = 0.0L;
    } else if (answer.least_distance <= r) {
        long double outside = 0, inside = least;
        for (int i = 0; i < kBisections; ++i) {
            const long double middle = (outside + inside) / 2;
            (at(middle) <= r ? inside : outside) = middle;
        }
        answer.first_t = inside;
    }
    return answer;
}

}  // namespace test
