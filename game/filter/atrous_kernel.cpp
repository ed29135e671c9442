#include "filter/atrous_kernel.h"

#include <algorithm>
#include <iterator>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/atrous_kernel.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/geometry-inl.h"
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

// The part of the tolerated difference that does not come from noise, as a share of the light: rounding, not signal.
constexpr float kLeastDifference = 1e-3f;

// Fourth roots of the weights of the cubic B-spline relative to its middle; for 3x3 those of the linear one, 1/2 beside
// and 1/4 across. What they weigh is raised to the fourth power in the end.
constexpr float kSplineRoot[2][5] = {{0.840896415f, 1.0f, 0.840896415f, 0.0f, 0.0f},
                                     {0.638943104f, 0.903602004f, 1.0f, 0.903602004f, 0.638943104f}};

// Pixels a signal is taken through before the next: more would not stay in the nearest cache with what was found out about
// their neighbours, and with fewer all signals at once are more streams of memory than a core follows.
constexpr std::size_t kBlock = 128;

// The pixels about one, row by row, without itself.
template <int kRadius>
struct Around {
    static constexpr int kSide = 2 * kRadius + 1;
    static constexpr std::size_t kCount = kSide * kSide - 1;
    static constexpr int cell(std::size_t k) { return static_cast<int>(k < kCount / 2 ? k : k + 1); }
    static constexpr int dx(std::size_t k) { return cell(k) % kSide - kRadius; }
    static constexpr int dy(std::size_t k) { return cell(k) / kSide - kRadius; }
    static constexpr float root(std::size_t k) {
        return kSplineRoot[kRadius - 1][dx(k) + kRadius] * kSplineRoot[kRadius - 1][dy(k) + kRadius];
    }
    using Each = std::make_index_sequence<kCount>;

    std::ptrdiff_t
        at[kCount];  // of the neighbour, from the pixel; a row that is not there is the pixel's own
    bool is_line_in[kCount];
    // Of a block of pixels: fourth roots of their weights if their light is the same. What all signals ask alike.
    alignas(64) float near[kCount][kBlock];
    bool is_known[kBlock];  // of a vector, at its first pixel: where all light is sure nobody asks
};

// A pixel on its way: what a neighbour is measured by, and what has come together.
struct Gathering {
    Floats middle, scale;  // luminance; quarter of the reciprocal of what it may differ by
    Ints part;             // if it matters
    Floats stiffness;
    Floats variance;  // about here
    Lanes sure;       // whose noise is less than rounding
    Floats r, y, b, weight, squares;
};

static HWY_INLINE Ints load_part(const std::uint32_t* from) {
    return hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(from));
}

template <int kRadius, bool kEdge, std::size_t k>
static HWY_INLINE void ask_neighbour(const AtrousRow& row, const GuideRows& guides, const Surface& surface,
                                     std::size_t x, Around<kRadius>& around) {
    using A = Around<kRadius>;
    const int dx = A::dx(k) * row.step, dy = A::dy(k) * row.step;
    const Floats foretold = beside(surface, below(surface, dy), dx);
    const auto here = static_cast<std::ptrdiff_t>(x);
    const Floats off = apart(surface, guides, here + around.at[k], foretold);
    Floats near = hn::Mul(hn::Sub(splat(1.0f), off), splat(A::root(k)));
    if (kEdge) near = zero_unless(inside(pixel_numbers(here + dx), row.width), near);
    store(around.is_line_in[k] ? near : hn::Zero(F()), around.near[k] + x % kBlock);
}

template <int kRadius, bool kEdge, std::size_t... k>
static HWY_INLINE void ask_neighbours(const AtrousRow& row, std::size_t x, Around<kRadius>& around,
                                      std::index_sequence<k...> /*each*/) {
    const GuideRows guides = row.guides;
    const Surface surface = surface_at(guides, x, static_cast<float>(row.step));
    (ask_neighbour<kRadius, kEdge, k>(row, guides, surface, x, around), ...);
}

