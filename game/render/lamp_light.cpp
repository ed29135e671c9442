#include "render/lamp_light.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/lamp_light.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "render/lamp_shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::render::HWY_NAMESPACE {

constexpr float kFaintestSeen = 4e-4f;  // W/m2/sr in the picture: less than that is not worth a shadow ray
constexpr float kNothing = 0.25f * kFaintestSeen;  // a part of a lamp's light that is not worked out
constexpr float kLeastTurning =
    0.05f;  // a lamp nearer the horizon does not tell how its light turns with the normal

// irradiance_bound of lamp_bounds.h.
struct Bounds {
    Floats facing, any;
};
static HWY_INLINE Bounds bounds_at(const LampNumbers& lamp, const Lit& at) {
    constexpr float kFar2 = 16.0f, kNearest2 = 0.5625f, kRounding = 1.0f + 0x1p-20f;
    const Floats zero = splat(0.0f), infinite = splat(__builtin_inff());
    const Floats height = hn::Add(dot(at.normal, at.offset), splat(lamp.extent));
    const auto is_above = hn::Gt(height, zero);
    const auto is_far = hn::Gt(at.distance2, splat(kFar2 * lamp.extent * lamp.extent));
    const auto is_beyond = hn::Ge(at.distance, splat(lamp.nothing_from * kRounding));
    const Floats along =
        hn::Add(hn::Neg(dot(at.offset, splat(lamp.axis))), hn::Mul(splat(0x1p-20f), at.distance));
    const auto is_beside = hn::Lt(along, hn::Mul(splat(lamp.bound_cos_outer), at.distance));
    Floats any = hn::Div(splat(lamp.strength), hn::Mul(splat(kNearest2), at.distance2));
    Floats facing = hn::Mul(any, smaller(splat(1.0f), hn::Div(height, hn::Mul(splat(0.75f), at.distance))));
    const auto is_nothing = hn::Or(is_beyond, is_beside);
    any = hn::IfThenElse(is_far, hn::IfThenElse(is_nothing, zero, any), infinite);
    facing = hn::IfThenElse(is_far, hn::IfThenElse(is_nothing, zero, facing), infinite);
    return {hn::IfThenElseZero(is_above, facing), hn::IfThenElseZero(is_above, any)};
}

// highlight_bound of lamp_bounds.h.
static HWY_INLINE Floats highlight_bound_at(const LampNumbers& lamp, const Lit& at, Floats any, Floats f90) {
    const Way to_lamp = over(at.offset, at.distance);
    const Floats cos_eye = larger(dot(at.normal, at.to_eye), splat(0.05f));
    const Floats along = hn::Add(cos_eye, dot(at.normal, to_lamp));
    const Floats both = hn::Add(splat(2.0f), hn::Mul(splat(2.0f), dot(at.to_eye, to_lamp)));
    const Floats cos_half2 = smaller(splat(1.0f), hn::Div(hn::Mul(along, along), larger(both, splat(1e-6f))));
    const Floats narrow = larger(at.alpha, splat(kSmallestAlpha));
    const Floats wide = hn::Add(narrow, hn::Div(splat(lamp.extent), at.distance));
    const Floats wide2 = hn::Mul(wide, wide);
    const Floats spread = hn::Add(splat(1.0f), hn::Mul(cos_half2, hn::Sub(wide2, splat(1.0f))));
    const Floats lobe = hn::Div(wide2, hn::Mul(hn::Mul(splat(kPi), spread), spread));
    const Floats most = hn::Div(hn::Mul(hn::Mul(hn::Mul(any, f90), lobe), wide2), hn::Mul(narrow, narrow));
    const auto is_known = hn::And(hn::Lt(any, splat(__builtin_inff())), hn::Gt(at.distance, splat(0.0f)));
    return hn::IfThenElse(is_known, hn::Div(most, hn::Mul(splat(4.0f), cos_eye)), splat(__builtin_inff()));
}

