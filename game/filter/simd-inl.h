// filter/simd-inl.h - the words all kernels of this room use, compiled once per instruction set.
//
// A kernel file includes it after hwy/foreach_target.h, which includes that file once for every target.
//
// Same bits only operations IEEE 754 rounds once (+ - * / sqrt floor, comparisons, conversions), every lane for itself,
//           multiply and add apart: then AVX-512, AVX2, SSE and plain floats agree. No Min or Max where a NaN could
//           come in (targets differ in which operand they return); comparisons are written so that NaN is a no.
#if defined(GH_FILTER_SIMD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GH_FILTER_SIMD_INL_H_
#undef GH_FILTER_SIMD_INL_H_
#else
#define GH_FILTER_SIMD_INL_H_
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::ScalableTag<float>;
using I = hn::RebindToSigned<F>;
using Floats = hn::Vec<F>;
using Ints = hn::Vec<I>;
using Lanes = hn::Mask<F>;

static HWY_INLINE Floats splat(float x) {
    return hn::Set(F(), x);
}
static HWY_INLINE Floats load(const float* from) {
    return hn::LoadU(F(), from);
}
static HWY_INLINE void store(Floats v, float* to) {
    hn::StoreU(v, F(), to);
}
// For planes that nobody near has touched: fetches what comes a kilobyte on, or begins the next row. Rows of a dozen planes
// by turns are more than the processor foresees (to read 96 such planes took 5.3 ms, so 2.7).
template <class T>
static HWY_INLINE void fetch_far(const T* at) {
    constexpr std::ptrdiff_t kAhead = 256;
    hwy::Prefetch(at + kAhead);
}
static HWY_INLINE Floats load_far(const float* from) {
    fetch_far(from);
    return load(from);
}
static HWY_INLINE void store_far(Floats v, float* to) {
    fetch_far(to);
    store(v, to);
}
static HWY_INLINE std::size_t lane_count() {
    return hn::Lanes(F());
}

static HWY_INLINE Floats zero_unless(Lanes lanes, Floats v) {
    return hn::IfThenElseZero(lanes, v);
}
static HWY_INLINE Floats choose(Lanes lanes, Floats yes, Floats no) {
    return hn::IfThenElse(lanes, yes, no);
}

// NaN becomes 0, like everything not above it.
static HWY_INLINE Floats positive(Floats v) {
    return zero_unless(hn::Gt(v, hn::Zero(F())), v);
}
static HWY_INLINE Lanes is_finite(Floats v) {
    return hn::Le(hn::Abs(v), splat(3.402823466e38f));
}

// ITU-R BT.709.
static HWY_INLINE Floats luminance(Floats r, Floats g, Floats b) {
    return hn::Add(hn::Add(hn::Mul(splat(0.2126f), r), hn::Mul(splat(0.7152f), g)),
                   hn::Mul(splat(0.0722f), b));
}

static HWY_INLINE Floats dot(Floats ax, Floats ay, Floats az, Floats bx, Floats by, Floats bz) {
    return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

// About e^-x for x = 4 * quarter >= 0: (1 - x/4)^4, exactly 1 at 0 and exactly 0 from x = 4 on. Not for NaN.
static HWY_INLINE Floats falloff(Floats quarter) {
    const Floats t = hn::Max(hn::Sub(splat(1.0f), quarter), hn::Zero(F()));
    const Floats t2 = hn::Mul(t, t);
    return hn::Mul(t2, t2);
}

// The pixel numbers of a vector that starts at pixel x.
static HWY_INLINE Ints pixel_numbers(std::ptrdiff_t x) {
    return hn::Iota(I(), static_cast<std::int32_t>(x));
}

// Which of these pixels lie in [0, count).
static HWY_INLINE Lanes inside(Ints pixel, int count) {
    const auto yes = hn::And(hn::Gt(pixel, hn::Set(I(), -1)), hn::Lt(pixel, hn::Set(I(), count)));
    return hn::RebindMask(F(), yes);
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GH_FILTER_SIMD_INL_H_
