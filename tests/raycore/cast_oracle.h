// raycore/cast_oracle.h - when a moving body first touches a triangle, found the slow way: by searching, in
// long double, for where a distance falls below the radius. Distances between convex things are convex along
// a straight way, so the searches can not be led astray; nothing is shared with the code under test.
#pragma once

#include "raycore/ray.h"

#include <glm/vec3.hpp>

#include <array>
#include <optional>

namespace test {

using Point = glm::tvec3<long double>;
using Triangle = std::array<glm::vec3, 3>;

[[nodiscard]] long double distance_to_triangle(const Point& p, const Triangle& triangle);
[[nodiscard]] long double distance_to_triangle(const Point& from, const Point& to, const Triangle& triangle);

// The distance between the triangle and the axis moved by t times the way.
[[nodiscard]] long double distance_at(const rc::Segment& axis, const glm::vec3& way, long double t,
                                      const Triangle& triangle);

struct OracleCast {
    long double start_distance = 0;
    long double least_distance = 0;      // over the whole way
    std::optional<long double> first_t;  // where the distance becomes the radius; 0 when it starts within
};
[[nodiscard]] OracleCast cast_by_search(const rc::Segment& axis, float radius, const glm::vec3& way,
                                        const Triangle& triangle);

}  // namespace test
