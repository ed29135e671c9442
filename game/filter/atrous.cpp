#include "filter/atrous.h"

#include "filter/atrous_kernel.h"
#include "filter/rows.h"

#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/atrous.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/geometry-inl.h"
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

// The part of the tolerated difference that does not come from noise, as a share of the light: rounding, not signal.
constexpr float kLeastDifference = 1e-3f;

// Weights of the cubic B-spline relative to its middle; for 3x3 those of the linear one.
constexpr float kSpline[2][5] = {{0.5f, 1.0f, 0.5f, 0.0f, 0.0f},
                                 {1.0f / 6.0f, 2.0f / 3.0f, 1.0f, 2.0f / 3.0f, 1.0f / 6.0f}};

// A pixel on its way: what a neighbour is measured by, and what has come together.
struct Gathering {
    Floats middle, scale;  // luminance; quarter of the reciprocal of what it may differ by
    Floats stiff;          // added for any neighbour
    Floats r, g, b, variance, weight;
};

// Variance averaged over 3x3 pixels with (1 2 1)/4 either way (Schied et al., section 4.4): a lone pixel's own estimate
// is too uncertain, and a dark pixel among bright ones would let nobody in.
template <bool kEdge>
static HWY_INLINE Floats smooth_variance(const AtrousRow& row, const float* variance, std::size_t x) {
    const Lanes all = hn::Eq(hn::Zero(F()), hn::Zero(F()));
    const auto first = static_cast<std::ptrdiff_t>(x);
    const Lanes left_in = kEdge ? inside(pixel_numbers(first - 1), row.width) : all;
    const Lanes right_in = kEdge ? inside(pixel_numbers(first + 1), row.width) : all;
    const auto line = [&](int dy) {
        const bool is_in = 0 <= row.y + dy && row.y + dy < row.height;
        const float* from = variance + first + (is_in ? dy : 0) * row.stride;
        const Floats middle = positive(load(from));
        Floats left = positive(load(from - 1)), right = positive(load(from + 1));
        if (kEdge) {
            left = choose(left_in, left, middle);
            right = choose(right_in, right, middle);
        }
        return hn::Add(hn::Add(left, right), hn::Add(middle, middle));
    };
    const Floats middle = line(0);
    return hn::Mul(hn::Add(hn::Add(line(-1), line(1)), hn::Add(middle, middle)), splat(1.0f / 16.0f));
}

template <bool kEdge>
static HWY_INLINE Gathering begin(const AtrousRow& row, const AtrousSignal& signal, std::size_t x) {
    Gathering to;
    const Floats zero = hn::Zero(F()), one = splat(1.0f);
    const Floats middle = load(signal.luminance + x);
    const Lanes good = is_finite(middle);
    const Floats deviation = hn::Sqrt(smooth_variance<kEdge>(row, signal.variance, x));
    const Floats may_differ = hn::Add(hn::Mul(deviation, splat(row.luminance_sigmas)),
                                      hn::Add(hn::Mul(hn::Abs(middle), splat(kLeastDifference)), splat(1e-20f)));
    // A pixel without light of its own takes any.
    to.middle = zero_unless(good, middle);
    to.scale = zero_unless(good, hn::Div(splat(0.25f), may_differ));
    to.stiff = signal.stiffness != nullptr
                   ? hn::Mul(load(signal.stiffness + x), splat(static_cast<float>(row.step)))
                   : zero;
    to.r = zero_unless(good, load(signal.light[0] + x));
    to.g = zero_unless(good, load(signal.light[1] + x));
    to.b = zero_unless(good, load(signal.light[2] + x));
    to.variance = zero_unless(good, positive(load(signal.variance + x)));
    to.weight = zero_unless(good, one);
    return to;
}

static HWY_INLINE void add_neighbour(const AtrousSignal& signal, std::ptrdiff_t at, Floats geometry, Floats spline,
                                     Gathering& to) {
    const Floats off = hn::Mul(hn::Abs(hn::Sub(load(signal.luminance + at), to.middle)), to.scale);
    const Floats weight = hn::Mul(falloff(hn::Add(hn::Add(geometry, to.stiff), off)), spline);
    const Lanes counts = hn::Gt(weight, hn::Zero(F()));  // one that does not may hold an infinity
    to.r = hn::Add(to.r, zero_unless(counts, hn::Mul(weight, load(signal.light[0] + at))));
    to.g = hn::Add(to.g, zero_unless(counts, hn::Mul(weight, load(signal.light[1] + at))));
    to.b = hn::Add(to.b, zero_unless(counts, hn::Mul(weight, load(signal.light[2] + at))));
    const Floats variance = positive(load(signal.variance + at));
    to.variance = hn::Add(to.variance, hn::Mul(hn::Mul(weight, weight), variance));
    to.weight = hn::Add(to.weight, weight);
}

static HWY_INLINE void finish(const Gathering& from, const AtrousSignal& signal, std::size_t x) {
    const Floats share = zero_unless(hn::Gt(from.weight, hn::Zero(F())), hn::Div(splat(1.0f), from.weight));
    const Floats r = hn::Mul(from.r, share), g = hn::Mul(from.g, share), b = hn::Mul(from.b, share);
    store(r, signal.out_light[0] + x);
    store(g, signal.out_light[1] + x);
    store(b, signal.out_light[2] + x);
    store(luminance(r, g, b), signal.out_luminance + x);
    store(hn::Mul(from.variance, hn::Mul(share, share)), signal.out_variance + x);
}

