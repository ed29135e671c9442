#include "filter/temporal.h"

#include "filter/rows.h"
#include "filter/temporal_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/temporal.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

constexpr std::size_t kChunk = 64;

// What reprojection brought of the last frames, pixel by pixel.
struct Brought {
    HWY_ALIGN float light[4 * kChunk];
    HWY_ALIGN float pace[4 * kChunk];
};

// Four texels blended, each number of a texel for itself: one pixel is one vector of four whatever the machine's width.
static HWY_INLINE void blend_taps(const AccumulateRow& row, std::size_t x, const float* texels, float* to) {
    const hn::CappedTag<float, 4> four;
    const float* first = texels + 4 * static_cast<std::ptrdiff_t>(row.first[x]);
    const float* below = first + 4 * static_cast<std::ptrdiff_t>(row.then_stride);
    const float w[4] = {row.weight[0][x], row.weight[1][x], row.weight[2][x], row.weight[3][x]};
    for (std::size_t i = 0; i < 4; i += hn::Lanes(four)) {
        // A tap that does not count may hold anything, NaN too.
        const auto part = [&](const float* texel, float weight) {
            const auto share = hn::Set(four, weight);
            return hn::IfThenElseZero(hn::Gt(share, hn::Zero(four)), hn::Mul(hn::LoadU(four, texel + i), share));
        };
        const auto upper = hn::Add(part(first, w[0]), part(first + 4, w[1]));
        const auto lower = hn::Add(part(below, w[2]), part(below + 4, w[3]));
        hn::Store(hn::Add(upper, lower), four, to + i);
    }
}

static void bring(const AccumulateRow& row, std::size_t begin, std::size_t count, Brought& out) {
    for (std::size_t i = 0; i < count; ++i) {
        blend_taps(row, begin + i, row.then_light, out.light + 4 * i);
        blend_taps(row, begin + i, row.then_pace, out.pace + 4 * i);
    }
}

static HWY_INLINE Floats toward(Floats from, Floats to, Floats share) {
    return hn::Add(from, hn::Mul(hn::Sub(to, from), share));
}

static HWY_INLINE Floats at_least(Floats a, Floats b) { return choose(hn::Gt(a, b), a, b); }
static HWY_INLINE Floats at_most(Floats a, Floats b) { return choose(hn::Lt(a, b), a, b); }

// Share of the new sample in a mean of at most `longest`, of which `change` is to be forgotten.
static HWY_INLINE Floats new_share(Floats length, Floats change, float longest) {
    const Floats one = splat(1.0f);
    const Floats usual = hn::Div(one, at_most(hn::Add(length, one), splat(longest)));
    return toward(usual, one, change);
}

static void add_sample(const AccumulateRow& row, std::size_t x, const Brought& brought, std::size_t i) {
    const Floats zero = hn::Zero(F()), one = splat(1.0f);
    Floats r, g, b, square, length, fast, unused_a, unused_b;
    hn::LoadInterleaved4(F(), brought.light + 4 * i, r, g, b, square);
    hn::LoadInterleaved4(F(), brought.pace + 4 * i, length, fast, unused_a, unused_b);

    Floats new_r = load(row.sample[0] + x), new_g = load(row.sample[1] + x), new_b = load(row.sample[2] + x);
    const Lanes good = hn::And(is_finite(new_r), hn::And(is_finite(new_g), is_finite(new_b)));
    new_r = choose(good, new_r, r);
    new_g = choose(good, new_g, g);
    new_b = choose(good, new_b, b);
    const Floats light = luminance(new_r, new_g, new_b);

    const Floats change = row.change != nullptr ? at_most(positive(load(row.change + x)), one) : zero;
    const Floats share = zero_unless(good, new_share(length, change, row.longest));
    const Floats fast_share = zero_unless(good, new_share(length, change, row.fast_longest));
    r = toward(r, new_r, share);
    g = toward(g, new_g, share);
    b = toward(b, new_b, share);
    store(r, row.light[0] + x);
    store(g, row.light[1] + x);
    store(b, row.light[2] + x);
    store(luminance(r, g, b), row.luminance + x);
    store(toward(square, hn::Mul(light, light), share), row.square + x);
    store(choose(good, hn::Div(one, share), length), row.length + x);
    store(toward(fast, light, fast_share), row.fast + x);
}

static void accumulate_row(const AccumulateRow& row) {
    const std::size_t padded = (static_cast<std::size_t>(row.width) + 15) / 16 * 16;
    Brought brought = {};
    for (std::size_t x = 0; x < padded; x += kChunk) {
        const std::size_t count = padded - x < kChunk ? padded - x : kChunk;
        if (row.then_light != nullptr) bring(row, x, count, brought);
        for (std::size_t i = 0; i < count; i += lane_count()) add_sample(row, x + i, brought, i);
    }
}

static void pack_row(const PackRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        hn::StoreInterleaved4(load(row.light[0] + x), load(row.light[1] + x), load(row.light[2] + x),
                              load(row.square + x), F(), row.to_light + 4 * x);
        const Floats zero = hn::Zero(F());
        hn::StoreInterleaved4(load(row.length + x), load(row.fast + x), zero, zero, F(), row.to_pace + 4 * x);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(accumulate_row);
HWY_EXPORT(pack_row);

void Accumulated::fit(int width, int height) {
    light.fit(width, height);
    for (Plane* plane : {&luminance, &square, &length, &fast}) plane->fit(width, height);
}

void accumulate(const Plane3& samples, const Plane& change, const Taps& taps, const History& before,
                const TemporalSettings& settings, const Jobs& jobs, Accumulated& out) {
    EXPECTS(settings.longest >= 1.0f && settings.fast_longest >= 1.0f);
    EXPECTS(taps.first.width() == samples.width() && taps.first.height() == samples.height());
    const int width = samples.width(), height = samples.height();
    out.fit(width, height);
    const bool has_past = before.light.width() > 0 && before.light.height() > 0;
    run_rows(height, jobs, [&](int y) {
        AccumulateRow row{};
        point_to(row.sample, samples, y);
        row.change = change.empty() ? nullptr : change.row(y);
        row.first = taps.first.row(y);
        for (std::size_t tap = 0; tap < 4; ++tap) row.weight[tap] = taps.weight[tap].row(y);
        row.then_light = has_past ? before.light.row(0)->value : nullptr;
        row.then_pace = has_past ? before.pace.row(0)->value : nullptr;
        row.then_stride = before.light.stride();
        row.width = width;
        row.longest = settings.longest;
        row.fast_longest = settings.fast_longest;
        point_to(row.light, out.light, y);
        row.luminance = out.luminance.row(y);
        row.square = out.square.row(y);
        row.length = out.length.row(y);
        row.fast = out.fast.row(y);
        HWY_DYNAMIC_DISPATCH(accumulate_row)(row);
    });
}

void remember(const Accumulated& signal, const Jobs& jobs, History& history) {
    const int width = signal.light.width(), height = signal.light.height();
    history.light.resize(width, height);
    history.pace.resize(width, height);
    run_rows(height, jobs, [&](int y) {
        PackRow row{};
        point_to(row.light, signal.light, y);
        row.square = signal.square.row(y);
        row.length = signal.length.row(y);
        row.fast = signal.fast.row(y);
        row.width = width;
        row.to_light = history.light.row(y)->value;
        row.to_pace = history.pace.row(y)->value;
        HWY_DYNAMIC_DISPATCH(pack_row)(row);
    });
}

}  // namespace gh::filter
#endif
