#include "filter/atrous.h"

#include "filter/albedo.h"
#include "filter/atrous_kernel.h"
#include "filter/mend.h"
#include "filter/rows.h"

#include <algorithm>
#include <array>

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
    Ints part;             // if it matters
    Floats at_most;        // weight's fourth root of a neighbour like itself: less than 1 for stiff signals
    Floats variance;       // about here
    Lanes sure;            // whose noise is less than rounding
    Floats r, y, b, weight, squares;
};

static HWY_INLINE Ints load_part(const std::uint32_t* from) {
    return hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(from));
}

// Variance averaged over 3x3 pixels with (1 2 1)/4 either way (Schied et al., section 4.4): a lone pixel's own estimate
// is too uncertain, and a dark pixel among bright ones would let nobody in.
template <bool kEdge>
static HWY_INLINE Floats smooth_variance(const AtrousRow& row, std::size_t x) {
    const Lanes all = hn::Eq(hn::Zero(F()), hn::Zero(F()));
    const auto first = static_cast<std::ptrdiff_t>(x);
    const Lanes left_in = kEdge ? inside(pixel_numbers(first - 1), row.width) : all;
    const Lanes right_in = kEdge ? inside(pixel_numbers(first + 1), row.width) : all;
    const auto line = [&](int dy) {
        const bool is_in = 0 <= row.y + dy && row.y + dy < row.height;
        const float* from = row.variance + first + (is_in ? dy : 0) * row.stride;
        const Floats middle = load(from);
        Floats left = load(from - 1), right = load(from + 1);
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
static HWY_INLINE Gathering begin(const AtrousRow& row, std::size_t x) {
    Gathering to;
    to.variance = smooth_variance<kEdge>(row, x);
    to.middle = load(row.light[1] + x);
    const Floats by_noise = hn::Mul(hn::Sqrt(to.variance), splat(row.luminance_sigmas));
    const Floats by_rounding = hn::Mul(hn::Abs(to.middle), splat(kLeastDifference));
    to.sure = hn::Le(by_noise, by_rounding);
    const Floats may_differ = hn::Add(by_noise, hn::Add(by_rounding, splat(1e-20f)));
    to.scale = hn::Div(splat(0.25f), may_differ);
    to.at_most = splat(1.0f);
    if (row.stiffness != nullptr) {
        const Floats stiff = hn::Mul(load(row.stiffness + x), splat(static_cast<float>(row.step)));
        to.at_most = hn::Sub(to.at_most, stiff);
    }
    to.part = row.part != nullptr ? load_part(row.part + x) : hn::Zero(I());
    to.r = load(row.light[0] + x);
    to.y = to.middle;
    to.b = load(row.light[2] + x);
    to.weight = to.squares = splat(1.0f);
    return to;
}

static HWY_INLINE void add_neighbour(const AtrousRow& row, std::ptrdiff_t at, Floats geometry, Floats spline,
                                     Gathering& to) {
    const Floats y = load(row.light[1] + at);
    const Floats off = hn::Mul(hn::Abs(hn::Sub(y, to.middle)), to.scale);
    const Floats root = hn::Max(hn::Sub(to.at_most, hn::Add(geometry, off)), hn::Zero(F()));
    if (row.part != nullptr)
        spline = zero_unless(hn::RebindMask(F(), hn::Eq(load_part(row.part + at), to.part)), spline);
    const Floats root2 = hn::Mul(root, root);
    const Floats weight = hn::Mul(hn::Mul(root2, root2), spline);  // falloff() of all together
    to.r = hn::Add(to.r, hn::Mul(weight, load(row.light[0] + at)));
    to.y = hn::Add(to.y, hn::Mul(weight, y));
    to.b = hn::Add(to.b, hn::Mul(weight, load(row.light[2] + at)));
    to.squares = hn::Add(to.squares, hn::Mul(weight, weight));
    to.weight = hn::Add(to.weight, weight);
}

static HWY_INLINE void store_smooth(const Gathering& from, Floats smooth, const float* own, float* to) {
    store(choose(from.sure, load(own), smooth), to);
}

// The neighbours' variance is taken to be what it is about here: one plane less to read for every neighbour, and each
// estimate alone is poor anyway.
static HWY_INLINE void finish(const Gathering& from, const AtrousRow& row, std::size_t x) {
    const Floats share = hn::Div(splat(1.0f), from.weight);
    store_smooth(from, hn::Mul(from.r, share), row.light[0] + x, row.out_light[0] + x);
    store_smooth(from, hn::Mul(from.y, share), row.light[1] + x, row.out_light[1] + x);
    store_smooth(from, hn::Mul(from.b, share), row.light[2] + x, row.out_light[2] + x);
    const Floats variance = hn::Mul(hn::Mul(from.variance, from.squares), hn::Mul(share, share));
    store_smooth(from, variance, row.variance + x, row.out_variance + x);
}

static void keep_pixels(const AtrousRow& row, std::size_t x) {
    for (std::size_t c = 0; c < 3; ++c) store(load(row.light[c] + x), row.out_light[c] + x);
    store(load(row.variance + x), row.out_variance + x);
}

template <int kRadius, bool kEdge>
static HWY_INLINE void smooth_pixels(const AtrousRow& row, std::size_t x) {
    Gathering to = begin<kEdge>(row, x);
    if (hn::AllTrue(F(), to.sure)) return keep_pixels(row, x);
    const Surface surface = surface_at(row.guides, x, static_cast<float>(row.step));
    const float* spline = kSpline[kRadius - 1];
    for (int j = 0; j <= 2 * kRadius; ++j) {
        const int dy = (j - kRadius) * row.step;
        if (row.y + dy < 0 || row.y + dy >= row.height) continue;
        const Floats base = below(surface, dy);
        for (int i = 0; i <= 2 * kRadius; ++i) {
            const int dx = (i - kRadius) * row.step;
            if (dx == 0 && dy == 0) continue;
            const std::ptrdiff_t column = static_cast<std::ptrdiff_t>(x) + dx;
            const std::ptrdiff_t at = column + dy * row.stride;
            const Floats geometry = apart(surface, row.guides, at, beside(surface, base, dx));
            Floats weight = splat(spline[i] * spline[j]);
            if (kEdge) weight = zero_unless(inside(pixel_numbers(column), row.width), weight);
            add_neighbour(row, at, geometry, weight, to);
        }
    }
    finish(to, row, x);
}

template <int kRadius>
static void smooth_row(const AtrousRow& row) {
    const auto width = static_cast<std::size_t>(row.width);
    const auto reach = static_cast<std::size_t>(kRadius) * static_cast<std::size_t>(row.step);
    for (std::size_t x = 0; x < width; x += lane_count()) {
        if (x >= reach && x + lane_count() + reach <= width) {
            smooth_pixels<kRadius, false>(row, x);
        } else {
            smooth_pixels<kRadius, true>(row, x);
        }
    }
}

static void atrous_row(const AtrousRow& row) {
    row.radius == 1 ? smooth_row<1>(row) : smooth_row<2>(row);
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(atrous_row);

namespace {

// The furthest a kernel may look beside its row.
constexpr int kFurthest = static_cast<int>(Plane::kMargin);
constexpr int kMostLevels = 7;

void expect_fit(const Guides& guides, const SignalView& in, const AtrousSettings& settings, int level) {
    EXPECTS(settings.radius == 1 || settings.radius == 2);
    EXPECTS(level >= 0 && level < kMostLevels && (settings.radius << level) <= kFurthest);
    EXPECTS(settings.luminance_sigmas > 0.0f);
    EXPECTS(in.light->width() == guides.width() && in.light->height() == guides.height());
}

void level_row(const Guides& guides, const SignalView& in, const AtrousSettings& settings, int level, int y,
               Signal& out) {
    AtrousRow row{};
    row.guides = rows_of(guides, y);
    point_to(row.light, *in.light, y);
    row.variance = in.variance->row(y);
    row.stiffness = in.stiffness == nullptr || in.stiffness->empty() ? nullptr : in.stiffness->row(y);
    row.part = in.part == nullptr ? nullptr : in.part->row(y);
    point_to(row.out_light, out.light, y);
    row.out_variance = out.variance.row(y);
    row.radius = settings.radius;
    row.step = 1 << level;
    row.width = guides.width();
    row.height = guides.height();
    row.y = y;
    row.stride = guides.nearness.stride();
    row.luminance_sigmas = settings.luminance_sigmas;
    HWY_DYNAMIC_DISPATCH(atrous_row)(row);
}

}  // namespace

void Signal::fit(int width, int height) {
    light.fit(width, height);
    variance.fit(width, height);
}

void atrous_level(const Guides& guides, const SignalView& in, const AtrousSettings& settings, int level,
                  const Jobs& jobs, Signal& out) {
    expect_fit(guides, in, settings, level);
    EXPECTS(in.light != &out.light);
    out.fit(guides.width(), guides.height());
    run_rows_apart(guides.height(), 1 << level, jobs,
                   [&](int y) { level_row(guides, in, settings, level, y, out); });
}

void make_signal(const Plane3& light, const Plane& variance, const Jobs& jobs, Signal& signal) {
    EXPECTS(light.width() == variance.width() && light.height() == variance.height());
    signal.fit(light.width(), light.height());
    mend(light, {.floor = kInfiniteLight, .factor = 1.0f}, jobs, signal.light);
    luma_from(signal.light, jobs, signal.light);
    run_rows(light.height(), jobs, [&](int y) {
        for (int x = 0; x < light.width(); ++x) {
            const float v = variance.at(x, y);
            signal.variance.at(x, y) = v > 0.0f && v < kInfiniteLight ? v : 0.0f;
        }
    });
}

void atrous(const Guides& guides, std::span<const Smoothing> signals, const Jobs& jobs) {
    int levels = 0, radius = 1;
    for (const Smoothing& signal : signals) {
        EXPECTS(signal.settings.levels >= 1);
        levels = std::max(levels, signal.settings.levels);
        radius = std::max(radius, signal.settings.radius);
        expect_fit(guides, signal.in, signal.settings, signal.settings.levels - 1);
        for (int i = 0; i < std::min(2, signal.settings.levels); ++i)
            signal.scratch[i].fit(guides.width(), guides.height());
    }
    std::array<int, kMostLevels> reach{};
    EXPECTS(levels <= kMostLevels);
    for (int level = 1; level < levels; ++level) reach[static_cast<std::size_t>(level)] = radius << level;
    if (levels == 0) return;
    run_passes(guides.height(), std::span(reach).first(static_cast<std::size_t>(levels)), jobs,
               [&](int level, int y) {
                   for (const Smoothing& signal : signals) {
                       if (level >= signal.settings.levels) continue;
                       SignalView from = signal.in;
                       if (level > 0) {
                           const Signal& before = signal.scratch[(level - 1) % 2];
                           from.light = &before.light;
                           from.variance = &before.variance;
                       }
                       level_row(guides, from, signal.settings, level, y, signal.scratch[level % 2]);
                   }
               });
}

const Signal& atrous(const Guides& guides, const SignalView& in, const AtrousSettings& settings,
                     const Jobs& jobs, Signal scratch[2]) {
    const Smoothing one{in, settings, scratch};
    atrous(guides, std::span(&one, 1), jobs);
    return scratch[(settings.levels - 1) % 2];
}

}  // namespace gh::filter
#endif
