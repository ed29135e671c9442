// raycore/query.h - ask an immutable Scene what a ray meets; bodies.h, which comes with it, what a body meets.
//
// Cost      O(log triangles); no allocation, no lock, no virtual call.
// Threads   any number at once; a Scene never changes after SceneBuilder::commit().
// Same bits the answer depends on the scene and the query only: never on the ISA, the batch a ray travels in,
//           the thread that asks, or the order of the tree. Equal t: lower instance wins, then lower triangle.
// Bad rays  NaN anywhere, infinite origin or direction, zero direction, t_min > t_max or NaN: a contract
//           violation in dev builds, a miss in release. A query never fails.
#pragma once

#include "raycore/bodies.h"
#include "raycore/counters.h"
#include "raycore/ray.h"
#include "raycore/scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace rc {

// The nearest surface on the ray, either side of the triangle counting.
[[nodiscard]] std::optional<Hit> closest_hit(const Scene& scene, const Ray& ray, LayerMask layers);

// Whether anything at all lies on the ray: cheaper than closest_hit, and what shadows and sight should ask.
[[nodiscard]] bool any_hit(const Scene& scene, const Ray& ray, LayerMask layers);

// Every surface between two points, nearest first (ties as above), at most `out.size()` of them; returns how
// many were written. Sound asks this: each wall crossed takes its share. Two points at one place are a bad ray.
[[nodiscard]] std::size_t crossings(const Scene& scene, const glm::vec3& from, const glm::vec3& to,
                                    LayerMask layers, std::span<Hit> out);

// The surfaces that follow `last`, a hit of the same two points: call again with the last hit written, until fewer than
// out.size() are written, and every surface has come exactly once, also where many lie at one t. A miss is followed by
// nothing. Cost: a walk of its own, from where `last` lies.
[[nodiscard]] std::size_t crossings_after(const Scene& scene, const glm::vec3& from, const glm::vec3& to,
                                          LayerMask layers, const Hit& last, std::span<Hit> out);

// Batches: item i is answered exactly as the single query would. Spans of equal length (a
// contract violation otherwise, and unchecked in release); misses have t == kInfinity. `counters`, when given, is added to.
void closest_hits(const Scene& scene, std::span<const Ray> rays, LayerMask layers, std::span<Hit> hits,
                  Counters* counters = nullptr);
void any_hits(const Scene& scene, std::span<const Ray> rays, LayerMask layers, std::span<std::uint8_t> is_hit,
              Counters* counters = nullptr);
// Segment i writes counts[i] <= capacity hits from out[i * capacity] on; out.size() == segments * capacity.
void crossings(const Scene& scene, std::span<const Segment> segments, LayerMask layers, std::size_t capacity,
               std::span<Hit> out, std::span<std::uint32_t> counts);

}  // namespace rc
