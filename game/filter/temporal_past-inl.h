// filter/temporal_past-inl.h - where the surfaces of a vector of pixels were a frame ago, and the light that is kept of them.
// Compiled once per instruction set; see simd-inl.h.
#if defined(GH_FILTER_TEMPORAL_PAST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GH_FILTER_TEMPORAL_PAST_INL_H_
#undef GH_FILTER_TEMPORAL_PAST_INL_H_
#else
#define GH_FILTER_TEMPORAL_PAST_INL_H_
#endif

#include "filter/taps-inl.h"
#include "filter/temporal_light_kernel.h"
#include "filter/vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

constexpr float kSameDistance = 0.03f;  // of a distance from the eye
constexpr float kLeastWeight = 1e-3f;   // of a tap
constexpr float kSameFacing = 0.8f;     // least cosine between the normals of one surface
// What a tap of the same part counts that faces elsewhere: nine of them less than the least that does not. Where there are no
// others they are better than nothing, until a sample comes: their mean is worth a tenth of its samples.
constexpr float kOtherFacing = 0.1f * kLeastWeight;
constexpr float kOtherCount = 0.1f;
constexpr float kNowhere = -1e6f;
// Of a pixel. Rounding noise about a whole pixel would else blur a little.
constexpr float kPlaceSteps = 256.0f;
constexpr std::int32_t kSky = -1;  // kNoSurface

static HWY_INLINE Lanes both(Lanes a, Lanes b) {
    return hn::And(a, b);
}
static HWY_INLINE Lanes equal(Ints a, Ints b) {
    return hn::RebindMask(F(), hn::Eq(a, b));
}

// What a vector of pixels shows.
struct Seen {
    Ints part;
    Vector normal, position;
};

// Where the pixels' surfaces were a frame ago.
struct Motion {
    Floats x, y;  // pixels
    Floats distance, was_distance;
};

// A unit vector's components in a byte each, to a half in a hundred and twenty-seven.
constexpr float kFacingSteps = 127.0f;
constexpr std::int32_t kFacingMiddle = 128;

static HWY_INLINE Ints packed_facing(const Vector& normal) {
    const auto byte = [](Floats component) {
        return hn::Add(hn::NearestInt(hn::Mul(component, splat(kFacingSteps))), hn::Set(I(), kFacingMiddle));
    };
    return hn::Or(byte(normal.x),
                  hn::Or(hn::ShiftLeft<8>(byte(normal.y)), hn::ShiftLeft<16>(byte(normal.z))));
}

static HWY_INLINE Lanes faces(Ints packed, const Vector& normal) {
    const auto component = [](Ints bits) {
        const Ints byte = hn::And(bits, hn::Set(I(), 255));
        return hn::ConvertTo(F(), hn::Sub(byte, hn::Set(I(), kFacingMiddle)));
    };
    const Vector then{component(packed), component(hn::ShiftRight<8>(packed)),
                      component(hn::ShiftRight<16>(packed))};
    return hn::Ge(dot(then, normal), splat(kSameFacing * kFacingSteps));
}

static HWY_INLINE Floats to_steps(Floats place) {
    const Floats steps = hn::Floor(hn::Add(hn::Mul(place, splat(kPlaceSteps)), splat(0.5f)));
    return hn::Mul(steps, splat(1.0f / kPlaceSteps));
}

static HWY_INLINE Motion motion_of(const SpreadRow& row, std::size_t x, const Seen& here) {
    const Lanes is_sky = equal(here.part, hn::Set(I(), kSky));
    const Floats middle = splat(0.5f);
    const Floats number = hn::ConvertTo(F(), pixel_numbers(static_cast<std::ptrdiff_t>(x)));
    const Floats at_x = hn::Add(hn::Add(number, middle), splat(row.jitter[0]));
    const float at_y = static_cast<float>(row.y) + 0.5f + row.jitter[1];
    const Vector eye = splat3(row.eye);
    const Vector way = plus(splat3(row.corner), scaled(splat3(row.right), at_x));
    const Vector sky = plus(eye, scaled(way, hn::Div(splat(kToSky), length(way))));
    const auto width = static_cast<std::size_t>(row.width);
    const Vector was = choose(is_sky, sky, load3(row.previous, x, width));
    Motion motion;
    motion.distance = choose(is_sky, splat(kToSky), length(minus(here.position, eye)));
    const Vector from_eye = minus(was, splat3(row.eye_before));
    motion.was_distance = length(from_eye);
    motion.x = motion.y = hn::Zero(F());
    if (!row.has_past) return motion;
    const float* m = row.picture_before;
    const Vector then = plus(plus(scaled(splat3(m), from_eye.x), scaled(splat3(m + 3), from_eye.y)),
                             scaled(splat3(m + 6), from_eye.z));
    const Floats by_x = to_steps(hn::Sub(hn::Div(then.x, then.z), at_x));
    const Floats by_y = to_steps(hn::Sub(hn::Div(then.y, then.z), splat(at_y)));
    const Floats far = splat(-kNowhere);
    const Lanes is_seen =
        both(hn::Gt(then.z, hn::Zero(F())), both(hn::Lt(hn::Abs(by_x), far), hn::Lt(hn::Abs(by_y), far)));
    motion.x = choose(is_seen, by_x, splat(kNowhere));
    motion.y = choose(is_seen, by_y, splat(kNowhere));
    return motion;
}

struct Kept {
    Vector light;
    Floats count;
};

// What is asked of a tap, and what the taps sum up to.
struct Taps {
    const SpreadRow& row;
    const Seen& here;
    Floats was_distance;
    Kept sum;
    Floats total;

