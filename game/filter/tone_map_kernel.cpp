#include "filter/tone_map_kernel.h"

#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/tone_map_kernel.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

// NaN is black.
static HWY_INLINE Floats exposed(Floats radiance, Floats exposure) {
    const Floats light = positive(hn::Mul(radiance, exposure)), most = splat(1e9f);
    return choose(hn::Lt(light, most), light, most);
}

static HWY_INLINE Floats larger(Floats a, Floats b) {
    return choose(hn::Gt(b, a), b, a);
}

// film_curve() of what is above 0.
static HWY_INLINE Floats curve(Floats x) {
    const Floats over = hn::Div(hn::Sub(x, splat(kKnee)), splat(1.0f - kKnee));
    const Floats bent =
        hn::Add(splat(kKnee), hn::Mul(splat(1.0f - kKnee), hn::Div(over, hn::Add(splat(1.0f), over))));
    return choose(hn::Gt(x, splat(kKnee)), bent, x);
}

// The sRGB code, 255 at 1, of linear light in [0, 1]: above its straight part a polynomial in the root of the light, in
// which the function is nearly straight itself. Chebyshev's, off by .06 of a code at most; table and gathers took twice as
// long as all the rest.
static HWY_INLINE Floats srgb_code(Floats linear) {
    constexpr float kBent[] = {704.4776611f,  -1072.2751465f, 875.4388428f,
                               -450.6159668f, 397.4814453f,   -10.6013603f};
    const Floats root = hn::Sqrt(linear);
    Floats bent = splat(-188.9255066f);
    for (const float coefficient : kBent) bent = hn::Add(hn::Mul(bent, root), splat(coefficient));
    return choose(hn::Gt(linear, splat(0.0031308f)), bent, hn::Mul(linear, splat(255.0f * 12.92f)));
}

// Half a step of dither either way at most: black stays black and a code that fits stays.
static HWY_INLINE Ints code_of(Floats linear, Floats dither) {
    const Floats one = splat(1.0f);
    const Floats code = srgb_code(choose(hn::Lt(linear, one), linear, one));
    const Floats dithered = hn::Add(hn::Add(code, splat(0.25f)), dither);
    const Floats most = splat(255.0f);
    return hn::ConvertTo(I(), choose(hn::Lt(dithered, most), dithered, most));
}

// A vector of pixels; `first` tells which of the dithers is theirs.
static HWY_INLINE void tone_pixels(const ToneRow& row, std::size_t first, const float* radiance,
                                   std::uint8_t* bytes) {
    using Bytes = hn::Rebind<std::uint8_t, F>;
    const Floats zero = hn::Zero(F()), one = splat(1.0f), exposure = splat(row.exposure);
    Floats color[3];
    hn::LoadInterleaved3(F(), radiance, color[0], color[1], color[2]);
    for (Floats& c : color) c = exposed(c, exposure);
    const Floats peak = larger(larger(color[0], color[1]), color[2]);
    const Lanes lit = hn::Gt(peak, zero);
    const Floats shown = curve(peak);
    const Floats scale = zero_unless(lit, hn::Div(shown, peak));
    const Floats half_way = hn::Div(peak, hn::Add(peak, splat(kWhitening)));
    const Floats white = hn::Mul(half_way, half_way), hue = hn::Sub(one, white);
    const Floats bleached = hn::Mul(shown, white);
    const Floats dither = load(row.dither + first % kDitherSide);
    hn::Vec<Bytes> codes[3];
    for (std::size_t c = 0; c < 3; ++c) {
        const Floats linear = hn::Add(hn::Mul(hn::Mul(color[c], scale), hue), bleached);
        codes[c] = hn::DemoteTo(Bytes(), code_of(linear, dither));
    }
    hn::StoreInterleaved3(codes[0], codes[1], codes[2], Bytes(), bytes);
}

static void tone_one_row(const ToneRow& row) {
    std::size_t x = 0;
    for (; x + lane_count() <= row.width; x += lane_count())
        tone_pixels(row, x, row.radiance + 3 * x, row.bytes + 3 * x);
    if (x == row.width) return;
    float radiance[3 * kMostLanes] = {};
    std::uint8_t bytes[3 * kMostLanes];
    const std::size_t left = 3 * (row.width - x);
    std::memcpy(radiance, row.radiance + 3 * x, left * sizeof(float));
    tone_pixels(row, x, radiance, bytes);
    std::memcpy(row.bytes + 3 * x, bytes, left);
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(tone_one_row);

void tone_row(const ToneRow& row) {
    HWY_DYNAMIC_DISPATCH(tone_one_row)(row);
}

}  // namespace gh::filter
#endif
