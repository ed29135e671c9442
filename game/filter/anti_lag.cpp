#include "filter/anti_lag.h"

#include "filter/anti_lag_kernel.h"
#include "filter/rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/anti_lag.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"
#include "filter/taps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

static void change_row(const ChangeRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        const Floats now = load(row.now + x), then = load(row.then + x);
        const Floats most = choose(hn::Gt(now, then), now, then);
        const Floats share = hn::Div(hn::Abs(hn::Sub(now, then)), most);
        const Lanes known = hn::And(hn::Gt(most, hn::Zero(F())), is_finite(hn::Add(now, then)));
        store(zero_unless(hn::And(known, is_finite(share)),
                          choose(hn::Lt(share, splat(1.0f)), share, splat(1.0f))),
              row.change + x);
    }
}

static void column_sum_row(const ColumnSumRow& row) {
    for (auto x = static_cast<std::size_t>(row.begin); x < static_cast<std::size_t>(row.end);
         x += lane_count()) {
        Floats difference = hn::Zero(F()), variance = hn::Zero(F());
        for (std::size_t i = 0; i < 5; ++i) {
            const Floats mean = load(row.light[i] + x);
            difference = hn::Add(difference, hn::Sub(load(row.fast[i] + x), mean));
            variance = hn::Add(variance, positive(hn::Sub(load(row.square[i] + x), hn::Mul(mean, mean))));
        }
        store(difference, row.difference + x);
        store(variance, row.variance + x);
    }
}

// Over the five columns about each pixel; beyond the picture's sides its last column repeats.
static HWY_INLINE Floats five_columns(const float* sums, std::size_t x, int width) {
    const auto first = static_cast<std::ptrdiff_t>(x);
    const Floats middle = load(sums + x);
    Floats total = middle;
    const bool edge = x < 2 || x + lane_count() + 2 > static_cast<std::size_t>(width);
    for (std::ptrdiff_t dx = -2; dx <= 2; ++dx) {
        if (dx == 0) continue;
        Floats value = load(sums + first + dx);
        if (edge) value = choose(inside(pixel_numbers(first + dx), width), value, middle);
        total = hn::Add(total, value);
    }
    return total;
}

// The part of the difference between the fast means about here and the long ones that their noise does not explain.
static HWY_INLINE Floats significant_change(const SettleRow& row, std::size_t x) {
    const Floats change = hn::Mul(five_columns(row.difference, x, row.width), splat(1.0f / 25.0f));
    const Floats variance = hn::Mul(five_columns(row.variance, x, row.width), splat(row.noise_share));
    const Floats by_chance = hn::Mul(hn::Sqrt(variance), splat(row.sigmas));
    // Rounding of the sums is no change.
    const Floats slack = hn::Add(by_chance, hn::Mul(load(row.light[1] + x), splat(1e-3f)));
    return zero_unless(hn::Gt(hn::Abs(change), slack), hn::Sub(change, hn::CopySign(slack, change)));
}

static void settle_row(const SettleRow& row) {
    const Floats zero = hn::Zero(F()), one = splat(1.0f), least = splat(row.least_length);
    for (auto x = static_cast<std::size_t>(row.begin); x < static_cast<std::size_t>(row.end);
         x += lane_count()) {
        const Floats change = significant_change(row, x);
        const Floats old = load(row.light[1] + x), length = load(row.length + x);
        const Lanes moved = hn::And(hn::Gt(hn::Abs(change), zero), hn::Gt(length, least));
        if (hn::AllFalse(F(), moved)) continue;

        // What is darker now is so at once, in the same hue. What is brighter is waited for: its hue is not known.
        const Floats now = positive(hn::Add(old, change));
        const Lanes darker = hn::And(moved, hn::Lt(now, old));
        const Floats factor = choose(darker, hn::Div(now, old), one);
        for (float* plane : row.light) store(hn::Mul(load(plane + x), factor), plane + x);
        store(hn::Mul(load(row.square + x), hn::Mul(factor, factor)), row.square + x);
        // What of the mean was wrong is forgotten.
        const Floats kept = choose(darker, factor, choose(hn::Gt(now, zero), hn::Div(old, now), one));
        const Floats left = hn::Mul(length, hn::Mul(kept, kept));
        store(choose(moved, choose(hn::Gt(left, least), left, least), length), row.length + x);
    }
}

