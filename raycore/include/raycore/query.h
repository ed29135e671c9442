// raycore/query.h - ask an immutable Scene what a ray, or a moving body, meets.
//
// Cost      O(log triangles); no allocation, no lock, no virtual call.
// Threads   any number at once; a Scene never changes after SceneBuilder::commit().
// Same bits the answer depends on the scene and the query only: never on the ISA, the batch a ray travels in,
//           the thread that asks, or the order of the tree. Equal t: lower instance wins, then lower triangle.
// Bad rays  NaN anywhere, infinite origin or direction, zero direction, t_min > t_max or NaN: a contract
//           violation in dev builds, a miss in release. A query never fails.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "raycore/counters.h"
#include "raycore/ray.h"
#include "raycore/scene.h"

namespace rc {

// The nearest surface on the ray, either side of the triangle counting.
[[nodiscard]] std::optional<Hit> closest_hit(const Scene& scene, const Ray& ray, LayerMask layers);

// Whether anything at all lies on the ray: cheaper than closest_hit, and what shadows and sight should ask.
[[nodiscard]] bool any_hit(const Scene& scene, const Ray& ray, LayerMask layers);

// Every surface between two points, nearest first (ties as above), at most `out.size()` of them; returns how
// many were written. Sound asks this: each wall crossed takes its share.
[[nodiscard]] std::size_t crossings(const Scene& scene, const glm::vec3& from, const glm::vec3& to,
                                    LayerMask layers, std::span<Hit> out);

// Batches: item i is answered exactly as the single query would. Spans of equal length; misses have
// t == kInfinity. `counters`, when given, is added to.
void closest_hits(const Scene& scene, std::span<const Ray> rays, LayerMask layers, std::span<Hit> hits,
                  Counters* counters = nullptr);
void any_hits(const Scene& scene, std::span<const Ray> rays, LayerMask layers, std::span<std::uint8_t> is_hit,
              Counters* counters = nullptr);
// Segment i writes counts[i] <= capacity hits from out[i * capacity] on; out.size() == segments * capacity.
void crossings(const Scene& scene, std::span<const Segment> segments, LayerMask layers, std::size_t capacity,
               std::span<Hit> out, std::span<std::uint32_t> counts);

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
// hits[i].instance == kNone marks a cast that meets nothing.
void sphere_casts(const Scene& scene, std::span<const SphereCast> casts, LayerMask layers, std::span<CastHit> hits);
void capsule_casts(const Scene& scene, std::span<const CapsuleCast> casts, LayerMask layers,
                   std::span<CastHit> hits);

// Everything a resting body overlaps, one contact a triangle, deepest first, at most out.size(); the number
// written. Characters push themselves out of moved doors with this.
[[nodiscard]] std::size_t capsule_overlaps(const Scene& scene, const Segment& axis, float radius, LayerMask layers,
                                           std::span<CastHit> out);

}  // namespace rc
