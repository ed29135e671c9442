// render/lamp_shapes-inl.h - lamp.h for sixteen surfaces side by side: how a lamp of each shape scatters and shines. Compiled
// once per instruction set; a lane has the bits of lamp.cpp, whose comments hold here.
#if defined(GH_RENDER_LAMP_SHAPES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GH_RENDER_LAMP_SHAPES_INL_H_
#undef GH_RENDER_LAMP_SHAPES_INL_H_
#else
#define GH_RENDER_LAMP_SHAPES_INL_H_
#endif

#include "render/lamp_light.h"
#include "render/lane_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::render::HWY_NAMESPACE {

// Sixteen surfaces, or as many of them as a vector holds, and their ways to the lamp.
struct Lit {
    Way position, normal, to_eye;
    Floats alpha;
    Way offset;  // to the lamp's middle
    Floats distance2, distance;
};
static HWY_INLINE Lit lit_at(const LitSurfaces& surfaces, std::size_t i, const LampNumbers& lamp) {
    Lit lit{load(surfaces.position, i),
            load(surfaces.normal, i),
            load(surfaces.to_eye, i),
            hn::Load(F(), surfaces.alpha + i),
            {},
            {},
            {}};
    lit.offset = minus(splat(lamp.position), lit.position);
    lit.distance2 = dot(lit.offset, lit.offset);
    lit.distance = hn::Sqrt(lit.distance2);
    return lit;
}

static HWY_INLINE Floats range_fade(const LampNumbers& lamp, Floats distance) {
    constexpr float kFadeShare = 1.0f / 6.0f;
    if (!(lamp.range < __builtin_inff())) return splat(1.0f);
    return clamped(hn::Div(hn::Sub(splat(lamp.range), distance), splat(lamp.range * kFadeShare)), 0.0f, 1.0f);
}

static HWY_INLINE Floats cone_share(const LampNumbers& lamp, const Way& to_lamp) {
    if (lamp.shape != static_cast<int>(world::LampShape::Spot)) return splat(1.0f);
    const Floats cosine = hn::Neg(dot(to_lamp, splat(lamp.direction)));
    const float width = lamp.cos_inner - lamp.cos_outer;
    const Floats share =
        hn::Div(hn::Sub(cosine, splat(lamp.cos_outer)), splat(width < 1e-4f ? 1e-4f : width));
    const Floats inside = clamped(share, 0.0f, 1.0f);
    return hn::Mul(inside, inside);
}

// Irradiance over the lamp's radiance; `is_cut`: it is to be found where the horizon cuts the lamp.
struct Scattered {
    Floats ratio;
    Which is_cut;
};

static HWY_INLINE Scattered ball_irradiance(const LampNumbers& lamp, const Lit& at) {
    const Floats sin_radius = hn::Div(splat(lamp.radius), at.distance);
    const Floats cosine = hn::Div(dot(at.normal, at.offset), at.distance);
    const Floats whole = hn::Mul(hn::Mul(hn::Mul(splat(kPi), sin_radius), sin_radius), cosine);
    const auto is_outside = hn::Gt(at.distance, splat(lamp.radius));
    const auto is_above = hn::Ge(cosine, sin_radius), is_below = hn::Le(cosine, hn::Neg(sin_radius));
    const auto is_cut = hn::AndNot(hn::Or(is_above, is_below), is_outside);
    return {hn::IfThenElse(is_outside, hn::IfThenElseZero(is_above, whole), splat(kPi)), is_cut};
}

static HWY_INLINE Scattered rect_irradiance(const LampNumbers& lamp, const Lit& at) {
    const Way u = splat(lamp.half_u), v = splat(lamp.half_v), &centre = at.offset;
    const Way corner[4] = {minus(minus(centre, u), v), minus(plus(centre, u), v), plus(plus(centre, u), v),
                           plus(minus(centre, u), v)};
    const auto is_before = hn::Lt(dot(centre, splat(lamp.direction)), splat(0.0f));
    auto are_above = is_before, are_below = is_before;
    for (const Way& c : corner) {
        const auto is_high = hn::Ge(dot(at.normal, c), splat(0.0f));
        are_above = hn::And(are_above, is_high);
        are_below = hn::AndNot(is_high, are_below);
    }
    const std::size_t lanes = hn::Lanes(F());
    alignas(64) float lengths[4 * kLitTogether] = {}, along[4 * kLitTogether] = {}, angles[4 * kLitTogether];
    Floats height[4], size[4];
    for (std::size_t i = 0; i < 4; ++i) {
        const Way &a = corner[i], &b = corner[(i + 1) % 4], across = cross(a, b);
        size[i] = length(across);
        height[i] = dot(at.normal, across);
        hn::Store(size[i], F(), lengths + i * lanes);
        hn::Store(dot(a, b), F(), along + i * lanes);
    }
    arcs(lengths, along, 4 * lanes, angles);
    Floats sum = splat(0.0f);
    for (std::size_t i = 0; i < 4; ++i) {
        const Floats edge = hn::Div(hn::Mul(hn::Load(F(), angles + i * lanes), height[i]), size[i]);
        sum = hn::IfThenElse(hn::Gt(size[i], splat(0.0f)), hn::Add(sum, edge), sum);
    }
    return {hn::IfThenElseZero(are_above, hn::Mul(splat(0.5f), hn::Abs(sum))),
            hn::AndNot(hn::Or(are_above, are_below), is_before)};
}