// Which of the four taps hardly matters, for gradients are smooth over many pixels: the weightiest.
static HWY_INLINE Floats carried(const CarryRow& row, std::size_t x) {
    const std::ptrdiff_t step[4] = {0, 1, row.then_stride, row.then_stride + 1};
    const Floats zero = hn::Zero(F());
    const Ints first = hn::LoadU(I(), row.first + x);
    const Lanes asks = hn::RebindMask(
        F(), hn::And(hn::Gt(first, hn::Set(I(), row.low - 1)), hn::Lt(first, hn::Set(I(), row.high))));
    if (hn::AllFalse(F(), asks)) return zero;
    Lanes known = hn::Gt(zero, zero);
    for (const float* weight : row.weight) known = hn::Or(known, hn::Gt(load(weight + x), zero));
    if (hn::AllFalse(F(), known)) return zero;
    const TapPlace place = place_of(first, known);
    Floats best = zero, chosen = zero;
    for (int tap = 0; tap < 4; ++tap) {
        const Floats weight = load(row.weight[tap] + x);
        const Lanes better = hn::Gt(weight, best);
        if (hn::AllFalse(F(), better)) continue;
        chosen = choose(better, read_tap(row.then, place, step[tap]), chosen);
        best = choose(better, weight, best);
    }
    return chosen;
}

