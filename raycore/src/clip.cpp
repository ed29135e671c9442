#include "clip.h"

#include "collect_refs.h"
#include "tree_math.h"

#include "raycore/ray.h"

#include <algorithm>
#include <cmath>

namespace rc::build {

namespace {

float rounded_up(double x) {
    const auto f = float(x);
    return double(f) < x ? std::nextafter(f, kInfinity) : f;
}

// Grows `box` by every point within `error` of x on one axis.
void grow_to(GrowingBox& box, std::size_t axis, double x, double error) {
    box.neg_min[axis] = std::max(box.neg_min[axis], rounded_up(error - x));
    box.max[axis] = std::max(box.max[axis], rounded_up(x + error));
}

void grow_to(GrowingBox& box, const glm::vec3& p) {
    for (std::size_t a = 0; a < 3; ++a) grow_to(box, a, double(p[a]), 0.0);
}

// What both hold; the ref itself on an axis where rounding leaves nothing.
BuildRef within(const BuildRef& ref, const GrowingBox& box) {
    BuildRef part = ref;
    for (std::size_t a = 0; a < 3; ++a) {
        const float neg_min = std::min(ref.neg_min[a], box.neg_min[a]),
                    max = std::min(ref.max[a], box.max[a]);
        if (!(-neg_min <= max)) continue;
        part.neg_min[a] = neg_min;
        part.max[a] = max;
    }
    return part;
}

}  // namespace

void clip(const BuildRef& ref, const glm::vec3 (&corners)[3], int axis, float plane, BuildRef& left,
          BuildRef& right) {
    const auto k = static_cast<std::size_t>(axis);
    GrowingBox below = kNoBox, above = kNoBox;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3 &p = corners[i], &q = corners[(i + 1) % 3];
        if (p[k] <= plane) grow_to(below, p);
        if (p[k] >= plane) grow_to(above, p);
        if (!((p[k] < plane && plane < q[k]) || (q[k] < plane && plane < p[k]))) continue;
        const double share = (double(plane) - double(p[k])) / (double(q[k]) - double(p[k]));
        for (std::size_t a = 0; a < 3; ++a) {
            // Six roundings of 2^-53, of numbers no larger than both coordinates together.
            const double x = double(p[a]) + share * (double(q[a]) - double(p[a]));
            const double error = 0x1p-49 * (std::abs(double(p[a])) + std::abs(double(q[a])));
            grow_to(below, a, x, error);
            grow_to(above, a, x, error);
        }
    }
    below.max[k] = plane;
    above.neg_min[k] = -plane;
    const float slack = slack_of(corners[0], corners[1], corners[2]);
    for (GrowingBox* side : {&below, &above}) {
        for (std::size_t a = 0; a < 3; ++a) {
            side->neg_min[a] += slack;
            side->max[a] += slack;
        }
    }
    left = within(ref, below);
    right = within(ref, above);
}

}  // namespace rc::build
