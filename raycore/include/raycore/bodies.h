// raycore/bodies.h - ask an immutable Scene what moving and resting bodies meet, and what lies nearest to a point.
//
// Cost      O(log triangles + triangles near the body); no allocation, no lock, no virtual call. In double precision.
// Threads   any number at once; a Scene never changes after SceneBuilder::commit().
// Same bits the answer depends on the scene and the question only. Ties: lower instance wins, then lower triangle.
// Frames    everything is asked and answered in the world's frame: instances' scales, shears and mirrors apply to the
//           triangles, never to the body. A triangle's corners are taken as floats of the world.
// Bad input a number that is NaN or infinite, a negative size: a contract violation in dev builds, and meets nothing
//           in release. A question never fails.
#pragma once

#include "raycore/ray.h"
#include "raycore/scene.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace rc {

// What a moving body touches first. Exact against the triangles and failing closed: a cast that reports no
// contact has none. Instances' scales apply to the world, not to the body: a sphere stays a sphere.
struct CastHit {
    float t = 0.0f;          // share of the displacement travelled, in [0, 1]
    float depth = 0.0f;      // how deep the body already is when t == 0 (0 when it just touches)
    glm::vec3 point{0.0f};   // contact on the triangle, world frame
    glm::vec3 normal{0.0f};  // unit, from the surface towards the body's axis: the way out
    std::uint32_t primitive = kNone;
    std::uint32_t instance = kNone;
};

// A ball of `radius` >= 0 whose centre moves from `centre` by `displacement` (zero: an overlap test). Touching
// at the start while moving away or along is no hit unless it overlaps by more than rounding (4 units in the
// last place of its position, at most half the radius); nor is grazing by no more than that on the way, so
// that seams stop nobody.
[[nodiscard]] std::optional<CastHit> sphere_cast(const Scene& scene, const glm::vec3& centre, float radius,
                                                 const glm::vec3& displacement, LayerMask layers);

// The same for all points within `radius` of the segment `axis`.
[[nodiscard]] std::optional<CastHit> capsule_cast(const Scene& scene, const Segment& axis, float radius,
                                                  const glm::vec3& displacement, LayerMask layers);

struct SphereCast {
    glm::vec3 centre{0.0f};
    float radius = 0.0f;
    glm::vec3 displacement{0.0f};
};
struct CapsuleCast {
    Segment axis;
    float radius = 0.0f;
    glm::vec3 displacement{0.0f};
};
// hits[i].instance == kNone marks a cast that meets nothing; its t is 0 and says nothing. Spans of equal length.
void sphere_casts(const Scene& scene, std::span<const SphereCast> casts, LayerMask layers,
                  std::span<CastHit> hits);
void capsule_casts(const Scene& scene, std::span<const CapsuleCast> casts, LayerMask layers,
                   std::span<CastHit> hits);

// Bodies at rest.
struct Ball {
    glm::vec3 centre{0.0f};
    float radius = 0.0f;
};
struct Capsule {  // all points within `radius` of the axis
    Segment axis;
    float radius = 0.0f;
};
struct OrientedBox {
    glm::vec3 centre{0.0f};
    glm::vec3 half{0.0f};  // half of each side
    glm::mat3 axes{
        1.0f};  // columns: where its sides point. Made orthonormal, in order, before use; flat is bad input
};

// Everything a resting body overlaps, one contact a triangle, deepest first (equal depth: ties as above), at most
// out.size() of them; the number written. Characters push themselves out of moved doors with this. `t` is 0. Moving
// the body by depth along normal leads it clear of that triangle, and no shorter move does (but a capsule whose axis
// goes through is led out along the triangle's own normal). Overlapping means by more than rounding: 4 units in the
// last place of the body's position, at most half the radius or half the least of a box's `half`; touching is not.
// `point` lies on the triangle: nearest to the axis of a ball or capsule; in the middle of what is deepest in a box.
[[nodiscard]] std::size_t sphere_overlaps(const Scene& scene, const glm::vec3& centre, float radius,
                                          LayerMask layers, std::span<CastHit> out);
[[nodiscard]] std::size_t capsule_overlaps(const Scene& scene, const Segment& axis, float radius,
                                           LayerMask layers, std::span<CastHit> out);
[[nodiscard]] std::size_t box_overlaps(const Scene& scene, const OrientedBox& box, LayerMask layers,
                                       std::span<CastHit> out);

// Batches: body i writes counts[i] <= capacity contacts from out[i * capacity] on, exactly as the single question would;
// out.size() == bodies.size() * capacity.
void sphere_overlaps(const Scene& scene, std::span<const Ball> bodies, LayerMask layers, std::size_t capacity,
                     std::span<CastHit> out, std::span<std::uint32_t> counts);
void capsule_overlaps(const Scene& scene, std::span<const Capsule> bodies, LayerMask layers,
                      std::size_t capacity, std::span<CastHit> out, std::span<std::uint32_t> counts);
void box_overlaps(const Scene& scene, std::span<const OrientedBox> bodies, LayerMask layers,
                  std::size_t capacity, std::span<CastHit> out, std::span<std::uint32_t> counts);

// The place of the scene nearest to a point.
struct Nearest {
    float distance = kInfinity;  // rounded to the nearest float; ties are of this
    glm::vec3 point{0.0f};       // on the triangle
    glm::vec3 normal{0.0f};      // unit, from there to the point asked for; the triangle's own at distance 0
    std::uint32_t primitive = kNone;
    std::uint32_t instance = kNone;

    [[nodiscard]] bool is_none() const { return primitive == kNone; }
};

// Nothing when the scene begins farther away than `max_distance` (>= 0, included). Strongly unequal scales make it
// slower, never wrong.
[[nodiscard]] std::optional<Nearest> closest_point(const Scene& scene, const glm::vec3& point,
                                                   float max_distance, LayerMask layers);
// nearest[i] answers points[i]; is_none() marks that there is nothing.
void closest_points(const Scene& scene, std::span<const glm::vec3> points, float max_distance,
                    LayerMask layers, std::span<Nearest> nearest);

}  // namespace rc
