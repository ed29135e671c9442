// The part of the upscaler that adds its pictures up.
#include "filter/temporal_picture_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/temporal_picture.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/picture_past-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

static HWY_INLINE void smooth_vector(const SmoothRow& row, std::size_t x) {
    const auto i = static_cast<std::ptrdiff_t>(x);
    const Vector now = load3_at(row.lighted, i);
    const Floats by_x = load(row.motion[0] + x), by_y = load(row.motion[1] + x), zero = hn::Zero(F());
    const Floats at_x = hn::Add(hn::ConvertTo(F(), pixel_numbers(i)), by_x);
    const Floats at_y = hn::Add(splat(static_cast<float>(row.y)), by_y);
    const Lanes seen =
        hn::And(hn::And(inside(pixel_numbers(i), row.width), hn::And(hn::Ge(at_x, zero), hn::Ge(at_y, zero))),
                hn::And(hn::Le(at_x, splat(static_cast<float>(row.past.width - 1))),
                        hn::Le(at_y, splat(static_cast<float>(row.past.height - 1)))));
    Vector mean = now;
    if (row.past.is_there && !hn::AllFalse(F(), seen)) {
        Vector low = now, high = now;
        for (const std::ptrdiff_t down : {row.above, std::ptrdiff_t{0}, row.below}) {
            for (std::ptrdiff_t right = -1; right <= 1; ++right) {
                const Vector around = load3_at(row.lighted, i + down + right);
                low = least(low, around);
                high = greatest(high, around);
            }
        }
        const Vector before = clamped(picture_at(row.past, at_x, at_y, seen), low, high);
        const Floats by = hn::Sqrt(hn::Add(hn::Mul(by_x, by_x), hn::Mul(by_y, by_y)));
        const Floats moved = hn::Min(splat(1.0f), hn::Add(by, by));
        const Floats pictures = hn::Add(splat(row.pictures.still), hn::Mul(splat(row.pictures.moving - row.pictures.still), moved));
        Floats share = hn::Div(splat(1.0f), pictures);
        if (row.change != nullptr) share = hn::Max(share, load(row.change + x));
        if (row.past.moved != nullptr)
            share = choose(was_hidden(row.past, load(row.moves + x), at_x, at_y, seen), splat(1.0f), share);
        const Vector mixed = plus(before, scaled(minus(now, before), share));
        mean = choose(seen, mixed, now);
    }
    store3_far(mean, row.next, x);
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
