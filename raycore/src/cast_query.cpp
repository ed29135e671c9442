#include "cast_query.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rc::cast {

namespace {

constexpr float kFloatMax = std::numeric_limits<float>::max();

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// For x >= 0. What lies within double's rounding below a float counts as that float, so that triangles which
// share the corner that is touched tie.
float rounded_down(double x) {
    x += x * 0x1p-44;
    const auto nearest = static_cast<float>(x);
    if (static_cast<double>(nearest) <= x) return nearest;
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(nearest) -
                                1);  // the float below: nearest > x >= 0
}

// A body placed by float arithmetic is off by a few units in its last place; a small one by no more than half
// of it.
double touch_tolerance(const glm::dvec3& origin, const Body& body) {
    const double size = std::max(largest(origin), largest(origin + body.axis)) + body.radius;
    return std::min(4.0 * 0x1p-24 * size, 0.5 * body.radius);
}

}  // namespace

Corners PlacedBody::relative(const std::array<glm::vec3, 3>& corners) const {
    return {glm::dvec3(corners[0]) - origin, glm::dvec3(corners[1]) - origin,
            glm::dvec3(corners[2]) - origin};
}

Box PlacedBody::swept_box(double from, double to) const {
    const glm::dvec3 zero(0.0), start = from * body.displacement, end = to * body.displacement;
    const double reach = body.radius + body.touch;
    const glm::dvec3 low = origin + glm::min(zero, body.axis) + glm::min(start, end) - reach;
    const glm::dvec3 high = origin + glm::max(zero, body.axis) + glm::max(start, end) + reach;
    Box box;
    for (glm::length_t a = 0; a < 3; ++a) {
        // One part in 2^22 outwards is more than the conversion can round inwards.
        box.min[a] = static_cast<float>(low[a] - std::abs(low[a]) * 0x1p-22);
        box.max[a] = static_cast<float>(high[a] + std::abs(high[a]) * 0x1p-22);
    }
    return box;
}

int PlacedBody::pieces() const {
    constexpr double kSizesPerPiece = 4.0;  // measured: shorter pieces visit the trees too often
    constexpr int kMost = 64;
    const double size = kSizesPerPiece * (2.0 * body.radius + largest(body.axis));
    const double length = largest(body.displacement);
    return length < size * kMost ? static_cast<int>(length / size) + 1 : kMost;
}

CastHit PlacedBody::hit(const Contact& contact, std::uint32_t instance, std::uint32_t primitive) const {
    return {.t = std::min(rounded_down(contact.t), 1.0f),
            .depth = static_cast<float>(contact.depth),
            .point = glm::vec3(origin + contact.point),
            .normal = glm::vec3(contact.normal),
            .primitive = primitive,
            .instance = instance};
}

std::optional<PlacedBody> place(const Segment& axis, float radius, const glm::vec3& displacement) {
    const bool is_good = is_finite(axis.from) && is_finite(axis.to) && is_finite(displacement) &&
                         radius >= 0.0f && radius <= kFloatMax;
    if (!is_good) return std::nullopt;
    PlacedBody placed{.body = {.axis = glm::dvec3(axis.to) - glm::dvec3(axis.from),
                               .radius = static_cast<double>(radius),
                               .displacement = glm::dvec3(displacement)},
                      .origin = glm::dvec3(axis.from)};
    placed.body.touch = touch_tolerance(placed.origin, placed.body);
    return placed;
}

}  // namespace rc::cast
