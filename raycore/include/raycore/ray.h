// raycore/ray.h - rays, what they meet, and how a ray leaves a surface.
//
// Units     whatever the scene uses (the game: metres, right-handed, +y up). t counts in multiples of the
//           direction, which need not be unit: t_max = 1 means "up to origin + direction".
// Intervals closed: a surface exactly at t_min or t_max is met; one whose t is too large for a float is not. Both sides
//           of a triangle count.
#pragma once

#include <cstdint>
#include <limits>

#include <glm/vec3.hpp>

namespace rc {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr std::uint32_t kNone = 0xFFFFFFFFu;

// An instance is met only by queries that share a bit with it.
using LayerMask = std::uint32_t;
inline constexpr LayerMask kAllLayers = 0xFFFFFFFFu;

struct Ray {
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f, 0.0f, 1.0f};
    float t_min = 0.0f;
    float t_max = kInfinity;
    // The surface this ray starts on: never reported, so that nothing shadows itself. kNone: no such surface.
    std::uint32_t skip_instance = kNone;
    std::uint32_t skip_primitive = kNone;
};
static_assert(sizeof(Ray) == 40);

// The straight way from `from` to `to`, both ends included.
struct Segment {
    glm::vec3 from{0.0f};
    glm::vec3 to{0.0f};
};

// Position = (1 - u - v) * vertex0 + u * vertex1 + v * vertex2 of triangle `primitive` as it was given to the
// builder. A miss has t == kInfinity and both ids kNone.
struct Hit {
    float t = kInfinity;
    float u = 0.0f;
    float v = 0.0f;
    std::uint32_t primitive = kNone;
    std::uint32_t instance = kNone;

    [[nodiscard]] bool is_miss() const { return primitive == kNone; }
};
static_assert(sizeof(Hit) == 20);

// Where a hit is, found from barycentrics (never from origin + t * direction), with a bound on its rounding
// error per axis (Pharr, Jakob, Humphreys: Physically Based Rendering, section 6.8).
struct SurfacePoint {
    glm::vec3 position{0.0f};
    glm::vec3 position_error{0.0f};  // |true - position| <= position_error, per axis
    glm::vec3 normal{0.0f};          // unit, geometric: counter-clockwise corners seen from the tip
    std::uint32_t instance = kNone;
    std::uint32_t primitive = kNone;
};

// Leaves `point` towards `direction` from just off the surface (four times the error bound, on the side the
// direction goes to) and skips the surface itself.
[[nodiscard]] Ray spawn_ray(const SurfacePoint& point, const glm::vec3& direction, float t_max = kInfinity);

// Reaches from `point` up to `target`, both ends exact to rounding: t_max is 1.
[[nodiscard]] Ray spawn_ray_to(const SurfacePoint& point, const glm::vec3& target);

}  // namespace rc
