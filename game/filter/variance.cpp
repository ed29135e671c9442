#include "filter/variance.h"

#include "filter/rows.h"
#include "filter/variance_kernel.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/variance.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

constexpr float kEnough = 4.0f;         // samples to judge a pixel by its own
constexpr int kApart = 2;               // pixels between the neighbours asked
constexpr int kReach = kVarianceReach;  // pixels: light that finds one in 25 is still seen to be noise
// What few samples say is taken for more than it is: light that finds one pixel in 25 may have missed all of these, and
// what is smoothed too widely now is made up for by the next frames.
constexpr float kDoubt = 2.0f;
constexpr std::size_t kBlock = 256, kSide = 16;  // pixels worked on together; those beside them

// Of columns of five pixels, `kSide` to the left of a block to as many to its right.
struct ColumnSums {
    alignas(64) float luminance[kBlock + 2 * kSide];
    alignas(64) float square[kBlock + 2 * kSide];
};

static int first_line(const VarianceRow& row) {
    return -std::min(row.y, kReach) / kApart * kApart;
}
static int last_line(const VarianceRow& row) {
    return std::min(row.height - 1 - row.y, kReach) / kApart * kApart;
}

static void add_columns(const VarianceRow& row, std::ptrdiff_t block, ColumnSums& sums) {
    for (std::size_t i = 0; i < kBlock + 2 * kSide; i += lane_count()) {
        const std::ptrdiff_t x = block + static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(kSide);
        if (x >= row.width + kReach) return;
        Floats mean = hn::Zero(F()), square = hn::Zero(F());
        for (int dy = first_line(row); dy <= last_line(row); dy += kApart) {
            mean = hn::Add(mean, load(row.luminance + x + dy * row.stride));
            square = hn::Add(square, load(row.square + x + dy * row.stride));
        }
        const Lanes in = inside(pixel_numbers(x), row.width);
        store(zero_unless(in, mean), sums.luminance + i);
        store(zero_unless(in, square), sums.square + i);
    }
}

// Of one sample, from the 25 pixels around, whatever they show: where that differs the light does, and at edges of things
// the filters look at what is there, not at its light.
static Floats variance_around(const VarianceRow& row, const ColumnSums& sums, std::size_t x) {
    const std::size_t i = x % kBlock + kSide;
    Floats columns = hn::Zero(F()), mean = hn::Zero(F()), square = hn::Zero(F());
    for (int dx = -kReach; dx <= kReach; dx += kApart) {
        const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(x) + dx;
        columns = hn::Add(columns, zero_unless(inside(pixel_numbers(at), row.width), splat(1.0f)));
        mean = hn::Add(mean, load(sums.luminance + i + dx));
        square = hn::Add(square, load(sums.square + i + dx));
    }
    const auto line_count = (last_line(row) - first_line(row)) / kApart + 1;
    const auto lines = static_cast<float>(line_count);
    const Floats share = hn::Div(splat(1.0f), hn::Mul(columns, splat(lines)));
    mean = hn::Mul(mean, share);
    const Floats variance = positive(hn::Sub(hn::Mul(square, share), hn::Mul(mean, mean)));
    return hn::Mul(variance, splat(kDoubt));
}

static void variance_row(const VarianceRow& row) {
    const Floats one = splat(1.0f);
    ColumnSums sums;
    std::ptrdiff_t summed = -1;  // the block whose sums are known
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        const Floats length = load(row.length + x), mean = load(row.luminance + x);
        const Floats own = positive(hn::Sub(load(row.square + x), hn::Mul(mean, mean)));
        Floats variance = hn::Div(own, hn::Sub(length, one));
        const Lanes too_few = hn::Lt(length, splat(kEnough));
        if (!hn::AllFalse(F(), too_few)) {
            const auto block = static_cast<std::ptrdiff_t>(x / kBlock * kBlock);
            if (summed != block) add_columns(row, block, sums);
            summed = block;
            const Floats samples = choose(hn::Gt(length, one), length, one);
            variance = choose(too_few, hn::Div(variance_around(row, sums, x), samples), variance);
        }
        store_far(variance, row.variance + x);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(variance_row);

void estimate_variance(const Accumulated& signal, const Jobs& jobs, Plane& variance) {
    run_rows(signal.light.height(), jobs, variance_rows(signal, variance));
}

RowWork variance_rows(const Accumulated& signal, Plane& variance) {
    const int width = signal.light.width(), height = signal.light.height();
    variance.fit(width, height);
    return [width, height, &signal, &variance](int y) {
        VarianceRow row{};
        row.luminance = signal.light.y.row(y);
        row.square = signal.square.row(y);
        row.length = signal.length.row(y);
        row.width = width;
        row.height = height;
        row.y = y;
        row.stride = signal.square.stride();
        row.variance = variance.row(y);
        HWY_DYNAMIC_DISPATCH(variance_row)(row);
    };
}

}  // namespace gh::filter
#endif
