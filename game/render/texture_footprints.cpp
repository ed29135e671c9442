#include "render/texture_footprints.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/texture_footprints.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gh::render::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Patches = hn::CappedTag<float, kPatches>;
using PatchInts = hn::RebindToSigned<Patches>;
using PerPatch = hn::Vec<Patches>;

struct Way {
    PerPatch x, y, z;
};

static HWY_INLINE PerPatch splat(float number) {
    return hn::Set(Patches(), number);
}
static HWY_INLINE Way load(const TexturePatches::Lanes (&way)[3], std::size_t i) {
    const Patches d;
    return {hn::Load(d, way[0] + i), hn::Load(d, way[1] + i), hn::Load(d, way[2] + i)};
}
static HWY_INLINE PerPatch dot(const Way& a, const Way& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
static HWY_INLINE Way times(const Way& a, PerPatch by) {
    return {hn::Mul(a.x, by), hn::Mul(a.y, by), hn::Mul(a.z, by)};
}
static HWY_INLINE Way cross(const Way& a, const Way& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(b.y, a.z)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(b.z, a.x)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(b.x, a.y))};
}

// Comparisons, since instruction sets differ in which of a number and a NaN their minimum is.
static HWY_INLINE PerPatch larger(PerPatch a, PerPatch b) {
    return hn::IfThenElse(hn::Gt(b, a), b, a);
}
static HWY_INLINE PerPatch smaller(PerPatch a, PerPatch b) {
    return hn::IfThenElse(hn::Lt(b, a), b, a);
}

static HWY_INLINE Way choose(hn::Mask<Patches> which, const Way& yes, const Way& no) {
    return {hn::IfThenElse(which, yes.x, no.x), hn::IfThenElse(which, yes.y, no.y),
            hn::IfThenElse(which, yes.z, no.z)};
}

// Unit, in the plane: the way the ray leans, any where it does not lean at all.
static HWY_INLINE Way leaning(const Way& direction, const Way& normal) {
    const Way down = times(normal, dot(direction, normal)), nothing{splat(0.0f), splat(0.0f), splat(0.0f)};
    const Way slant{hn::Sub(direction.x, down.x), hn::Sub(direction.y, down.y), hn::Sub(direction.z, down.z)};
    const Way level{hn::Neg(normal.z), nothing.x, normal.x}, upright{nothing.x, normal.z, hn::Neg(normal.y)};
    const Way any = choose(hn::Lt(hn::Abs(normal.y), splat(0.9f)), level, upright);
    const Way way = choose(hn::Gt(dot(slant, slant), splat(0.0f)), slant, any);
    const PerPatch length = hn::Sqrt(dot(way, way));
    return {hn::Div(way.x, length), hn::Div(way.y, length), hn::Div(way.z, length)};
}

// Of a number that is at least 1, off by 1.2e-4 at most: exact at powers of two, a cubic (least worst error) between.
static HWY_INLINE PerPatch log2_of(PerPatch x) {
    const Patches d;
    const PatchInts ints;
    const auto bits = hn::BitCast(ints, x);
    const PerPatch exponent = hn::ConvertTo(d, hn::Sub(hn::ShiftRight<23>(bits), hn::Set(ints, 127)));
    const auto mantissa = hn::Or(hn::And(bits, hn::Set(ints, 0x7FFFFF)), hn::Set(ints, 0x3F800000));
    const PerPatch m = hn::Sub(hn::BitCast(d, mantissa), splat(1.0f));
    PerPatch bend = hn::Add(hn::Mul(m, splat(0.0821307f)), splat(-0.2390582f));
    bend = hn::Add(hn::Mul(m, bend), splat(0.4387257f));
    return hn::Add(exponent, hn::Add(m, hn::Mul(hn::Mul(m, hn::Sub(splat(1.0f), m)), bend)));
}

struct Axis {
    PerPatch u, v;  // texture units
    PerPatch texels;
};
static HWY_INLINE Axis axis_along(const TexturePatches& patches, const Way& way, std::size_t i) {
    const Patches d;
    const PerPatch u = dot(way, load(patches.u_gradient, i)), v = dot(way, load(patches.v_gradient, i));
    const PerPatch across = hn::Mul(u, hn::Load(d, patches.size[0] + i));
    const PerPatch down = hn::Mul(v, hn::Load(d, patches.size[1] + i));
    return {u, v, hn::Sqrt(hn::Add(hn::Mul(across, across), hn::Mul(down, down)))};
}

static void place(TexturePatches& patches, std::size_t count, float max_taps) {
    constexpr float kFarthest = 1e6f;   // beyond that texel coordinates mean nothing; nor do those of a NaN
    constexpr float kFlattest = 0.02f;  // least cosine between plane and ray
    const Patches d;
    const PerPatch one = splat(1.0f), half = splat(0.5f);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Way direction = load(patches.direction, i), normal = load(patches.normal, i);
        const Way along = leaning(direction, normal);
        const PerPatch width = hn::Load(d, patches.cone_width + i);
        const PerPatch cosine = larger(hn::Abs(dot(direction, normal)), splat(kFlattest));
        const Axis major = axis_along(patches, times(along, hn::Div(width, cosine)), i);
        const Axis minor = axis_along(patches, times(cross(normal, along), width), i);

        // As many taps along the long axis as make each about round; what is left over is blurred away.
        const PerPatch wanted = hn::Ceil(hn::Div(major.texels, larger(minor.texels, one)));
        const auto is_long = hn::And(hn::Gt(wanted, one), hn::Lt(major.texels, splat(kFarthest)));
        const PerPatch taps = hn::IfThenElse(is_long, smaller(wanted, splat(max_taps)), one);
        const PerPatch blur = larger(minor.texels, hn::Div(major.texels, taps));
        const PerPatch level = hn::IfThenElseZero(hn::Gt(blur, one), log2_of(blur));
        hn::Store(smaller(level, hn::Load(d, patches.last_level + i)), d, patches.level + i);
        hn::Store(taps, d, patches.taps + i);

        const PerPatch u = hn::Load(d, patches.uv[0] + i), v = hn::Load(d, patches.uv[1] + i);
        const auto is_near =
            hn::And(hn::Lt(hn::Abs(u), splat(kFarthest)), hn::Lt(hn::Abs(v), splat(kFarthest)));
        const PerPatch back = hn::Sub(half, hn::Mul(half, taps));
        const PerPatch u_step = hn::IfThenElseZero(is_long, hn::Div(major.u, taps));
        const PerPatch v_step = hn::IfThenElseZero(is_long, hn::Div(major.v, taps));
        hn::Store(u_step, d, patches.step[0] + i);
        hn::Store(v_step, d, patches.step[1] + i);
        hn::Store(hn::Add(hn::IfThenElseZero(is_near, u), hn::Mul(u_step, back)), d, patches.first[0] + i);
        hn::Store(hn::Add(hn::IfThenElseZero(is_near, v), hn::Mul(v_step, back)), d, patches.first[1] + i);
    }
}

}  // namespace gh::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::render {

HWY_EXPORT(place);

void place_taps(TexturePatches& patches, std::size_t count, float max_taps) {
    HWY_DYNAMIC_DISPATCH(place)(patches, count, max_taps);
}

}  // namespace gh::render
#endif