// lamp_irradiance over the lamp's intensity.
static HWY_INLINE Scattered scattered(const LampNumbers& lamp, const Lit& at) {
    const auto nowhere = hn::Lt(splat(0.0f), splat(0.0f));
    const auto shape = static_cast<world::LampShape>(lamp.shape);
    if (shape == world::LampShape::Sun)
        return {larger(splat(0.0f), hn::Neg(dot(at.normal, splat(lamp.direction)))), nowhere};
    const Floats fade = range_fade(lamp, at.distance);
    Scattered result{splat(0.0f), nowhere};
    if (shape == world::LampShape::Sphere || shape == world::LampShape::Rect) {
        result = shape == world::LampShape::Sphere ? ball_irradiance(lamp, at) : rect_irradiance(lamp, at);
        result.ratio = hn::Mul(fade, result.ratio);
    } else {
        const Way to_lamp = over(at.offset, at.distance);
        const Floats cosine = larger(splat(0.0f), dot(at.normal, to_lamp));
        result.ratio = hn::Div(hn::Mul(hn::Mul(fade, cone_share(lamp, to_lamp)), cosine), at.distance2);
    }
    const auto is_there = hn::And(hn::Gt(fade, splat(0.0f)), hn::Gt(at.distance, splat(0.0f)));
    return {hn::IfThenElseZero(is_there, result.ratio), hn::And(is_there, result.is_cut)};
}

// A lamp as one direction, a perpendicular irradiance over its intensity, and a lobe widened by the lamp's size.
struct LanesStandIn {
    Way to_lamp;  // unit, or 0
    Floats irradiance, alpha_u, alpha_v;
};

static HWY_INLINE Way best_rect_point(const LampNumbers& lamp, const Lit& at, const Way& reflected) {
    const Way direction = splat(lamp.direction), u_axis = splat(lamp.half_u), v_axis = splat(lamp.half_v);
    const Floats towards = dot(reflected, direction);
    const Floats ahead = hn::Div(dot(at.offset, direction), towards);
    const Floats reach = hn::IfThenElse(hn::Lt(towards, splat(-1e-4f)), ahead, at.distance);
    const Way offset = minus(times(reflected, reach), at.offset);
    const Floats u = hn::Div(dot(offset, u_axis), splat(lamp.length2_u));
    const Floats v = hn::Div(dot(offset, v_axis), splat(lamp.length2_v));
    return plus(plus(at.offset, times(u_axis, clamped(u, -1.0f, 1.0f))),
                times(v_axis, clamped(v, -1.0f, 1.0f)));
}

