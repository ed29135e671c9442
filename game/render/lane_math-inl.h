// render/lane_math-inl.h - numbers and vectors of up to sixteen surfaces side by side, each by the operations that glm and
// det_math take, in their order: a lane has the bits of the plain code. Compiled once per instruction set.
#if defined(GH_RENDER_LANE_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GH_RENDER_LANE_MATH_INL_H_
#undef GH_RENDER_LANE_MATH_INL_H_
#else
#define GH_RENDER_LANE_MATH_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace gh::render::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using Floats = hn::Vec<F>;
using Which = hn::Mask<F>;

static HWY_INLINE Floats splat(float number) {
    return hn::Set(F(), number);
}

// Comparisons, since instruction sets differ in which of a number and a NaN their minimum is. As std::max and std::min.
static HWY_INLINE Floats larger(Floats a, Floats b) {
    return hn::IfThenElse(hn::Lt(a, b), b, a);
}
static HWY_INLINE Floats smaller(Floats a, Floats b) {
    return hn::IfThenElse(hn::Lt(b, a), b, a);
}
static HWY_INLINE Floats clamped(Floats x, float low, float high) {
    const Floats not_below = hn::IfThenElse(hn::Lt(x, splat(low)), splat(low), x);
    return hn::IfThenElse(hn::Gt(not_below, splat(high)), splat(high), not_below);
}

struct Way {
    Floats x, y, z;
};

static HWY_INLINE Way splat(const float (&way)[3]) {
    return {splat(way[0]), splat(way[1]), splat(way[2])};
}
template <class Lanes>
static HWY_INLINE Way load(const Lanes (&way)[3], std::size_t i) {
    return {hn::Load(F(), way[0] + i), hn::Load(F(), way[1] + i), hn::Load(F(), way[2] + i)};
}
template <class Lanes>
static HWY_INLINE void store(const Way& way, Lanes (&to)[3], std::size_t i) {
    hn::Store(way.x, F(), to[0] + i);
    hn::Store(way.y, F(), to[1] + i);
    hn::Store(way.z, F(), to[2] + i);
}
static HWY_INLINE Way plus(const Way& a, const Way& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
static HWY_INLINE Way minus(const Way& a, const Way& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
static HWY_INLINE Way times(const Way& a, Floats by) {
    return {hn::Mul(a.x, by), hn::Mul(a.y, by), hn::Mul(a.z, by)};
}
static HWY_INLINE Way times(const Way& a, const Way& b) {
    return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
}
static HWY_INLINE Way over(const Way& a, Floats by) {
    return {hn::Div(a.x, by), hn::Div(a.y, by), hn::Div(a.z, by)};
}
static HWY_INLINE Way choose(Which which, const Way& yes, const Way& no) {
    return {hn::IfThenElse(which, yes.x, no.x), hn::IfThenElse(which, yes.y, no.y),
            hn::IfThenElse(which, yes.z, no.z)};
}
static HWY_INLINE Way only(Which which, const Way& way) {
    return {hn::IfThenElseZero(which, way.x), hn::IfThenElseZero(which, way.y),
            hn::IfThenElseZero(which, way.z)};
}
static HWY_INLINE Floats dot(const Way& a, const Way& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
static HWY_INLINE Floats length(const Way& a) {
    return hn::Sqrt(dot(a, a));
}
static HWY_INLINE Way normalized(const Way& a) {
    return times(a, hn::Div(splat(1.0f), length(a)));
}
static HWY_INLINE Way cross(const Way& a, const Way& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(b.y, a.z)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(b.z, a.x)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(b.x, a.y))};
}
static HWY_INLINE Floats brightest(const Way& c) {
    return larger(larger(c.x, c.y), c.z);
}

// det::atan2(y[i], x[i]) of y > 0, neither NaN; of other y any number: `count`, a multiple of sixteen, of them.
static HWY_INLINE void arcs(const float* y, const float* x, std::size_t count, float* angle) {
    alignas(64) static constexpr double kAtanOfEighths[16] = {
        0x0.0p+0,
        0x1.fd5ba9aac2f6ep-4,
        0x1.f5b75f92c80ddp-3,
        0x1.6f61941e4def1p-2,
        0x1.dac670561bb4fp-2,
        0x1.1e00babdefeb4p-1,
        0x1.4978fa3269ee1p-1,
        0x1.700a7c5784634p-1,
        0x1.921fb54442d18p-1,
    };
    const hn::CappedTag<double, 8> d;
    const hn::Rebind<float, decltype(d)> floats;
    const hn::RebindToSigned<decltype(d)> ints;
    const auto set = [&](double number) { return hn::Set(d, number); };
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto wide_x = hn::PromoteTo(d, hn::Load(floats, x + i));
        const auto high = hn::PromoteTo(d, hn::Load(floats, y + i)), flat = hn::Abs(wide_x);
        const auto is_steep = hn::Gt(high, flat);
        const auto most = hn::IfThenElse(is_steep, high, flat), least = hn::IfThenElse(is_steep, flat, high);
        const auto both_infinite = hn::Eq(least, set(static_cast<double>(__builtin_inff())));
        auto ratio = hn::IfThenElseZero(hn::Gt(most, set(0.0)), hn::Div(least, most));
        ratio = hn::IfThenElse(both_infinite, set(1.0), ratio);

        const auto nearest = hn::Floor(hn::Add(hn::Mul(ratio, set(8.0)), set(0.5)));
        const auto c = hn::Mul(nearest, set(0.125));
        const auto r = hn::Div(hn::Sub(ratio, c), hn::Add(set(1.0), hn::Mul(ratio, c)));
        const auto z = hn::Mul(r, r);
        auto sum = hn::Sub(hn::Mul(set(1.0 / 9.0), z), set(1.0 / 7.0));
        sum = hn::Add(hn::Mul(sum, z), set(1.0 / 5.0));
        sum = hn::Sub(hn::Mul(sum, z), set(1.0 / 3.0));
        const auto eighths = hn::GatherIndex(d, kAtanOfEighths, hn::ConvertTo(ints, nearest));
        auto arc = hn::Add(eighths, hn::Add(r, hn::Mul(hn::Mul(r, z), sum)));
        arc = hn::IfThenElse(is_steep, hn::Sub(set(0x1.921fb54442d18p+0), arc), arc);
        arc = hn::IfThenElse(hn::Lt(wide_x, set(0.0)), hn::Sub(set(0x1.921fb54442d18p+1), arc), arc);
        hn::Store(hn::DemoteTo(floats, arc), floats, angle + i);
    }
}

}  // namespace gh::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
