// render/light_angles.h - angles in [0, pi] by cosine and sine, as the light tree adds and compares them.
#pragma once

#include <algorithm>
#include <cmath>

namespace gh::render {

[[nodiscard]] inline float sine_of(float cosine) {
    return std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
}

struct Angle {
    float cos, sin;
};

// Of max(0, a - b).
[[nodiscard]] inline Angle difference(const Angle& a, const Angle& b) {
    if (a.cos > b.cos) return {1.0f, 0.0f};
    return {a.cos * b.cos + a.sin * b.sin, a.sin * b.cos - a.cos * b.sin};
}

}  // namespace gh::render