static HWY_INLINE LanesStandIn stand_in(const LampNumbers& lamp, const Lit& at) {
    constexpr float kSmallest = kSmallestAlpha;
    const auto shape = static_cast<world::LampShape>(lamp.shape);
    const Floats sharp = larger(at.alpha, splat(kSmallest));
    if (shape == world::LampShape::Sun) {
        const Way direction = splat(lamp.direction);
        return {
            {hn::Neg(direction.x), hn::Neg(direction.y), hn::Neg(direction.z)}, splat(1.0f), sharp, sharp};
    }
    const Floats distance = larger(at.distance, splat(lamp.radius));
    auto is_there = hn::Gt(distance, splat(0.0f));
    const Floats per_distance2 = hn::Div(range_fade(lamp, distance), hn::Mul(distance, distance));
    const Floats twice = hn::Mul(splat(2.0f), dot(at.normal, at.to_eye));
    const Way reflected = minus(times(at.normal, twice), at.to_eye);
    LanesStandIn light;
    if (shape == world::LampShape::Sphere) {
        const Way to_ray = minus(times(reflected, dot(at.offset, reflected)), at.offset);
        const Floats off = length(to_ray), radius = splat(lamp.radius);
        const Way near = times(to_ray, hn::Div(radius, off));
        const Way best = plus(at.offset, choose(hn::Gt(off, radius), near, to_ray));
        const Floats wide = hn::Add(at.alpha, hn::Div(splat(0.5f * lamp.radius), distance));
        light = {normalized(best), hn::Mul(splat(kPi * lamp.radius * lamp.radius), per_distance2), wide,
                 wide};
    } else if (shape == world::LampShape::Rect) {
        const Floats facing = hn::Div(hn::Neg(dot(at.offset, splat(lamp.direction))), distance);
        is_there = hn::And(is_there, hn::Gt(facing, splat(0.0f)));
        const Floats spread = hn::Div(hn::Sqrt(hn::Div(facing, splat(kPi))), distance);
        light = {normalized(best_rect_point(lamp, at, reflected)),
                 hn::Mul(hn::Mul(splat(lamp.area), facing), per_distance2),
                 hn::Add(at.alpha, hn::Mul(splat(lamp.length_u), spread)),
                 hn::Add(at.alpha, hn::Mul(splat(lamp.length_v), spread))};
    } else {
        const Way to_lamp = over(at.offset, distance);
        light = {to_lamp, hn::Mul(per_distance2, cone_share(lamp, to_lamp)), sharp, sharp};
    }
    light.to_lamp = only(is_there, light.to_lamp);
    return light;
}

static HWY_INLINE Floats ggx_density(Floats cos_half, Floats alpha) {
    const Floats a2 = hn::Mul(alpha, alpha);
    const Floats d = hn::Add(hn::Mul(hn::Mul(cos_half, cos_half), hn::Sub(a2, splat(1.0f))), splat(1.0f));
    return hn::Div(a2, hn::Mul(hn::Mul(splat(kPi), d), d));
}
static HWY_INLINE Floats ggx_visibility(Floats cos_eye, Floats cos_light, Floats alpha) {
    const Floats a2 = hn::Mul(alpha, alpha), rest = hn::Sub(splat(1.0f), a2);
    const auto root = [&](Floats c) { return hn::Sqrt(hn::Add(hn::Mul(hn::Mul(c, c), rest), a2)); };
    const Floats both = hn::Add(hn::Mul(cos_light, root(cos_eye)), hn::Mul(cos_eye, root(cos_light)));
    return hn::Div(splat(0.5f), larger(both, splat(1e-7f)));
}

// lamp_highlight.
static HWY_INLINE Way highlight(const LampNumbers& lamp, const LitSurfaces& surfaces, std::size_t i,
                                const Lit& at) {
    const LanesStandIn light = stand_in(lamp, at);
    const Floats cos_eye = dot(at.normal, at.to_eye), cos_light = dot(at.normal, light.to_lamp);
    const Way half = normalized(plus(at.to_eye, light.to_lamp));
    const Floats cos_half = clamped(dot(at.normal, half), 0.0f, 1.0f);
    const Floats cos_half_eye = clamped(dot(at.to_eye, half), 0.0f, 1.0f);
    const Floats alpha = larger(at.alpha, splat(1e-4f));
    const Floats widened = hn::Div(hn::Mul(alpha, alpha), hn::Mul(light.alpha_u, light.alpha_v));
    const Floats lobe = hn::Mul(hn::Mul(ggx_density(cos_half, alpha), smaller(widened, splat(1.0f))),
                                ggx_visibility(cos_eye, cos_light, alpha));
    const Floats m = clamped(hn::Sub(splat(1.0f), cos_half_eye), 0.0f, 1.0f);
    const Floats m5 = hn::Mul(hn::Mul(hn::Mul(hn::Mul(m, m), m), m), m);
    const Way f0 = load(surfaces.f0, i);
    const Floats f90 = hn::Load(F(), surfaces.f90 + i);
    const Way schlick = plus(f0, times(minus({f90, f90, f90}, f0), m5));
    const Way irradiance = times(splat(lamp.intensity), light.irradiance);
    const auto is_lit = hn::And(hn::Gt(cos_light, splat(0.0f)), hn::Gt(cos_eye, splat(0.0f)));
    return only(is_lit, times(times(irradiance, schlick), hn::Mul(lobe, cos_light)));
}

}  // namespace gh::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
