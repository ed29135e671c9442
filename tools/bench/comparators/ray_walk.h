// comparators/ray_walk.h - a ray in double precision, thick enough that walking it can never lose a hit which the
// specification's rounded arithmetic finds. Private to the comparators.
#pragma once

#include "comparators/soup.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace comparators {

struct Interval {
    double near, far;  // in multiples of the direction
};

struct ThickRay {
    ThickRay(const rc::Ray& ray, double soup_reach)
        : origin(ray.origin),
          direction(ray.direction),
          pad(ray_pad(reach_of(ray.origin), soup_reach)),
          // t errs by what the place errs by, seen along the longest axis.
          t_pad(2 * pad / std::max(reach_of(ray.direction), 1e-300)),
          limits{static_cast<double>(ray.t_min), static_cast<double>(ray.t_max)} {}

    // Where the ray is within `pad` of the box; nothing when nowhere.
    [[nodiscard]] std::optional<Interval> within(const Bounds& box) const {
        Interval span{limits.near - t_pad, limits.far + t_pad};
        for (std::size_t a = 0; a < 3; ++a) {
            const double low = box.min[a] - pad - origin[a], high = box.max[a] + pad - origin[a];
            if (direction[a] == 0.0) {
                if (low > 0.0 || high < 0.0) return std::nullopt;
                continue;
            }
            double t0 = low / direction[a], t1 = high / direction[a];
            if (t0 > t1) std::swap(t0, t1);
            span.near = std::max(span.near, t0);
            span.far = std::min(span.far, t1);
        }
        if (!(span.near <= span.far)) return std::nullopt;
        return span;
    }

    [[nodiscard]] double at(double t, std::size_t axis) const { return origin[axis] + direction[axis] * t; }

    glm::dvec3 origin, direction;
    double pad, t_pad;
    Interval limits;
};

}  // namespace comparators
