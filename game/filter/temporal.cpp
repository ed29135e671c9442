#include "filter/temporal.h"

#include "filter/rows.h"
#include "filter/temporal_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/temporal.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"
#include "filter/taps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

// What reprojection brings of the last frames.
struct Brought {
    Floats r, y, b, square, length, fast;
};

struct Blend {
    std::ptrdiff_t stride;
    Floats weight[4];
    Lanes counts[4];
    bool is_used[4];
};

// A tap without weight is not read, be it one of a pixel or one of all: in a picture that stands still one in four has any.
template <class Place>
static HWY_INLINE Floats blend_taps(const Blend& blend, const Place& place, const float* plane) {
    const std::ptrdiff_t step[4] = {0, 1, blend.stride, blend.stride + 1};
    Floats sum = hn::Zero(F());
    for (int tap = 0; tap < 4; ++tap) {
        if (!blend.is_used[tap]) continue;
        const Floats value = read_tap(plane, place, step[tap]);
        sum = hn::Add(sum, zero_unless(blend.counts[tap], hn::Mul(value, blend.weight[tap])));
    }
    return sum;
}

template <class Place>
static HWY_INLINE Brought blend_all(const AccumulateRow& row, const Blend& blend, const Place& place) {
    return {blend_taps(blend, place, row.then_light[0]), blend_taps(blend, place, row.then_light[1]),
            blend_taps(blend, place, row.then_light[2]), blend_taps(blend, place, row.then_square),
            blend_taps(blend, place, row.then_length),   blend_taps(blend, place, row.then_fast)};
}

static HWY_INLINE Brought bring(const AccumulateRow& row, std::size_t x) {
    const Floats zero = hn::Zero(F());
    Blend blend;
    Lanes known = hn::Gt(zero, zero);
    for (int tap = 0; tap < 4; ++tap) {
        blend.weight[tap] = load(row.weight[tap] + x);
        blend.counts[tap] = hn::Gt(blend.weight[tap], zero);
        blend.is_used[tap] = !hn::AllFalse(F(), blend.counts[tap]);
        known = hn::Or(known, blend.counts[tap]);
    }
    if (!row.has_past || hn::AllFalse(F(), known)) return {zero, zero, zero, zero, zero, zero};
    const TapPlace place = place_of(hn::LoadU(I(), row.first + x), known);
    blend.stride = row.then_stride;
    for (const float* plane : {row.then_light[0], row.then_light[1], row.then_light[2], row.then_square,
                               row.then_length, row.then_fast})
        foresee_tap(plane, place, 2 * blend.stride);
    return place.runs == 1 ? blend_all(row, blend, RunPlace{place.start[0]}) : blend_all(row, blend, place);
}

static HWY_INLINE Floats toward(Floats from, Floats to, Floats share) {
    return hn::Add(from, hn::Mul(hn::Sub(to, from), share));
}

static HWY_INLINE Floats at_most(Floats a, Floats b) {
    return choose(hn::Lt(a, b), a, b);
}

// Share of the new sample in a mean of at most `longest`, of which `change` is to be forgotten.
static HWY_INLINE Floats new_share(Floats length, Floats change, float longest) {
    const Floats one = splat(1.0f);
    const Floats usual = hn::Div(one, at_most(hn::Add(length, one), splat(longest)));
    return toward(usual, one, change);
}

static HWY_INLINE void add_sample(const AccumulateRow& row, std::size_t x) {
    const Floats zero = hn::Zero(F()), one = splat(1.0f);
    const Brought past = bring(row, x);
    Floats r = load(row.sample[0] + x), b = load(row.sample[2] + x);
    Floats y = luminance(r, load(row.sample[1] + x), b);
    const Lanes good = is_finite(y);  // any NaN or infinity among the three would show
    r = choose(good, r, past.r);
    y = choose(good, y, past.y);
    b = choose(good, b, past.b);

    const Floats change = row.change != nullptr ? at_most(positive(load(row.change + x)), one) : zero;
    const Floats share = zero_unless(good, new_share(past.length, change, row.longest));
    const Floats fast_share = zero_unless(good, new_share(past.length, change, row.fast_longest));
    store_far(toward(past.r, r, share), row.light[0] + x);
    store_far(toward(past.y, y, share), row.light[1] + x);
    store_far(toward(past.b, b, share), row.light[2] + x);
    store_far(toward(past.square, hn::Mul(y, y), share), row.square + x);
    store_far(choose(good, hn::Div(one, share), past.length), row.length + x);
    store_far(toward(past.fast, y, fast_share), row.fast + x);
}

static void accumulate_row(const AccumulateRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) add_sample(row, x);
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(accumulate_row);

void Accumulated::fit(int width, int height) {
    fit_together(width, height, light, square, length, fast);
}

void accumulate(const Plane3& samples, const Plane& change, const Past& past,
                const TemporalSettings& settings, const Jobs& jobs, Accumulated& out) {
    run_rows(samples.height(), jobs, accumulate_rows(samples, change, past, settings, out));
}

RowWork accumulate_rows(const Plane3& samples, const Plane& change, const Past& past,
                        const TemporalSettings& settings, Accumulated& out) {
    const Taps& taps = past.taps;
    const Accumulated& before = past.before;
    EXPECTS(settings.longest >= 1.0f && settings.fast_longest >= 1.0f);
    EXPECTS(taps.first.width() == samples.width() && taps.first.height() == samples.height());
    EXPECTS(&before != &out);
    const int width = samples.width(), height = samples.height();
    out.fit(width, height);
    AccumulateRow shared{};
    shared.width = width;
    shared.longest = settings.longest;
    shared.fast_longest = settings.fast_longest;
    shared.has_past = !before.light.empty();
    if (shared.has_past) {
        point_to(shared.then_light, before.light, 0);
        shared.then_square = before.square.row(0);
        shared.then_length = before.length.row(0);
        shared.then_fast = before.fast.row(0);
        shared.then_stride = before.length.stride();
    }
    return [shared, &samples, &change, &taps, &out](int y) {
        AccumulateRow row = shared;
        point_to(row.sample, samples, y);
        row.change = change.empty() ? nullptr : change.row(y);
        row.first = taps.first.row(y);
        for (std::size_t tap = 0; tap < 4; ++tap) row.weight[tap] = taps.weight[tap].row(y);
        point_to(row.light, out.light, y);
        row.square = out.square.row(y);
        row.length = out.length.row(y);
        row.fast = out.fast.row(y);
        HWY_DYNAMIC_DISPATCH(accumulate_row)(row);
    };
}

}  // namespace gh::filter
#endif