// Takes light away smoothly where the smooth surface still faces a lamp that its triangles turn away from, which
// would otherwise show them one by one (Chiang, Li and Burley 2019).
static HWY_INLINE Floats terminator(const Way& geometric, const Way& normal, const Way& to_lamp) {
    const Floats one = splat(1.0f), cos_bend = dot(geometric, normal);
    const Floats cos_geometric = dot(geometric, to_lamp), cos_smooth = dot(normal, to_lamp);
    const Floats g =
        clamped(hn::Div(cos_geometric, hn::Mul(cos_smooth, larger(cos_bend, splat(0.05f)))), 0.0f, 1.0f);
    const Floats share = hn::Mul(g, hn::Sub(hn::Add(one, g), hn::Mul(g, g)));
    const auto is_whole = hn::Or(hn::Gt(cos_bend, splat(0.99999f)), hn::Not(hn::Gt(cos_smooth, splat(0.0f))));
    return hn::IfThenElse(is_whole, one, share);
}

static HWY_INLINE Way direction_to(const LampNumbers& lamp, const Lit& at) {
    const Way direction = splat(lamp.direction);
    const Way back{hn::Neg(direction.x), hn::Neg(direction.y), hn::Neg(direction.z)};
    if (lamp.shape == static_cast<int>(world::LampShape::Sun)) return back;
    return choose(hn::Gt(at.distance, splat(0.0f)), over(at.offset, at.distance), back);
}

// All but the sums; false where no surface can see any of it.
static bool shine_on(const LampNumbers& lamp, const LitSurfaces& surfaces, LampLight& out) {
    const Floats zero = splat(0.0f), nothing = splat(kNothing);
    bool any_lit = false;
    for (std::size_t i = 0; i < kLitTogether; i += hn::Lanes(F())) {
        const auto is_asked = hn::Ne(hn::Load(F(), out.asked + i), zero);
        const Lit at = lit_at(surfaces, i, lamp);
        const Bounds bound = bounds_at(lamp, at);
        const Floats f90 = hn::Load(F(), surfaces.f90 + i);
        const Floats most_diffuse = brightest(load(surfaces.diffuse, i));
        const Floats most_shine = brightest(load(surfaces.weight, i));
        const auto scatters = hn::And(is_asked, hn::Gt(hn::Mul(bound.facing, most_diffuse), nothing));
        const Floats shown = hn::Mul(highlight_bound_at(lamp, at, bound.any, f90), most_shine);
        const auto is_glossy = hn::And(hn::Gt(f90, zero), hn::Gt(bound.any, zero));
        const auto shines = hn::And(hn::And(is_asked, is_glossy), hn::Gt(shown, nothing));
        hn::Store(hn::IfThenElseZero(hn::Or(scatters, shines), splat(1.0f)), F(), out.counts + i);
        hn::Store(zero, F(), out.is_cut + i);
        if (hn::AllFalse(F(), hn::Or(scatters, shines))) continue;
        any_lit = true;

        const Way to_lamp = direction_to(lamp, at);
        const Floats share = terminator(load(surfaces.geometric, i), at.normal, to_lamp);
        store(to_lamp, out.to_lamp, i);
        hn::Store(share, F(), out.share + i);
        Way irradiance{zero, zero, zero}, shine = irradiance;
        if (!hn::AllFalse(F(), scatters)) {
            const Scattered found = scattered(lamp, at);
            irradiance = only(scatters, times(splat(lamp.intensity), found.ratio));
            const auto is_cut = hn::And(scatters, found.is_cut);
            hn::Store(hn::IfThenElseZero(is_cut, splat(1.0f)), F(), out.is_cut + i);
        }
        if (!hn::AllFalse(F(), shines)) shine = only(shines, highlight(lamp, surfaces, i, at));
        store(irradiance, out.irradiance, i);
        store(shine, out.shine, i);
    }
    return any_lit;
}

