// What a resting capsule overlaps: every triangle near it, the deepest kept in order.
#include "cast_query.h"
#include "contract.h"
#include "visit.h"

#include <algorithm>

namespace rc {

namespace {

// Deepest first; equal depth: lower instance, then lower primitive.
bool comes_first(const CastHit& a, const CastHit& b) {
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
    const auto at = std::lower_bound(out.begin(), end, hit, comes_first);
    if (at == out.end() || (at != end && is_same_triangle(*at, hit))) return count;
    const std::size_t new_count = std::min(count + 1, out.size());
    std::move_backward(at, out.begin() + static_cast<std::ptrdiff_t>(new_count) - 1,
                       out.begin() + static_cast<std::ptrdiff_t>(new_count));
    *at = hit;
    return new_count;
}

}  // namespace

std::size_t capsule_overlaps(const Scene& scene, const Segment& axis, float radius, LayerMask layers,
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

}  // namespace rc
