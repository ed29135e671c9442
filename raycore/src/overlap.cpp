// What a resting body overlaps: every triangle near it, the deepest kept in order.
#include "box_math.h"
#include "cast_query.h"
#include "contract.h"
#include "visit.h"

#include <algorithm>

namespace rc {

namespace {

// Deepest first; equal depth: lower instance, then lower primitive.
bool is_deeper(const CastHit& a, const CastHit& b) {
    if (a.depth != b.depth) return a.depth > b.depth;
    if (a.instance != b.instance) return a.instance < b.instance;
    return a.primitive < b.primitive;
}

bool is_same_triangle(const CastHit& a, const CastHit& b) {
    return a.instance == b.instance && a.primitive == b.primitive;
}

// Puts `hit` in its place among the first `count` of `out`, dropping the last when all are taken; the new
// count.
std::size_t insert(const CastHit& hit, std::span<CastHit> out, std::size_t count) {
    const auto end = out.begin() + static_cast<std::ptrdiff_t>(count);
    // The same triangle comes with the same depth, so it would stand here; trees may show it twice.
    const auto at = std::lower_bound(out.begin(), end, hit, is_deeper);
    if (at == out.end() || (at != end && is_same_triangle(*at, hit))) return count;
    const std::size_t new_count = std::min(count + 1, out.size());
    std::move_backward(at, out.begin() + static_cast<std::ptrdiff_t>(new_count) - 1,
                       out.begin() + static_cast<std::ptrdiff_t>(new_count));
    *at = hit;
    return new_count;
}

// A ball or a capsule.
std::size_t overlaps_of(const Scene& scene, const Segment& axis, float radius, LayerMask layers,
                        std::span<CastHit> out) {
    const std::optional<cast::PlacedBody> placed = cast::place(axis, radius, glm::vec3(0.0f));
    RC_EXPECTS(placed, "a body of finite place and size");
    if (!placed) return 0;
    std::size_t count = 0;
    visit_triangles(
        scene, placed->swept_box(0.0, 0.0), layers,
        [&](std::uint32_t instance, std::uint32_t primitive, const std::array<glm::vec3, 3>& corners) {
            const std::optional<cast::Contact> contact =
                cast::resting_contact(placed->body, placed->relative(corners));
            if (contact) count = insert(placed->hit(*contact, instance, primitive), out, count);
            return false;
        });
    return count;
}

// Asks `question(body, out)` for each body in its own part of `out`.
template <class Body, class Question>
void for_each_body(std::span<const Body> bodies, std::size_t capacity, std::span<CastHit> out,
                   std::span<std::uint32_t> counts, Question&& question) {
    RC_EXPECTS(counts.size() == bodies.size() && out.size() == bodies.size() * capacity,
               "a count for every body and room for its contacts");
    for (std::size_t i = 0; i < bodies.size(); ++i)
        counts[i] = static_cast<std::uint32_t>(question(bodies[i], out.subspan(i * capacity, capacity)));
}

}  // namespace

std::size_t sphere_overlaps(const Scene& scene, const glm::vec3& centre, float radius, LayerMask layers,
                            std::span<CastHit> out) {
    return overlaps_of(scene, {centre, centre}, radius, layers, out);
}

std::size_t capsule_overlaps(const Scene& scene, const Segment& axis, float radius, LayerMask layers,
                             std::span<CastHit> out) {
    return overlaps_of(scene, axis, radius, layers, out);
}

std::size_t box_overlaps(const Scene& scene, const OrientedBox& box, LayerMask layers,
                         std::span<CastHit> out) {
    const std::optional<cast::PlacedBox> placed = cast::place(box);
    RC_EXPECTS(placed, "a box of finite place and size whose axes span space");
    if (!placed) return 0;
    std::size_t count = 0;
    visit_triangles(
        scene, placed->around, layers,
        [&](std::uint32_t instance, std::uint32_t primitive, const std::array<glm::vec3, 3>& corners) {
            const std::optional<cast::Contact> contact = cast::resting_contact(*placed, corners);
            if (!contact) return false;
            const CastHit hit{.t = 0.0f,
                              .depth = static_cast<float>(contact->depth),
                              .point = glm::vec3(contact->point),
                              .normal = glm::vec3(contact->normal),
                              .primitive = primitive,
                              .instance = instance};
            count = insert(hit, out, count);
            return false;
        });
    return count;
}

void sphere_overlaps(const Scene& scene, std::span<const Ball> bodies, LayerMask layers, std::size_t capacity,
                     std::span<CastHit> out, std::span<std::uint32_t> counts) {
    for_each_body(bodies, capacity, out, counts, [&](const Ball& ball, std::span<CastHit> contacts) {
        return sphere_overlaps(scene, ball.centre, ball.radius, layers, contacts);
    });
}

void capsule_overlaps(const Scene& scene, std::span<const Capsule> bodies, LayerMask layers,
                      std::size_t capacity, std::span<CastHit> out, std::span<std::uint32_t> counts) {
    for_each_body(bodies, capacity, out, counts, [&](const Capsule& capsule, std::span<CastHit> contacts) {
        return capsule_overlaps(scene, capsule.axis, capsule.radius, layers, contacts);
    });
}

void box_overlaps(const Scene& scene, std::span<const OrientedBox> bodies, LayerMask layers,
                  std::size_t capacity, std::span<CastHit> out, std::span<std::uint32_t> counts) {
    for_each_body(bodies, capacity, out, counts, [&](const OrientedBox& box, std::span<CastHit> contacts) {
        return box_overlaps(scene, box, layers, contacts);
    });
}

}  // namespace rc
