// The part of enlarge() for pictures of exactly twice the size, as the window mostly has them: columns then need no table
// of places, and two rows share what they blend.
#include "filter/enlarge_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/enlarge_double.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

struct Weights {
    Floats of[4];
};

static HWY_INLINE Weights weights_of(const float weight[4]) {
    return {{splat(weight[0]), splat(weight[1]), splat(weight[2]), splat(weight[3])}};
}

// Four values by their weights, within their range. None is NaN; there is one zero, as targets differ in which of two Min
// and Max return.
static HWY_INLINE Floats weighed(const Floats* value, const Weights& weights, Floats low, Floats high) {
    Floats sum = hn::Mul(value[0], weights.of[0]);
    for (std::size_t k = 1; k < 4; ++k) sum = hn::Add(sum, hn::Mul(value[k], weights.of[k]));
    return hn::Add(hn::Min(hn::Max(sum, low), high), hn::Zero(F()));
}

// Both rows of the picture between four small ones, at the small one's columns.
static void blend_down(const DoubleRows& rows) {
    const Weights upper = weights_of(rows.down[0]), lower = weights_of(rows.down[1]);
    const std::size_t padded = (static_cast<std::size_t>(rows.width) + 15) / 16 * 16;
    for (std::size_t x = 0; x < padded; x += lane_count()) {
        Floats value[4];
        for (std::size_t k = 0; k < 4; ++k) {
            const Floats v = load(rows.in[k] + x);
            value[k] = zero_unless(is_finite(v), v);
        }
        const Floats low = hn::Min(hn::Min(value[0], value[1]), hn::Min(value[2], value[3]));
        const Floats high = hn::Max(hn::Max(value[0], value[1]), hn::Max(value[2], value[3]));
        store(weighed(value, upper, low, high), rows.middle[0] + x);
        store(weighed(value, lower, low, high), rows.middle[1] + x);
    }
}

static void blend_across(const DoubleRows& rows, float* middle, float* out) {
    // The border repeats.
    const float last = middle[rows.width - 1];
    middle[-2] = middle[-1] = middle[0];
    middle[rows.width] = middle[rows.width + 1] = last;
    const Weights even = weights_of(rows.across[0]), odd = weights_of(rows.across[1]);
    const auto width = static_cast<std::size_t>(rows.width), padded = (2 * width + 15) / 16 * 16;
    for (std::size_t x = 0; x < width; x += lane_count()) {
        const float* const from = middle + x;
        const Floats value[5] = {load(from - 2), load(from - 1), load(from), load(from + 1), load(from + 2)};
        const Floats low = hn::Min(value[1], hn::Min(value[2], value[3]));
        const Floats high = hn::Max(value[1], hn::Max(value[2], value[3]));
        const Floats left = weighed(value, even, hn::Min(low, value[0]), hn::Max(high, value[0]));
        const Floats right = weighed(value + 1, odd, hn::Min(low, value[4]), hn::Max(high, value[4]));
        if (2 * (x + lane_count()) <= padded) {
            hn::StoreInterleaved2(left, right, F(), out + 2 * x);
            continue;
        }
        HWY_ALIGN float both[2 * HWY_MAX_BYTES / sizeof(float)];
        hn::StoreInterleaved2(left, right, F(), both);
        for (std::size_t i = 2 * x; i < padded; ++i) out[i] = both[i - 2 * x];
    }
}

static void double_rows_here(const DoubleRows& rows) {
    blend_down(rows);
    for (std::size_t i = 0; i < 2; ++i) {
        if (rows.out[i] != nullptr) blend_across(rows, rows.middle[i], rows.out[i]);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(double_rows_here);

void double_rows(const DoubleRows& rows) {
    HWY_DYNAMIC_DISPATCH(double_rows_here)(rows);
}

}  // namespace gh::filter
#endif
