// The part of the upscaler that adds its pictures up.
#include "filter/temporal_picture_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/temporal_picture.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"
#include "filter/taps-inl.h"
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

// The pictures before, at places of theirs, by a sharp filter: a mean is moved in every frame, and a bilinear one would
// blur it each time. The four corners of the sixteen are left out: together they weigh a sixty-fourth at most.
static HWY_INLINE Vector picture_at(const SmoothRow& row, Floats at_x, Floats at_y, Lanes lanes) {
    const Floats low_x = hn::Floor(at_x), low_y = hn::Floor(at_y);
    const Floats share_x = hn::Sub(at_x, low_x), share_y = hn::Sub(at_y, low_y), zero = hn::Zero(F());
    const Ints stride = hn::Set(I(), static_cast<std::int32_t>(row.then_stride));
    const Ints first = hn::Add(hn::Mul(hn::ConvertTo(I(), low_y), stride), hn::ConvertTo(I(), low_x));
    const TapPlace place = place_of(hn::IfThenElseZero(hn::RebindMask(I(), lanes), first), lanes);
    for (const float* plane : row.then) foresee_tap(plane, place, 3 * row.then_stride);
    const auto read = [&](std::ptrdiff_t step) {
        return Vector{read_tap(row.then[0], place, step), read_tap(row.then[1], place, step),
                      read_tap(row.then[2], place, step)};
    };
    if (hn::AllTrue(F(), hn::And(hn::Eq(share_x, zero), hn::Eq(share_y, zero)))) return read(0);
    const Cubic across = catmull_rom(share_x), down = catmull_rom(share_y);
    Vector sum{zero, zero, zero};
    for (std::ptrdiff_t v = 0; v < 4; ++v) {
        const bool is_outer = v == 0 || v == 3;
        Vector line{zero, zero, zero};
        for (std::ptrdiff_t u = is_outer ? 1 : 0; u < (is_outer ? 3 : 4); ++u)
            line = plus(line, scaled(read((v - 1) * row.then_stride + u - 1), across.weight[u]));
        sum = plus(sum, scaled(line, down.weight[v]));
    }
    const Floats corners =
        hn::Mul(hn::Add(across.weight[0], across.weight[3]), hn::Add(down.weight[0], down.weight[3]));
    return scaled(sum, hn::Div(splat(1.0f), hn::Sub(splat(1.0f), corners)));
}

// Behind something that walked on by itself: what was shown there is none of what is there. At edges of what stands still
// either side belongs to the mean.
static HWY_INLINE Lanes was_hidden(const SmoothRow& row, std::size_t x, Floats at_x, Floats at_y,
                                   Lanes seen) {
    const Floats half = splat(0.5f), zero = hn::Zero(F());
    const Ints column = hn::ConvertTo(I(), zero_unless(seen, hn::Floor(hn::Add(at_x, half))));
    const Ints line = hn::ConvertTo(I(), zero_unless(seen, hn::Floor(hn::Add(at_y, half))));
    const Ints stride = hn::Set(I(), static_cast<std::int32_t>(row.moved_stride));
    const TapPlace place = place_of(hn::Add(hn::Mul(line, stride), column), seen);
    const Lanes moved = hn::Gt(read_tap(row.moved_before, place, 0), zero);
    return hn::And(hn::And(seen, moved), hn::Eq(load(row.moves + x), zero));
}

static HWY_INLINE void smooth_vector(const SmoothRow& row, std::size_t x) {
    const auto i = static_cast<std::ptrdiff_t>(x);
    const Vector now = load3_at(row.lighted, i);
    const Floats by_x = load(row.motion[0] + x), by_y = load(row.motion[1] + x), zero = hn::Zero(F());
    const Floats at_x = hn::Add(hn::ConvertTo(F(), pixel_numbers(i)), by_x);
    const Floats at_y = hn::Add(splat(static_cast<float>(row.y)), by_y);
    const Lanes seen =
        hn::And(hn::And(inside(pixel_numbers(i), row.width), hn::And(hn::Ge(at_x, zero), hn::Ge(at_y, zero))),
                hn::And(hn::Le(at_x, splat(static_cast<float>(row.then_width - 1))),
                        hn::Le(at_y, splat(static_cast<float>(row.then_height - 1)))));
    Vector mean = now;
    if (row.has_past && !hn::AllFalse(F(), seen)) {
        Vector low = now, high = now;
        for (const std::ptrdiff_t down : {row.above, std::ptrdiff_t{0}, row.below}) {
            for (std::ptrdiff_t right = -1; right <= 1; ++right) {
                const Vector around = load3_at(row.lighted, i + down + right);
                low = least(low, around);
                high = greatest(high, around);
            }
        }
        const Vector before = clamped(picture_at(row, at_x, at_y, seen), low, high);
        const Floats by = hn::Sqrt(hn::Add(hn::Mul(by_x, by_x), hn::Mul(by_y, by_y)));
        const Floats moved = hn::Min(splat(1.0f), hn::Add(by, by));
        const Floats pictures = hn::Add(splat(row.still), hn::Mul(splat(row.moving - row.still), moved));
        Floats share = hn::Div(splat(1.0f), pictures);
        if (row.change != nullptr) share = hn::Max(share, load(row.change + x));
        if (row.moved_before != nullptr)
            share = choose(was_hidden(row, x, at_x, at_y, seen), splat(1.0f), share);
        const Vector mixed = plus(before, scaled(minus(now, before), share));
        mean = choose(seen, mixed, now);
    }
    store3(mean, row.next, x);
    if (row.out_planes[0] != nullptr) store3(mean, row.out_planes, x);
    if (row.out != nullptr) store3(mean, row.out, x, static_cast<std::size_t>(row.width));
}

static void smooth(const SmoothRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) smooth_vector(row, x);
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(smooth);

void smooth_picture(const SmoothRow& row) {
    HWY_DYNAMIC_DISPATCH(smooth)(row);
}

}  // namespace gh::filter
#endif
