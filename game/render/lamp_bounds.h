// render/lamp_bounds.h - the most a lamp can do at a point, to leave it out before anything is worked out: a pixel asks a dozen
// lamps and few answer.
//
// Same bits pure functions.
#pragma once

#include "render/lamp.h"
#include "render/light_math.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

struct LampReach {
    glm::vec3 position{0.0f};
    float extent = 0.0f;          // of the lamp around it, metres; infinite for a sun
    float strength = 0.0f;        // brightest channel's irradiance times distance squared
    float range = rc::kInfinity;  // nothing from there on
    glm::vec3 axis{0.0f};         // of a spot
    float cos_outer = -2.0f;      // nothing outside
};

[[nodiscard]] inline LampReach lamp_reach(const world::Lamp& lamp) {
    const float brightest = std::max({lamp.intensity.x, lamp.intensity.y, lamp.intensity.z});
    LampReach reach{.position = lamp.position, .strength = brightest, .range = lamp.range};
    switch (lamp.shape) {
        case world::LampShape::Sun:
            reach.extent = reach.range = rc::kInfinity;
            break;
        case world::LampShape::Sphere:
            reach.extent = lamp.radius;
            reach.strength *= kPi * lamp.radius * lamp.radius;
            break;
        case world::LampShape::Rect: {
            const float u = glm::length(lamp.half_u), v = glm::length(lamp.half_v);
            reach.extent = u + v;
            reach.strength *= 4.0f * u * v;
            break;
        }
        case world::LampShape::Spot:
            reach.axis = lamp.direction;
            reach.cos_outer = lamp.cos_outer;
            break;
        default:
            break;
    }
    return reach;
}

// An upper bound of the brightest channel of lamp_irradiance, for this normal and for any.
struct IrradianceBound {
    float facing = 0.0f;
    float any = 0.0f;  // 0 where the lamp is wholly below the horizon, or does not shine
};
[[nodiscard]] inline IrradianceBound irradiance_bound(const LampReach& reach, const glm::vec3& position,
                                                      const glm::vec3& normal) {
    const glm::vec3 offset = reach.position - position;
    const float distance2 = glm::dot(offset, offset);
    const float height = glm::dot(normal, offset) + reach.extent;
    if (!(height > 0.0f)) return {};
    // From four extents on the nearest point is at least three quarters as far as the middle.
    constexpr float kFar2 = 16.0f, kNearest2 = 0.5625f;
    if (!(distance2 > kFar2 * reach.extent * reach.extent)) return {rc::kInfinity, rc::kInfinity};
    const float distance = std::sqrt(distance2);
    constexpr float kRounding = 1.0f + 0x1p-20f;
    if (distance >= reach.range * kRounding) return {};
    if (-glm::dot(offset, reach.axis) + 0x1p-20f * distance < reach.cos_outer * distance) return {};
    const float any = reach.strength / (kNearest2 * distance2);
    return {any * std::min(1.0f, height / (0.75f * distance)), any};
}

// About the most that lamp_highlight can give there, by the lobe at the lamp's middle, widened by its extent; `bound` is
// irradiance_bound's for any normal.
[[nodiscard]] inline float highlight_bound(const LampReach& reach, float bound, const glm::vec3& position,
                                           const Gloss& gloss) {
    const glm::vec3 offset = reach.position - position;
    const float distance = glm::length(offset);
    if (!(bound < rc::kInfinity) || !(distance > 0.0f)) return rc::kInfinity;
    const glm::vec3 to_lamp = offset / distance;
    const float cos_eye_lamp = glm::dot(gloss.to_eye, to_lamp);
    const float cos_eye = std::max(glm::dot(gloss.normal, gloss.to_eye), 0.05f);
    const float along = cos_eye + glm::dot(gloss.normal, to_lamp);
    const float cos_half2 = std::min(1.0f, along * along / std::max(2.0f + 2.0f * cos_eye_lamp, 1e-6f));
    const float wide = std::max(gloss.alpha, kSmallestAlpha) + reach.extent / distance;
    const float spread = 1.0f + cos_half2 * (wide * wide - 1.0f);
    const float lobe = wide * wide / (kPi * spread * spread);
    const float narrow = std::max(gloss.alpha, kSmallestAlpha);
    return bound * gloss.f90 * lobe * (wide * wide) / (narrow * narrow) / (4.0f * cos_eye);
}

}  // namespace gh::render
