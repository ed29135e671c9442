#include "render/probe_weights.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/probe_weights.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gh::render::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 8>;
using I = hn::RebindToSigned<F>;
using Floats = hn::Vec<F>;
using Ints = hn::Vec<I>;

static HWY_INLINE Floats splat(float x) {
    return hn::Set(F(), x);
}

static HWY_INLINE Floats dot(Floats ax, Floats ay, Floats az, Floats bx, Floats by, Floats bz) {
    return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

static HWY_INLINE Floats clamped(Floats v, float low, float high) {
    return hn::Min(hn::Max(v, splat(low)), splat(high));
}

struct Moments {
    Floats mean, square;
};

// Of texel (x, y), which may lie one beyond an edge: there the map goes on at the mirrored place of the same edge.
static HWY_INLINE Moments moments_at(const float* moments, Ints first, Floats x, Floats y) {
    constexpr float kLast = kSightSide - 1;
    const auto beyond_x = hn::Or(hn::Lt(x, splat(0.0f)), hn::Gt(x, splat(kLast)));
    const Floats inside_x = clamped(x, 0.0f, kLast);
    const Floats turned_y = hn::IfThenElse(beyond_x, hn::Sub(splat(kLast), y), y);
    const auto beyond_y = hn::Or(hn::Lt(turned_y, splat(0.0f)), hn::Gt(turned_y, splat(kLast)));
    const Floats inside_y = clamped(turned_y, 0.0f, kLast);
    const Floats turned_x = hn::IfThenElse(beyond_y, hn::Sub(splat(kLast), inside_x), inside_x);
    const Floats texel = hn::Add(hn::Mul(inside_y, splat(kSightSide)), turned_x);
    const Ints at = hn::Add(first, hn::ConvertTo(I(), hn::Mul(texel, splat(2.0f))));
    return {hn::GatherIndex(F(), moments, at), hn::GatherIndex(F(), moments + 1, at)};
}

// Bilinear over the octahedral map (octahedron.h).
static HWY_INLINE Moments moments_towards(const float* moments, Ints first, Floats x, Floats y, Floats z) {
    const Floats one = splat(1.0f);
    const Floats sum = hn::Add(hn::Add(hn::Abs(x), hn::Abs(y)), hn::Abs(z));
    const Floats u = hn::Div(x, sum), v = hn::Div(y, sum);
    const auto is_below = hn::Lt(z, splat(0.0f));
    const Floats folded_u = hn::IfThenElse(is_below, hn::CopySign(hn::Sub(one, hn::Abs(v)), u), u);
    const Floats folded_v = hn::IfThenElse(is_below, hn::CopySign(hn::Sub(one, hn::Abs(u)), v), v);
    const auto place = [&](Floats t) {
        return hn::Sub(hn::Mul(hn::Add(hn::Mul(t, splat(0.5f)), splat(0.5f)), splat(kSightSide)),
                       splat(0.5f));
    };
    const Floats at_x = place(folded_u), at_y = place(folded_v);
    const Floats low_x = hn::Floor(at_x), low_y = hn::Floor(at_y);
    const Floats fx = hn::Sub(at_x, low_x), fy = hn::Sub(at_y, low_y);
    const Floats gx = hn::Sub(one, fx), gy = hn::Sub(one, fy);
    const Floats high_x = hn::Add(low_x, one), high_y = hn::Add(low_y, one);
    const Moments a = moments_at(moments, first, low_x, low_y), b = moments_at(moments, first, high_x, low_y);
    const Moments c = moments_at(moments, first, low_x, high_y),
                  d = moments_at(moments, first, high_x, high_y);
    const Floats wa = hn::Mul(gx, gy), wb = hn::Mul(fx, gy), wc = hn::Mul(gx, fy), wd = hn::Mul(fx, fy);
    const auto blend = [&](Floats p, Floats q, Floats r, Floats s) {
        return hn::Add(hn::Add(hn::Add(hn::Mul(p, wa), hn::Mul(q, wb)), hn::Mul(r, wc)), hn::Mul(s, wd));
    };
    return {blend(a.mean, b.mean, c.mean, d.mean), blend(a.square, b.square, c.square, d.square)};
}

// Chebyshev's bound on the share of directions nearby that reach as far as `distance`, less what is too unlikely to be
// anything but a wall in between, to the third power.
static HWY_INLINE Floats share_that_reaches(const Moments& moments, Floats distance) {
    constexpr float kUnlikely = 0.2f;
    const Floats spread = hn::Sub(moments.square, hn::Mul(moments.mean, moments.mean));
    const Floats variance = hn::Max(spread, hn::Mul(splat(1e-4f), moments.square));
    const Floats beyond = hn::Sub(distance, moments.mean);
    const Floats bound = hn::Div(variance, hn::Add(variance, hn::Mul(beyond, beyond)));
    const Floats likely = hn::Max(hn::Zero(F()), hn::Sub(bound, splat(kUnlikely)));
    const Floats share = hn::Div(likely, splat(1.0f - kUnlikely));
    const Floats cubed = hn::Mul(hn::Mul(share, share), share);
    return hn::IfThenElse(hn::Gt(distance, moments.mean), cubed, splat(1.0f));
}

static void weigh(const ProbeQuery& query, float weight[8]) {
    const Floats nx = splat(query.normal[0]), ny = splat(query.normal[1]), nz = splat(query.normal[2]);
    const Ints floats_a_point = hn::Set(I(), static_cast<int>(kSightMoments));
    for (std::size_t i = 0; i < 8; i += hn::Lanes(F())) {
        const Ints corner = hn::Iota(I(), static_cast<int>(i));
        const auto offset = [&](int axis) {
            const Floats far = hn::IfThenElseZero(
                hn::RebindMask(F(), hn::Ne(hn::And(corner, hn::Set(I(), 1 << axis)), hn::Zero(I()))),
                splat(query.spacing[axis]));
            return hn::Sub(splat(query.from[axis] - query.low[axis]), far);
        };
        const Floats dx = offset(0), dy = offset(1), dz = offset(2);
        const Floats distance = hn::Sqrt(dot(dx, dy, dz, dx, dy, dz));
        const auto is_apart = hn::Gt(distance, hn::Zero(F()));
        const Floats divisor = hn::IfThenElse(is_apart, distance, splat(1.0f));
        const Floats x = hn::IfThenElse(is_apart, hn::Div(dx, divisor), nx);
        const Floats y = hn::IfThenElse(is_apart, hn::Div(dy, divisor), ny);
        const Floats z = hn::IfThenElse(is_apart, hn::Div(dz, divisor), nz);
        // 0: the point is behind the surface
        const Floats before = hn::Sub(splat(0.5f), hn::Mul(splat(0.5f), dot(x, y, z, nx, ny, nz)));
        const Floats facing = hn::Add(hn::Mul(before, before), splat(0.05f));
        const Ints point = hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(query.point) + i);
        const Ints first = hn::Mul(point, floats_a_point);
        const Floats reaches = share_that_reaches(moments_towards(query.moments, first, x, y, z), distance);
        const Floats plain = hn::LoadU(F(), query.plain + i);
        hn::StoreU(hn::Mul(hn::Mul(plain, facing), reaches), F(), weight + i);
    }
}

}  // namespace gh::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::render {

HWY_EXPORT(weigh);

void weigh_probes(const ProbeQuery& query, float weight[8]) {
    HWY_DYNAMIC_DISPATCH(weigh)(query, weight);
}

}  // namespace gh::render
#endif
