// Casts of balls and capsules: the trees find the triangles near the sweep, cast_math answers for each.
#include "cast_query.h"
#include "contract.h"
#include "visit.h"

#include <bit>
#include <cstdint>
#include <tuple>

namespace rc {

namespace {

bool comes_first(const CastHit& a, const CastHit& b) {
    return std::tie(a.t, a.instance, a.primitive) < std::tie(b.t, b.instance, b.primitive);
}

// What is met later than the float after t can not come first any more.
double latest_tie(const CastHit& best) {
    if (best.instance == kNone) return static_cast<double>(kInfinity);
    return static_cast<double>(std::bit_cast<float>(std::bit_cast<std::uint32_t>(best.t) + 1));
}

// A hit of instance kNone when there is none.
CastHit first_hit(const Scene& scene, const Segment& axis, float radius, const glm::vec3& displacement,
                  LayerMask layers) {
    const std::optional<cast::PlacedBody> placed = cast::place(axis, radius, displacement);
    RC_EXPECTS(placed, "a body of finite place, way and size to cast");
    if (!placed) return {};

    CastHit best{.t = kInfinity};
    const int pieces = placed->pieces();
    for (int piece = 0; piece < pieces; ++piece) {
        const double from = static_cast<double>(piece) / pieces;
        double to = static_cast<double>(piece + 1) / pieces;
        if (latest_tie(best) < from) break;
        Box box = placed->swept_box(from, to);
        visit_triangles(
            scene, box, layers,
            [&](std::uint32_t instance, std::uint32_t primitive, const std::array<glm::vec3, 3>& corners) {
                const auto contact = cast::first_contact(placed->body, placed->relative(corners));
                if (!contact) return false;
                const CastHit hit = placed->hit(*contact, instance, primitive);
                if (!comes_first(hit, best)) return false;
                best = hit;
                if (latest_tie(best) >= to) return false;
                to = latest_tie(best);
                box = placed->swept_box(from, to);
                return true;
            });
    }
    return best.instance == kNone ? CastHit{} : best;
}

std::optional<CastHit> as_optional(const CastHit& hit) {
    if (hit.instance == kNone) return std::nullopt;
    return hit;
}

}  // namespace

std::optional<CastHit> sphere_cast(const Scene& scene, const glm::vec3& centre, float radius,
                                   const glm::vec3& displacement, LayerMask layers) {
    return as_optional(first_hit(scene, {centre, centre}, radius, displacement, layers));
}

std::optional<CastHit> capsule_cast(const Scene& scene, const Segment& axis, float radius,
                                    const glm::vec3& displacement, LayerMask layers) {
    return as_optional(first_hit(scene, axis, radius, displacement, layers));
}

void sphere_casts(const Scene& scene, std::span<const SphereCast> casts, LayerMask layers,
                  std::span<CastHit> hits) {
    RC_EXPECTS(casts.size() == hits.size(), "one hit for each cast");
    for (std::size_t i = 0; i < casts.size(); ++i) {
        const SphereCast& c = casts[i];
        hits[i] = first_hit(scene, {c.centre, c.centre}, c.radius, c.displacement, layers);
    }
}

void capsule_casts(const Scene& scene, std::span<const CapsuleCast> casts, LayerMask layers,
                   std::span<CastHit> hits) {
    RC_EXPECTS(casts.size() == hits.size(), "one hit for each cast");
    for (std::size_t i = 0; i < casts.size(); ++i) {
        const CapsuleCast& c = casts[i];
        hits[i] = first_hit(scene, c.axis, c.radius, c.displacement, layers);
    }
}

}  // namespace rc