template <std::size_t kSignals, int kRadius, bool kEdge>
static HWY_INLINE void smooth_pixels(const AtrousRow& row, std::size_t x) {
    const Surface surface = surface_at(row.guides, x, static_cast<float>(row.step));
    Gathering to[kSignals];
    for (std::size_t s = 0; s < kSignals; ++s) to[s] = begin<kEdge>(row, row.signal[s], x);
    const float* spline = kSpline[kRadius - 1];
    for (int j = 0; j <= 2 * kRadius; ++j) {
        const int dy = (j - kRadius) * row.step;
        if (row.y + dy < 0 || row.y + dy >= row.height) continue;
        for (int i = 0; i <= 2 * kRadius; ++i) {
            const int dx = (i - kRadius) * row.step;
            if (dx == 0 && dy == 0) continue;
            const std::ptrdiff_t beside = static_cast<std::ptrdiff_t>(x) + dx;
            const std::ptrdiff_t at = beside + dy * row.stride;
            const Floats geometry =
                apart(surface, row.guides, at, static_cast<float>(dx), static_cast<float>(dy));
            Floats weight = splat(spline[i] * spline[j]);
            if (kEdge) weight = zero_unless(inside(pixel_numbers(beside), row.width), weight);
            for (std::size_t s = 0; s < kSignals; ++s) add_neighbour(row.signal[s], at, geometry, weight, to[s]);
        }
    }
    for (std::size_t s = 0; s < kSignals; ++s) finish(to[s], row.signal[s], x);
}

template <std::size_t kSignals, int kRadius>
static void smooth_row(const AtrousRow& row) {
    const auto width = static_cast<std::size_t>(row.width);
    const auto reach = static_cast<std::size_t>(kRadius * row.step);
    for (std::size_t x = 0; x < width; x += lane_count()) {
        if (x >= reach && x + lane_count() + reach <= width) {
            smooth_pixels<kSignals, kRadius, false>(row, x);
        } else {
            smooth_pixels<kSignals, kRadius, true>(row, x);
        }
    }
}

static void atrous_row(const AtrousRow& row) {
    if (row.radius == 1) {
        row.signals == 1 ? smooth_row<1, 1>(row) : smooth_row<2, 1>(row);
    } else {
        row.signals == 1 ? smooth_row<1, 2>(row) : smooth_row<2, 2>(row);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(atrous_row);

namespace {

// The furthest a kernel may look beside its row.
constexpr int kFurthest = static_cast<int>(Plane::kMargin);

AtrousSignal rows_of(const Signal& in, Signal& out, int y) {
    AtrousSignal rows{};
    point_to(rows.light, in.light, y);
    rows.luminance = in.luminance.row(y);
    rows.variance = in.variance.row(y);
    rows.stiffness = in.stiffness.empty() ? nullptr : in.stiffness.row(y);
    point_to(rows.out_light, out.light, y);
    rows.out_luminance = out.luminance.row(y);
    rows.out_variance = out.variance.row(y);
    return rows;
}

}  // namespace

void Signal::fit(int width, int height) {
    light.fit(width, height);
    luminance.fit(width, height);
    variance.fit(width, height);
}

void atrous_level(const Guides& guides, std::span<const Signal* const> in, const AtrousSettings& settings, int level,
                  const Jobs& jobs, std::span<Signal* const> out) {
    EXPECTS(in.size() == out.size() && (in.size() == 1 || in.size() == 2));
    EXPECTS(settings.radius == 1 || settings.radius == 2);
    EXPECTS(level >= 0 && (settings.radius << level) <= kFurthest);
    EXPECTS(settings.luminance_sigmas > 0.0f);
    AtrousRow shared{};
    shared.signals = static_cast<int>(in.size());
    shared.radius = settings.radius;
    shared.step = 1 << level;
    shared.width = guides.width();
    shared.height = guides.height();
    shared.stride = guides.nearness.stride();
    shared.luminance_sigmas = settings.luminance_sigmas;
    for (std::size_t s = 0; s < in.size(); ++s) {
        EXPECTS(in[s] != out[s] && in[s]->light.width() == shared.width && in[s]->light.height() == shared.height);
        out[s]->fit(shared.width, shared.height);
    }
    run_rows(shared.height, jobs, [&](int y) {
        AtrousRow row = shared;
        row.y = y;
        row.guides = filter::rows_of(guides, y);
        for (std::size_t s = 0; s < in.size(); ++s) row.signal[s] = rows_of(*in[s], *out[s], y);
        HWY_DYNAMIC_DISPATCH(atrous_row)(row);
    });
}

void atrous(const Guides& guides, const AtrousSettings& settings, const Jobs& jobs, Signal& signal, Signal& scratch) {
    for (int level = 0; level < settings.levels; ++level) {
        const Signal* in[] = {&signal};
        Signal* out[] = {&scratch};
        atrous_level(guides, in, settings, level, jobs, out);
        std::swap(signal.light, scratch.light);
        std::swap(signal.luminance, scratch.luminance);
        std::swap(signal.variance, scratch.variance);
    }
}

}  // namespace gh::filter
#endif