// 0 where light is too faint to matter, 1 from twice that on: nothing pops in.
static bool add_up(const LitSurfaces& surfaces, LampLight& out, LampSums& sums) {
    bool any_counts = false;
    for (std::size_t i = 0; i < kLitTogether; i += hn::Lanes(F())) {
        const auto is_lit = hn::Ne(hn::Load(F(), out.counts + i), splat(0.0f));
        if (hn::AllFalse(F(), is_lit)) continue;
        const Floats share = hn::Load(F(), out.share + i);
        Way irradiance = times(load(out.irradiance, i), share);
        const Way shine = times(load(out.shine, i), share), to_lamp = load(out.to_lamp, i);
        const Way light =
            plus(times(load(surfaces.diffuse, i), irradiance), times(load(surfaces.weight, i), shine));
        const Floats seen = hn::Sub(hn::Div(brightest(light), splat(kFaintestSeen)), splat(1.0f));
        const Floats counts = hn::IfThenElseZero(is_lit, clamped(seen, 0.0f, 1.0f));
        const auto is_seen = hn::Gt(counts, splat(0.0f));
        hn::Store(counts, F(), out.counts + i);
        store(times(light, counts), out.light, i);
        if (hn::AllFalse(F(), is_seen)) continue;
        any_counts = true;

        irradiance = times(irradiance, counts);
        const auto add = [&](LitLanes(&sum)[3], Which where, const Way& more) {
            const Way before = load(sum, i);
            store(choose(where, plus(before, more), before), sum, i);
        };
        add(sums.irradiance, is_seen, irradiance);
        add(sums.shine, is_seen, times(shine, counts));
        const Floats cosine = dot(to_lamp, load(surfaces.normal, i));
        const auto turns = hn::And(is_seen, hn::Gt(cosine, splat(kLeastTurning)));
        const Way upright = over(irradiance, cosine);
        add(sums.turns[0], turns, times(upright, to_lamp.x));
        add(sums.turns[1], turns, times(upright, to_lamp.y));
        add(sums.turns[2], turns, times(upright, to_lamp.z));
    }
    return any_counts;
}

}  // namespace gh::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <glm/geometric.hpp>

namespace gh::render {

HWY_EXPORT(shine_on);
HWY_EXPORT(add_up);

namespace {

void copy(const glm::vec3& from, float (&to)[3]) {
    for (glm::length_t axis = 0; axis < 3; ++axis) to[axis] = from[axis];
}

}  // namespace

LampNumbers lamp_numbers(const world::Lamp& lamp, const LampReach& reach) {
    LampNumbers numbers{};
    numbers.shape = static_cast<int>(lamp.shape);
    copy(lamp.position, numbers.position);
    copy(lamp.direction, numbers.direction);
    copy(lamp.intensity, numbers.intensity);
    copy(lamp.half_u, numbers.half_u);
    copy(lamp.half_v, numbers.half_v);
    numbers.length_u = glm::length(lamp.half_u);
    numbers.length_v = glm::length(lamp.half_v);
    numbers.length2_u = glm::dot(lamp.half_u, lamp.half_u);
    numbers.length2_v = glm::dot(lamp.half_v, lamp.half_v);
    numbers.area = 4.0f * numbers.length_u * numbers.length_v;
    numbers.radius = lamp.radius;
    numbers.range = lamp.range;
    numbers.cos_inner = lamp.cos_inner;
    numbers.cos_outer = lamp.cos_outer;
    numbers.extent = reach.extent;
    numbers.strength = reach.strength;
    numbers.nothing_from = reach.range;
    copy(reach.axis, numbers.axis);
    numbers.bound_cos_outer = reach.cos_outer;
    return numbers;
}

glm::mat3 LampSums::turns_at(std::size_t i) const {
    return {lane(turns[0], i), lane(turns[1], i), lane(turns[2], i)};
}

bool add_lamp(const world::Lamp& lamp, const LampNumbers& numbers, const LitSurfaces& surfaces,
              LampLight& out, LampSums& sums) {
    if (!HWY_DYNAMIC_DISPATCH(shine_on)(numbers, surfaces, out)) return false;
    for (std::size_t i = 0; i < surfaces.count; ++i) {
        if (out.is_cut[i] != 0.0f)
            set_lane(out.irradiance, i,
                     lamp_irradiance(lamp, lane(surfaces.position, i), lane(surfaces.normal, i)));
    }
    return HWY_DYNAMIC_DISPATCH(add_up)(surfaces, out, sums);
}

}  // namespace gh::render
#endif