// Variance averaged over 3x3 pixels with (1 2 1)/4 either way (Schied et al., section 4.4): a lone pixel's own estimate
// is too uncertain, and a dark pixel among bright ones would let nobody in.
template <bool kEdge>
static HWY_INLINE Floats smooth_variance(const AtrousRow& row, const AtrousSignal& signal, std::size_t x) {
    const Lanes all = hn::Eq(hn::Zero(F()), hn::Zero(F()));
    const auto first = static_cast<std::ptrdiff_t>(x);
    const Lanes left_in = kEdge ? inside(pixel_numbers(first - 1), row.width) : all;
    const Lanes right_in = kEdge ? inside(pixel_numbers(first + 1), row.width) : all;
    const auto line = [&](int dy) {
        const bool is_in = 0 <= row.y + dy && row.y + dy < row.height;
        const float* from = signal.variance + first + (is_in ? dy : 0) * row.stride;
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
static HWY_INLINE Gathering begin(const AtrousRow& row, const AtrousSignal& signal, std::size_t x) {
    Gathering to;
    to.variance = smooth_variance<kEdge>(row, signal, x);
    to.middle = load(signal.light[1] + x);
    const Floats by_noise = hn::Mul(hn::Sqrt(to.variance), splat(signal.luminance_sigmas));
    const Floats by_rounding = hn::Mul(hn::Abs(to.middle), splat(kLeastDifference));
    to.sure = hn::Le(by_noise, by_rounding);
    const Floats may_differ = hn::Add(by_noise, hn::Add(by_rounding, splat(1e-20f)));
    to.scale = hn::Div(splat(0.25f), may_differ);
    to.stiffness = signal.stiffness == nullptr
                       ? hn::Zero(F())
                       : hn::Mul(load(signal.stiffness + x), splat(static_cast<float>(row.step)));
    to.part = signal.part != nullptr ? load_part(signal.part + x) : hn::Zero(I());
    to.r = load(signal.light[0] + x);
    to.y = to.middle;
    to.b = load(signal.light[2] + x);
    to.weight = to.squares = splat(1.0f);
    return to;
}

// `kPicky`: by stiffness and part as well.
template <int kRadius, bool kPicky, std::size_t k>
static HWY_INLINE void add_neighbour(const AtrousSignal& signal, const float* const light[3],
                                     std::ptrdiff_t x, const Around<kRadius>& around, Gathering& to) {
    const std::ptrdiff_t at = around.at[k];
    const Floats y = load(light[1] + at);
    Floats off = hn::Mul(hn::Abs(hn::Sub(y, to.middle)), to.scale);
    if (kPicky) off = hn::Add(off, to.stiffness);
    off = hn::Mul(off, splat(Around<kRadius>::root(k)));
    Floats root =
        hn::Max(hn::Sub(load(around.near[k] + static_cast<std::size_t>(x) % kBlock), off), hn::Zero(F()));
    if (kPicky && signal.part != nullptr)
        root = zero_unless(hn::RebindMask(F(), hn::Eq(load_part(signal.part + x + at), to.part)), root);
    const Floats root2 = hn::Mul(root, root);
    const Floats weight = hn::Mul(root2, root2);  // spline times falloff() of all together
    to.r = hn::Add(to.r, hn::Mul(weight, load(light[0] + at)));
    to.y = hn::Add(to.y, hn::Mul(weight, y));
    to.b = hn::Add(to.b, hn::Mul(weight, load(light[2] + at)));
    to.squares = hn::Add(to.squares, hn::Mul(weight, weight));
    to.weight = hn::Add(to.weight, weight);
}

template <int kRadius, bool kPicky, std::size_t... k>
static HWY_INLINE void add_neighbours(const AtrousSignal& signal, std::size_t x,
                                      const Around<kRadius>& around, Gathering& to,
                                      std::index_sequence<k...> /*each*/) {
    const float* const light[3] = {signal.light[0] + x, signal.light[1] + x, signal.light[2] + x};
    (add_neighbour<kRadius, kPicky, k>(signal, light, static_cast<std::ptrdiff_t>(x), around, to), ...);
}

static HWY_INLINE void store_smooth(const Gathering& from, Floats smooth, const float* own, float* to) {
    store_far(choose(from.sure, load(own), smooth), to);
}

// The neighbours' variance is taken to be what it is about here: one plane less to read for every neighbour, and each
// estimate alone is poor anyway.
static HWY_INLINE void finish(const Gathering& from, const AtrousSignal& signal, std::size_t x) {
    const Floats share = hn::Div(splat(1.0f), from.weight);
    store_smooth(from, hn::Mul(from.r, share), signal.light[0] + x, signal.out_light[0] + x);
    store_smooth(from, hn::Mul(from.y, share), signal.light[1] + x, signal.out_light[1] + x);
    store_smooth(from, hn::Mul(from.b, share), signal.light[2] + x, signal.out_light[2] + x);
    if (signal.out_variance == nullptr) return;
    const Floats variance = hn::Mul(hn::Mul(from.variance, from.squares), hn::Mul(share, share));
    store_smooth(from, variance, signal.variance + x, signal.out_variance + x);
}

static void keep_pixels(const AtrousSignal& signal, std::size_t x) {
    for (std::size_t c = 0; c < 3; ++c) store(load(signal.light[c] + x), signal.out_light[c] + x);
    if (signal.out_variance != nullptr) store(load(signal.variance + x), signal.out_variance + x);
}

template <int kRadius, bool kEdge>
static HWY_INLINE void smooth_pixels(const AtrousRow& row, const AtrousSignal& signal, std::size_t x,
                                     Around<kRadius>& around) {
    using Each = typename Around<kRadius>::Each;
    Gathering to = begin<kEdge>(row, signal, x);
    if (hn::AllTrue(F(), to.sure)) return keep_pixels(signal, x);
    if (!around.is_known[x % kBlock]) ask_neighbours<kRadius, kEdge>(row, x, around, Each());
    around.is_known[x % kBlock] = true;
    if (signal.stiffness != nullptr || signal.part != nullptr) {
        add_neighbours<kRadius, true>(signal, x, around, to, Each());
    } else {
        add_neighbours<kRadius, false>(signal, x, around, to, Each());
    }
    finish(to, signal, x);
}

template <int kRadius>
static void smooth_row(const AtrousRow& row) {
    Around<kRadius> around;
    for (std::size_t k = 0; k < Around<kRadius>::kCount; ++k) {
        const int dy = Around<kRadius>::dy(k) * row.step;
        around.is_line_in[k] = 0 <= row.y + dy && row.y + dy < row.height;
        around.at[k] = Around<kRadius>::dx(k) * row.step + (around.is_line_in[k] ? dy : 0) * row.stride;
    }
    const auto width = static_cast<std::size_t>(row.width);
    const auto reach = static_cast<std::size_t>(kRadius) * static_cast<std::size_t>(row.step);
    const auto has_all = [&](std::size_t x) { return x >= reach && x + lane_count() + reach <= width; };
    for (std::size_t block = 0; block < width; block += kBlock) {
        const std::size_t end = std::min(block + kBlock, width);
        std::fill(std::begin(around.is_known), std::end(around.is_known), false);
        for (int i = 0; i < row.count; ++i) {
            for (std::size_t x = block; x < end; x += lane_count()) {
                has_all(x) ? smooth_pixels<kRadius, false>(row, row.signals[i], x, around)
                           : smooth_pixels<kRadius, true>(row, row.signals[i], x, around);
            }
        }
    }
}

static void smooth_one_row(const AtrousRow& row) {
    row.radius == 1 ? smooth_row<1>(row) : smooth_row<2>(row);
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(smooth_one_row);

void atrous_row(const AtrousRow& row) {
    HWY_DYNAMIC_DISPATCH(smooth_one_row)(row);
}

}  // namespace gh::filter
#endif
