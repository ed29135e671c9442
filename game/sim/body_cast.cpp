#include "sim/body_cast.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "sim/geometry.h"

namespace gh::sim {

namespace {

// The lesser root of a s^2 + 2 b s + c = 0: when something moving inwards (b < 0) enters; at once if rounding has it
// inside (c <= 0) already.
std::optional<float> entry(float a, float b, float c) {
    const float root_square = b * b - a * c;
    if (!(b < 0.0f) || !(a > 0.0f) || !(root_square >= 0.0f)) return std::nullopt;
    if (c <= 0.0f) return 0.0f;
    return (-b - std::sqrt(root_square)) / a;
}

// Both relative to the feet: the centre's place, and the way it goes.
struct Way {
    glm::vec3 from;
    glm::vec3 along;
};

std::optional<float> enters_ball(const Way& way, float height, float reach) {
    const glm::vec3 m = way.from - glm::vec3(0.0f, height, 0.0f);
    return entry(glm::dot(way.along, way.along), glm::dot(m, way.along), glm::dot(m, m) - reach * reach);
}

std::optional<float> enters_side(const Way& way, float top, float reach) {
    const glm::vec3 m = flat(way.from), d = flat(way.along);
    const std::optional<float> s = entry(glm::dot(d, d), glm::dot(m, d), glm::dot(m, m) - reach * reach);
    if (!s) return std::nullopt;
    const float height = way.from.y + way.along.y * *s;
    return 0.0f <= height && height <= top ? s : std::nullopt;
}

}  // namespace

std::optional<BodyHit> cast_at_body(const Body& body, const glm::vec3& centre, float radius,
                                    const glm::vec3& displacement) {
    const Way way{centre - body.feet, displacement};
    const float reach = body.radius + radius;
    const float top = std::max(body.height - body.radius, 0.0f);
    const auto out_of_axis = [top](const glm::vec3& p) {
        return p - glm::vec3(0.0f, std::clamp(p.y, 0.0f, top), 0.0f);
    };

    float t = 0.0f;
    glm::vec3 normal = unit_or_zero(out_of_axis(way.from));
    if (length_of(out_of_axis(way.from)) <= reach) {
        if (!(glm::dot(displacement, normal) < 0.0f)) return std::nullopt;
    } else {
        t = 2.0f;
        for (const std::optional<float> s :
             {enters_side(way, top, reach), enters_ball(way, 0.0f, reach), enters_ball(way, top, reach)}) {
            if (s) t = std::min(t, *s);
        }
        if (!(t <= 1.0f)) return std::nullopt;
        normal = unit_or_zero(out_of_axis(way.from + way.along * t));
    }
    return BodyHit{t, centre + displacement * t - normal * radius, normal};
}

}  // namespace gh::sim
