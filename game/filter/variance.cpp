#include "filter/variance.h"

#include "filter/rows.h"
#include "filter/variance_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/variance.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/geometry-inl.h"
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

constexpr float kEnough = 4.0f;  // samples to judge a pixel by its own
constexpr int kApart = 2;        // pixels between the neighbours asked
constexpr int kReach = 4;        // of them, in pixels: light that finds one pixel in 25 is still seen to be noise

// Of one sample, from the neighbours on the same surface.
static Floats variance_around(const VarianceRow& row, std::size_t x) {
    const Surface surface = surface_at(row.guides, x, 1.0f);
    Floats weight = splat(1.0f), mean = load(row.luminance + x), square = load(row.square + x);
    for (int dy = -kReach; dy <= kReach; dy += kApart) {
        if (row.y + dy < 0 || row.y + dy >= row.height) continue;
        const Floats base = below(surface, dy);
        for (int dx = -kReach; dx <= kReach; dx += kApart) {
            if (dx == 0 && dy == 0) continue;
            const std::ptrdiff_t column = static_cast<std::ptrdiff_t>(x) + dx;
            const std::ptrdiff_t at = column + dy * row.stride;
            const Floats w = zero_unless(inside(pixel_numbers(column), row.width),
                                         falloff(apart(surface, row.guides, at, beside(surface, base, dx))));
            weight = hn::Add(weight, w);
            mean = hn::Add(mean, hn::Mul(w, load(row.luminance + at)));
            square = hn::Add(square, hn::Mul(w, load(row.square + at)));
        }
    }
    mean = hn::Div(mean, weight);
    return positive(hn::Sub(hn::Div(square, weight), hn::Mul(mean, mean)));
}

static void variance_row(const VarianceRow& row) {
    const Floats one = splat(1.0f);
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        const Floats length = load(row.length + x), mean = load(row.luminance + x);
        const Floats own = positive(hn::Sub(load(row.square + x), hn::Mul(mean, mean)));
        Floats variance = hn::Div(own, hn::Sub(length, one));
        const Lanes too_few = hn::Lt(length, splat(kEnough));
        if (!hn::AllFalse(F(), too_few)) {
            const Floats samples = choose(hn::Gt(length, one), length, one);
            variance = choose(too_few, hn::Div(variance_around(row, x), samples), variance);
        }
        store(variance, row.variance + x);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(variance_row);

void estimate_variance(const Accumulated& signal, const Guides& guides, const Jobs& jobs, Plane& variance) {
    const int width = guides.width(), height = guides.height();
    EXPECTS(signal.light.width() == width && signal.light.height() == height);
    variance.fit(width, height);
    run_rows(height, jobs, [&](int y) {
        VarianceRow row{};
        row.guides = rows_of(guides, y);
        row.luminance = signal.light.y.row(y);
        row.square = signal.square.row(y);
        row.length = signal.length.row(y);
        row.width = width;
        row.height = height;
        row.y = y;
        row.stride = guides.nearness.stride();
        row.variance = variance.row(y);
        HWY_DYNAMIC_DISPATCH(variance_row)(row);
    });
}

}  // namespace gh::filter
#endif
