// filter/vector-inl.h - points and colours, three vectors of numbers each. Compiled once per instruction set; see
// simd-inl.h.
#if defined(GH_FILTER_VECTOR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GH_FILTER_VECTOR_INL_H_
#undef GH_FILTER_VECTOR_INL_H_
#else
#define GH_FILTER_VECTOR_INL_H_
#endif

#include "filter/simd-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

struct Vector {
    Floats x, y, z;
};

static HWY_INLINE Vector splat3(const float* v) {
    return {splat(v[0]), splat(v[1]), splat(v[2])};
}
static HWY_INLINE Vector plus(const Vector& a, const Vector& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
static HWY_INLINE Vector minus(const Vector& a, const Vector& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
static HWY_INLINE Vector times(const Vector& a, const Vector& b) {
    return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
}
static HWY_INLINE Vector scaled(const Vector& a, Floats s) {
    return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
static HWY_INLINE Floats dot(const Vector& a, const Vector& b) {
    return dot(a.x, a.y, a.z, b.x, b.y, b.z);
}
static HWY_INLINE Floats length(const Vector& a) {
    return hn::Sqrt(dot(a, a));
}
static HWY_INLINE Vector choose(Lanes lanes, const Vector& yes, const Vector& no) {
    return {choose(lanes, yes.x, no.x), choose(lanes, yes.y, no.y), choose(lanes, yes.z, no.z)};
}
// Not for NaN.
static HWY_INLINE Vector least(const Vector& a, const Vector& b) {
    return {hn::Min(a.x, b.x), hn::Min(a.y, b.y), hn::Min(a.z, b.z)};
}
static HWY_INLINE Vector greatest(const Vector& a, const Vector& b) {
    return {hn::Max(a.x, b.x), hn::Max(a.y, b.y), hn::Max(a.z, b.z)};
}
static HWY_INLINE Vector clamped(const Vector& a, const Vector& low, const Vector& high) {
    return least(greatest(a, low), high);
}

// Of a plane each.
static HWY_INLINE Vector load3_at(const float* const from[3], std::ptrdiff_t i) {
    return {load(from[0] + i), load(from[1] + i), load(from[2] + i)};
}
static HWY_INLINE Vector load3_far(const float* const from[3], std::ptrdiff_t i) {
    return {load_far(from[0] + i), load_far(from[1] + i), load_far(from[2] + i)};
}
static HWY_INLINE void store3(const Vector& v, float* const to[3], std::size_t x) {
    store(v.x, to[0] + x);
    store(v.y, to[1] + x);
    store(v.z, to[2] + x);
}
static HWY_INLINE void store3_far(const Vector& v, float* const to[3], std::size_t x) {
    store_far(v.x, to[0] + x);
    store_far(v.y, to[1] + x);
    store_far(v.z, to[2] + x);
}

// Of a row of `width` pixels with x, y and z side by side and nothing behind it; 0 beyond.
static HWY_INLINE Vector load3(const float* row, std::size_t x, std::size_t width) {
    Vector v;
    if (x + lane_count() <= width) {
        hn::LoadInterleaved3(F(), row + 3 * x, v.x, v.y, v.z);
        return v;
    }
    HWY_ALIGN float rest[3 * HWY_MAX_BYTES / sizeof(float)] = {};
    std::copy(row + 3 * x, row + 3 * width, rest);
    hn::LoadInterleaved3(F(), rest, v.x, v.y, v.z);
    return v;
}
static HWY_INLINE void store3(const Vector& v, float* row, std::size_t x, std::size_t width) {
    if (x + lane_count() <= width) {
        hn::StoreInterleaved3(v.x, v.y, v.z, F(), row + 3 * x);
        return;
    }
    HWY_ALIGN float rest[3 * HWY_MAX_BYTES / sizeof(float)];
    hn::StoreInterleaved3(v.x, v.y, v.z, F(), rest);
    std::copy(rest, rest + 3 * (width - x), row + 3 * x);
}
static HWY_INLINE Ints load_part(const std::uint32_t* row, std::size_t x, std::size_t width) {
    const auto* numbers = reinterpret_cast<const std::int32_t*>(row);
    if (x + lane_count() <= width) return hn::LoadU(I(), numbers + x);
    HWY_ALIGN std::int32_t rest[HWY_MAX_BYTES / sizeof(std::int32_t)] = {};
    std::copy(numbers + x, numbers + width, rest);
    return hn::LoadU(I(), rest);
}

// Of its distance, by which what stands still may seem to have moved: a twentieth of a pixel at most. Where it was comes out
// of other roundings than where it is.
constexpr float kStays = 1e-4f;

// Surfaces that are `here` and were there `before`, whatever the eye did.
static HWY_INLINE Lanes stays_put(const Vector& here, const Vector& before, const Vector& eye) {
    const Vector moved = minus(here, before), way = minus(here, eye);
    const Floats distance = hn::Add(hn::Add(hn::Abs(way.x), hn::Abs(way.y)), hn::Abs(way.z));
    const Floats off = hn::Add(hn::Add(hn::Abs(moved.x), hn::Abs(moved.y)), hn::Abs(moved.z));
    return hn::Le(off, hn::Mul(distance, splat(kStays)));
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GH_FILTER_VECTOR_INL_H_
