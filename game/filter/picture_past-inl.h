// filter/picture_past-inl.h - what the mean of pictures before holds, and what of it is nobody's past. Compiled once per
// instruction set; see simd-inl.h.
#if defined(GH_FILTER_PICTURE_PAST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GH_FILTER_PICTURE_PAST_INL_H_
#undef GH_FILTER_PICTURE_PAST_INL_H_
#else
#define GH_FILTER_PICTURE_PAST_INL_H_
#endif

#include "filter/simd-inl.h"
#include "filter/taps-inl.h"
#include "filter/temporal_picture_kernel.h"
#include "filter/vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

struct Cubic {
    Floats weight[4];
};

// Of the four numbers around a place `t` after the second (Catmull and Rom 1974).
static HWY_INLINE Cubic catmull_rom(Floats t) {
    const Floats half = splat(0.5f), t2 = hn::Mul(t, t), t3 = hn::Mul(t2, t);
    const auto times = [](float factor, Floats v) { return hn::Mul(splat(factor), v); };
    return {{hn::Mul(half, hn::Sub(hn::Sub(times(2.0f, t2), t3), t)),
             hn::Mul(half, hn::Add(hn::Sub(times(3.0f, t3), times(5.0f, t2)), splat(2.0f))),
             hn::Mul(half, hn::Add(hn::Sub(times(4.0f, t2), times(3.0f, t3)), t)),
             hn::Mul(half, hn::Sub(t3, t2))}};
}

// By a sharp filter: a mean is moved in every frame, and a bilinear one would blur it each time. The four corners of the
// sixteen are left out: together they weigh a sixty-fourth at most.
template <class Place>
static HWY_INLINE Vector cubic_at(const PicturePast& past, const Place& place, Floats share_x,
                                  Floats share_y) {
    const Floats zero = hn::Zero(F());
    const auto read = [&](std::ptrdiff_t step) {
        return Vector{read_tap(past.picture[0], place, step), read_tap(past.picture[1], place, step),
                      read_tap(past.picture[2], place, step)};
    };
    if (hn::AllTrue(F(), hn::And(hn::Eq(share_x, zero), hn::Eq(share_y, zero)))) return read(0);
    const Cubic across = catmull_rom(share_x), down = catmull_rom(share_y);
    Vector sum{zero, zero, zero};
    for (std::ptrdiff_t v = 0; v < 4; ++v) {
        const bool is_outer = v == 0 || v == 3;
        Vector line{zero, zero, zero};
        for (std::ptrdiff_t u = is_outer ? 1 : 0; u < (is_outer ? 3 : 4); ++u)
            line = plus(line, scaled(read((v - 1) * past.stride + u - 1), across.weight[u]));
        sum = plus(sum, scaled(line, down.weight[v]));
    }
    const Floats corners =
        hn::Mul(hn::Add(across.weight[0], across.weight[3]), hn::Add(down.weight[0], down.weight[3]));
    return scaled(sum, hn::Div(splat(1.0f), hn::Sub(splat(1.0f), corners)));
}

// The pictures before, at places of theirs.
static HWY_INLINE Vector picture_at(const PicturePast& past, Floats at_x, Floats at_y, Lanes lanes) {
    const Floats low_x = hn::Floor(at_x), low_y = hn::Floor(at_y);
    const Floats share_x = hn::Sub(at_x, low_x), share_y = hn::Sub(at_y, low_y);
    const Ints stride = hn::Set(I(), static_cast<std::int32_t>(past.stride));
    const Ints first = hn::Add(hn::Mul(hn::ConvertTo(I(), low_y), stride), hn::ConvertTo(I(), low_x));
    const TapPlace place = place_of(hn::IfThenElseZero(hn::RebindMask(I(), lanes), first), lanes);
    for (const float* plane : past.picture) foresee_tap(plane, place, 3 * past.stride);
    return place.runs == 1 ? cubic_at(past, RunPlace{place.start[0]}, share_x, share_y)
                           : cubic_at(past, place, share_x, share_y);
}

// Behind something that walked on by itself: what was shown there is none of what is there. At edges of what stands still
// either side belongs to the mean.
static HWY_INLINE Lanes was_hidden(const PicturePast& past, Floats moves, Floats at_x, Floats at_y,
                                   Lanes seen) {
    const Floats half = splat(0.5f), zero = hn::Zero(F());
    const Floats low_y = hn::Floor(hn::Add(at_y, half));
    seen = hn::And(seen, hn::And(hn::Ge(low_y, splat(static_cast<float>(past.moved_begin))),
                                 hn::Lt(low_y, splat(static_cast<float>(past.moved_end)))));
    if (hn::AllFalse(F(), seen)) return seen;
    const Ints column = hn::ConvertTo(I(), zero_unless(seen, hn::Floor(hn::Add(at_x, half))));
    const Ints line = hn::ConvertTo(I(), zero_unless(seen, low_y));
    const Ints stride = hn::Set(I(), static_cast<std::int32_t>(past.moved_stride));
    const TapPlace place = place_of(hn::Add(hn::Mul(line, stride), column), seen);
    const Lanes moved = hn::Gt(read_tap(past.moved, place, 0), zero);
    return hn::And(hn::And(seen, moved), hn::Eq(moves, zero));
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GH_FILTER_PICTURE_PAST_INL_H_