static void carry_row(const CarryRow& row) {
    const Floats one = splat(1.0f);
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        const Floats change = hn::Mul(carried(row, x), splat(row.sharpness));
        store(choose(hn::Lt(change, one), change, one), row.change + x);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(change_row);
HWY_EXPORT(column_sum_row);
HWY_EXPORT(settle_row);
HWY_EXPORT(carry_row);

void lamp_change(const Plane& now, const Plane& then, const Jobs& jobs, Plane& change) {
    EXPECTS(now.width() == then.width() && now.height() == then.height());
    change.fit(now.width(), now.height());
    run_rows(now.height(), jobs, [&](int y) {
        const ChangeRow row{
            .now = now.row(y), .then = then.row(y), .width = now.width(), .change = change.row(y)};
        HWY_DYNAMIC_DISPATCH(change_row)(row);
    });
}

namespace {

// What is known about a block's light: by how much it changed, and how much there was at most.
struct Difference {
    float changed = 0.0f, most = 0.0f;
};

Difference difference_at(const Reshaded& samples, int x, int y) {
    const float then = samples.then.at(x, y), now = samples.now.at(x, y);
    const float most = std::max(then, now);
    if (!(most > 0.0f) || !std::isfinite(then) || !std::isfinite(now)) return {};
    return {now - then, most};
}

// Blocks about (x, y) that are told apart by nothing but their distance: gradients are few and noisy, and to forget too
// much beside an edge costs a little noise, to forget too little costs a ghost.
float smoothed_change(const Reshaded& samples, int x, int y) {
    float changed = 0.0f, most = 0.0f;
    for (int j = std::max(0, y - 2); j <= std::min(samples.then.height() - 1, y + 2); ++j) {
        for (int i = std::max(0, x - 2); i <= std::min(samples.then.width() - 1, x + 2); ++i) {
            const float weight = static_cast<float>((3 - std::abs(i - x)) * (3 - std::abs(j - y)));
            const Difference d = difference_at(samples, i, j);
            changed += weight * std::abs(d.changed);
            most += weight * d.most;
        }
    }
    return most > 0.0f ? std::min(1.0f, changed / most) : 0.0f;
}

}  // namespace

void gradients(const Reshaded& samples, int width, int height, const Jobs& jobs, Plane& change) {
    EXPECTS(samples.side >= 1);
    EXPECTS(samples.then.width() == samples.now.width() && samples.then.height() == samples.now.height());
    EXPECTS(samples.then.width() * samples.side >= width && samples.then.height() * samples.side >= height);
    change.fit(width, height);
    const int rows_of_blocks = (height + samples.side - 1) / samples.side;
    jobs.run(static_cast<std::size_t>(rows_of_blocks), [&](std::size_t block, int) {
        const int j = static_cast<int>(block);
        for (int i = 0; i * samples.side < width; ++i) {
            const float share = smoothed_change(samples, i, j);
            for (int y = j * samples.side; y < std::min(height, (j + 1) * samples.side); ++y) {
                float* row = change.row(y);
                for (int x = i * samples.side; x < std::min(width, (i + 1) * samples.side); ++x)
                    row[x] = share;
            }
        }
    });
}

void carry_change(const Plane& then, const Taps& taps, float sharpness, const Jobs& jobs, Plane& change) {
    run_rows(taps.first.height(), jobs, carry_rows(then, taps, sharpness, change));
}

namespace {

// Rows [begin, end) of which some light changed: mostly none.
std::pair<int, int> changed_rows(const Plane& then) {
    const auto is_still = [&then](int y) {
        return std::all_of(then.row(y), then.row(y) + then.width(), [](float v) { return v == 0.0f; });
    };
    int begin = 0, end = then.height();
    while (begin < end && is_still(begin)) ++begin;
    while (end > begin && is_still(end - 1)) --end;
    return {begin, end};
}

}  // namespace

RowWork carry_rows(const Plane& then, const Taps& taps, float sharpness, Plane& change) {
    const int width = taps.first.width(), height = taps.first.height();
    change.fit(width, height);
    const auto stride = static_cast<int>(then.stride());
    const auto [begin, end] = changed_rows(then);
    // From left of the row above the first to the end of the last.
    const int low = begin < end ? (begin - 1) * stride - 1 : 0, high = begin < end ? end * stride : 0;
    return [width, sharpness, low, high, &then, &taps, &change](int y) {
        CarryRow row{};
        row.then = then.row(0);
        row.then_stride = then.stride();
        row.low = low;
        row.high = high;
        row.first = taps.first.row(y);
        for (std::size_t tap = 0; tap < 4; ++tap) row.weight[tap] = taps.weight[tap].row(y);
        row.sharpness = sharpness;
        row.width = width;
        row.change = change.row(y);
        HWY_DYNAMIC_DISPATCH(carry_row)(row);
    };
}

void settle(const SettleSettings& settings, const Jobs& jobs, Accumulated& signal, Plane scratch[2]) {
    run_rows(signal.light.height(), jobs, settle_sum_rows(signal, scratch));
    run_rows(signal.light.height(), jobs, settle_rows(settings, scratch, signal));
}

namespace {

// The part of a row that settles: all of it, or where something moved by itself.
RowSpan settling_span(const Movement* only, int y, int width) {
    const RowSpan all{0, (width + RowSpan::kBlock - 1) / RowSpan::kBlock * RowSpan::kBlock};
    return only == nullptr ? all : only->itself[static_cast<std::size_t>(y)];
}

}  // namespace

RowWork settle_sum_rows(const Accumulated& signal, Plane scratch[2], const Movement* only) {
    const int width = signal.light.width(), height = signal.light.height();
    scratch[0].fit(width, height);
    scratch[1].fit(width, height);
    return [width, height, only, scratch, &signal](int y) {
        const RowSpan span = settling_span(only, y, width);
        if (span.begin == span.end) return;
        ColumnSumRow row{};
        row.begin =
            std::max(span.begin - RowSpan::kBlock, 0);  // columns beside those that settle are looked at
        row.end = std::min(span.end + RowSpan::kBlock, settling_span(nullptr, y, width).end);
        for (int i = 0; i < 5; ++i) {
            const int line = std::clamp(y + i - 2, 0, height - 1);
            row.fast[i] = signal.fast.row(line);
            row.light[i] = signal.light.y.row(line);
            row.square[i] = signal.square.row(line);
        }
        row.difference = scratch[0].row(y);
        row.variance = scratch[1].row(y);
        HWY_DYNAMIC_DISPATCH(column_sum_row)(row);
    };
}

RowWork settle_rows(const SettleSettings& settings, Plane scratch[2], Accumulated& signal,
                    const Movement* only) {
    EXPECTS(settings.sigmas > 0.0f && settings.fast_longest >= 1.0f);
    // An exponential mean of share a = 1/n keeps a / (2 - a) of the variance of its samples; 25 of them are compared.
    const float noise_share = 1.0f / ((2.0f * settings.fast_longest - 1.0f) * 25.0f * 25.0f);
    return [settings, noise_share, only, scratch, &signal](int y) {
        const RowSpan span = settling_span(only, y, signal.light.width());
        if (span.begin == span.end) return;
        SettleRow row{};
        row.begin = span.begin;
        row.end = span.end;
        row.difference = scratch[0].row(y);
        row.variance = scratch[1].row(y);
        row.width = signal.light.width();
        row.least_length = settings.fast_longest;
        row.noise_share = noise_share;
        row.sigmas = settings.sigmas;
        point_to(row.light, signal.light, y);
        row.square = signal.square.row(y);
        row.length = signal.length.row(y);
        HWY_DYNAMIC_DISPATCH(settle_row)(row);
    };
}

}  // namespace gh::filter
#endif