    HWY_INLINE void add(const TapPlace& place, std::ptrdiff_t step, Lanes lanes, Floats weight) {
        const KeptPlanes& then = row.then;
        const Floats count = read_tap(then.count, place, step);
        const Floats off = hn::Abs(hn::Sub(read_tap(then.distance, place, step), was_distance));
        const Lanes is_same = both(
            equal(read_tap(then.part, place, step), here.part),
            both(hn::Gt(count, hn::Zero(F())), hn::Le(off, hn::Mul(was_distance, splat(kSameDistance)))));
        const Lanes is_one = hn::Or(equal(here.part, hn::Set(I(), kSky)),
                                    faces(read_tap(then.facing, place, step), here.normal));
        const Floats counted = choose(is_one, weight, hn::Mul(weight, splat(kOtherFacing)));
        const Floats share = zero_unless(both(lanes, is_same), counted);
        const Vector light{read_tap(then.light[0], place, step), read_tap(then.light[1], place, step),
                           read_tap(then.light[2], place, step)};
        sum.light = plus(sum.light, scaled(light, share));
        sum.count = hn::Add(sum.count, hn::Mul(count, share));
        total = hn::Add(total, share);
    }
};

static HWY_INLINE Lanes in_picture(const SpreadRow& row, Ints x, Ints y) {
    return both(inside(x, row.width), inside(y, row.height));
}

// An edge that one frame saw on this side and the other on that: any of the nine pixels around will do.
static HWY_NOINLINE void look_around(Taps& taps, Floats at_x, Floats at_y, Lanes lanes) {
    const Ints stride = hn::Set(I(), static_cast<std::int32_t>(taps.row.then.stride));
    const Ints x = hn::ConvertTo(I(), hn::Floor(hn::Add(at_x, splat(0.5f))));
    const Ints y = hn::ConvertTo(I(), hn::Floor(hn::Add(at_y, splat(0.5f))));
    for (int i = 0; i < 9; ++i) {
        const Ints u = hn::Add(x, hn::Set(I(), i % 3 - 1)), v = hn::Add(y, hn::Set(I(), i / 3 - 1));
        const Lanes matter = both(lanes, in_picture(taps.row, u, v));
        if (hn::AllFalse(F(), matter)) continue;
        const Ints place = hn::Add(hn::Mul(v, stride), u);
        const Ints safe = hn::IfThenElseZero(hn::RebindMask(I(), matter), place);
        taps.add(scattered(safe), 0, matter, splat(1.0f));
    }
}

static HWY_INLINE Kept kept_light(const SpreadRow& row, std::size_t x, const Motion& motion,
                                  const Seen& here) {
    const Floats zero = hn::Zero(F()), one = splat(1.0f);
    const Vector nothing{zero, zero, zero};
    const Floats number = hn::ConvertTo(F(), pixel_numbers(static_cast<std::ptrdiff_t>(x)));
    const Floats at_x = hn::Add(number, motion.x);
    const Floats at_y = hn::Add(splat(static_cast<float>(row.y)), motion.y);
    const Floats outside = splat(-1.0f);
    const Lanes lanes = both(both(hn::Gt(at_x, outside), hn::Gt(at_y, outside)),
                             both(hn::Lt(at_x, splat(static_cast<float>(row.width))),
                                  hn::Lt(at_y, splat(static_cast<float>(row.height)))));
    if (!row.has_past || hn::AllFalse(F(), lanes)) return {nothing, zero};
    const Floats low_x = hn::Floor(at_x), low_y = hn::Floor(at_y);
    const Floats share_x = hn::Sub(at_x, low_x), share_y = hn::Sub(at_y, low_y);
    const Ints u = hn::ConvertTo(I(), low_x), v = hn::ConvertTo(I(), low_y);
    const Ints first = hn::Add(hn::Mul(v, hn::Set(I(), static_cast<std::int32_t>(row.then.stride))), u);
    const TapPlace place = place_of(hn::IfThenElseZero(hn::RebindMask(I(), lanes), first), lanes);
    const KeptPlanes& then = row.then;
    for (const float* plane : {then.light[0], then.light[1], then.light[2], then.count, then.distance})
        foresee_tap(plane, place, 2 * then.stride);
    for (const std::uint32_t* plane : {then.part, then.facing}) foresee_tap(plane, place, 2 * then.stride);
    Taps taps{row, here, motion.was_distance, {nothing, zero}, zero};
    for (int corner = 0; corner < 4; ++corner) {
        const int right = corner % 2, below = corner / 2;
        const Floats weight = hn::Mul(right != 0 ? share_x : hn::Sub(one, share_x),
                                      below != 0 ? share_y : hn::Sub(one, share_y));
        const Lanes matter =
            both(both(lanes, hn::Gt(weight, splat(kLeastWeight))),
                 in_picture(row, hn::Add(u, hn::Set(I(), right)), hn::Add(v, hn::Set(I(), below))));
        if (hn::AllFalse(F(), matter)) continue;
        taps.add(place, below * then.stride + right, matter, weight);
    }
    const Lanes none = hn::AndNot(hn::Gt(taps.total, splat(kLeastWeight)), lanes);
    if (!hn::AllFalse(F(), none)) look_around(taps, at_x, at_y, none);
    const Floats scale = choose(hn::Gt(taps.total, zero), hn::Div(one, taps.total), zero);
    const Floats trust = choose(hn::Gt(taps.total, splat(kLeastWeight)), one, splat(kOtherCount));
    return {scaled(taps.sum.light, scale), hn::Mul(hn::Mul(taps.sum.count, scale), trust)};
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GH_FILTER_TEMPORAL_PAST_INL_H_
