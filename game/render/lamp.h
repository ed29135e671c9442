// render/lamp.h - what a lamp does at a point: how much light arrives if nothing stands in between, where to look for
// what does, and the highlight it leaves on a glossy surface.
//
// Irradiance is exact (closed form, clipped at the horizon) and so has no noise; shadow rays only estimate the share
// of the lamp that is visible.
// Same bits pure functions.
#pragma once

#include "world/level.h"
#include "world/snapshot.h"

#include "raycore/ray.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>

namespace gh::render {

// What of a lamp's own bulb stands in the way of its light, found once a level.
struct BulbClearance {
    float radius = 0.0f;  // around the lamp's position: shadow rays to point, spot and sphere end there
    float front = 0.0f;   // before a rect's plane, metres: rays to it end there
};
[[nodiscard]] BulbClearance bulb_clearance(const world::Level& level, const world::Snapshot& snapshot,
                                           const world::Lamp& lamp);

// W/m2 per colour on a surface at `position` that faces `normal` (unit), unshadowed. 0 beyond the lamp's range; the
// last sixth of the range fades, so that nothing pops.
[[nodiscard]] glm::vec3 lamp_irradiance(const world::Lamp& lamp, const glm::vec3& position,
                                        const glm::vec3& normal);

// An upper bound of the brightest channel of lamp_irradiance for any normal, at any point at least `distance` away.
[[nodiscard]] float lamp_bound(const world::Lamp& lamp, float distance);

// Whether the lamp has an extent, that is, soft shadows.
[[nodiscard]] bool is_area(const world::Lamp& lamp);

// A point on the lamp that a shadow ray aims at, `u` in [0, 1)^2; for a sun a point far towards it.
[[nodiscard]] glm::vec3 lamp_point(const world::Lamp& lamp, const glm::vec3& position, const glm::vec2& u);

// Unit direction towards the middle of the lamp.
[[nodiscard]] glm::vec3 direction_to(const world::Lamp& lamp, const glm::vec3& position);

// The way from `point` to `target` on the lamp, up to its bulb. Nothing when the point is inside the bulb: it is lit.
[[nodiscard]] std::optional<rc::Ray> shadow_ray(const world::Lamp& lamp, const BulbClearance& bulb,
                                                const rc::SurfacePoint& point, const glm::vec3& target);

inline constexpr float kSmallestAlpha = 0.0064f;  // of highlights of lamps without an extent

// A glossy surface as seen from one side.
struct Gloss {
    glm::vec3 normal{0.0f};
    glm::vec3 to_eye{0.0f};
    glm::vec3 f0{0.04f};
    float f90 = 1.0f;
    float alpha = 1.0f;  // roughness squared
};

// Radiance towards the eye, unshadowed: GGX, with an area lamp stood in for by the point on it that reflects best and
// a widened lobe (Karis 2013).
[[nodiscard]] glm::vec3 lamp_highlight(const world::Lamp& lamp, const glm::vec3& position,
                                       const Gloss& gloss);

}  // namespace gh::render
