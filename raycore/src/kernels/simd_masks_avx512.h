// kernels/simd_masks_avx512.h - eight doubles in one register, and masks that are registers of their own (AVX-512VL).
#pragma once

namespace rc::kernel::RC_ISA {
namespace {

// Which lanes, for `where`.
struct Lanes {
    __mmask8 bits;
};
static inline Lanes lanes_of(std::uint32_t bits) {
    return {static_cast<__mmask8>(bits)};
}
static inline Lanes is_above(Float a, Float b) {
    return {_mm256_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ)};
}
static inline Lanes has_sign(Float a) {
    return {_mm256_movepi32_mask(_mm256_castps_si256(a.v))};
}
static inline Float where(Lanes lanes, Float yes, Float no) {
    return {_mm256_mask_blend_ps(lanes.bits, no.v, yes.v)};
}
static inline Words where(Lanes lanes, Words yes, Words no) {
    return {_mm256_mask_blend_epi32(lanes.bits, no.v, yes.v)};
}
// A value of every corner of a leaf, and whatever lies behind the last.
struct Row {
    __m512 v;
};
static inline Row load_row(const float* p) {
    return {_mm512_loadu_ps(p)};
}
static inline Row splat_row(float a) {
    return {_mm512_set1_ps(a)};
}
static inline Row operator-(Row a, Row b) {
    return {_mm512_sub_ps(a.v, b.v)};
}
static inline Row operator*(Row a, Row b) {
    return {_mm512_mul_ps(a.v, b.v)};
}
// Lane i: the value of the corner that the lowest four bits of `which` name.
static inline Float pick(Row row, Words which) {
    const __m512 picked = _mm512_maskz_permutexvar_ps(0xFFFF, _mm512_castsi256_si512(which.v), row.v);
    Float first;
    __builtin_memcpy(&first.v, &picked, sizeof(first.v));  // GCC 12 takes the plain cast for uninitialised
    return first;
}
// The same where all that are named are among the first eight.
static inline Float pick_low(Row row, Words which) {
    return pick(row, which);
}
inline constexpr bool kHasWideDoubles = true;  // one register holds a Double
// Eight doubles.
struct Double {
    __m512d v;
};
static inline Double load(const double* p) {
    return {_mm512_loadu_pd(p)};
}
static inline void store(double* p, Double a) {
    _mm512_storeu_pd(p, a.v);
}
static inline Double splat(double a) {
    return {_mm512_set1_pd(a)};
}
static inline Double widen(Float a) {
    return {_mm512_maskz_cvtps_pd(0xFF, a.v)};  // GCC 12 takes the plain one for uninitialised
}
static inline Float narrow(Double a) {
    return {_mm512_maskz_cvtpd_ps(0xFF, a.v)};
}
static inline Double operator+(Double a, Double b) {
    return {_mm512_add_pd(a.v, b.v)};
}
static inline Double operator-(Double a, Double b) {
    return {_mm512_sub_pd(a.v, b.v)};
}
static inline Double operator*(Double a, Double b) {
    return {_mm512_mul_pd(a.v, b.v)};
}
static inline Double operator/(Double a, Double b) {
    return {_mm512_div_pd(a.v, b.v)};
}
static inline std::uint32_t not_negative_bits(Double a) {
    return _mm512_cmp_pd_mask(a.v, _mm512_setzero_pd(), _CMP_GE_OQ);
}
static inline std::uint32_t not_positive_bits(Double a) {
    return _mm512_cmp_pd_mask(a.v, _mm512_setzero_pd(), _CMP_LE_OQ);
}
// Leaves the lanes outside `bits` as they are.
static inline void store_where(double* p, Double a, std::uint32_t bits) {
    _mm512_mask_storeu_pd(p, static_cast<__mmask8>(bits), a.v);
}
static inline void store_where(float* p, Float a, std::uint32_t bits) {
    _mm256_mask_storeu_ps(p, static_cast<__mmask8>(bits), a.v);
}
static inline void store_where(std::uint32_t* p, Words a, std::uint32_t bits) {
    _mm256_mask_storeu_epi32(p, static_cast<__mmask8>(bits), a.v);
}
static inline std::uint32_t equal_bits(Words a, Words b) {
    return _mm256_cmpeq_epi32_mask(a.v, b.v);
}
static inline std::uint32_t above_bits(Words a, Words b) {
    return _mm256_cmpgt_epu32_mask(a.v, b.v);
}
// The lanes of `bits` side by side, in their order; what follows them means nothing.
static inline Float compress(Float a, std::uint32_t bits) {
    return {_mm256_maskz_compress_ps(static_cast<__mmask8>(bits), a.v)};
}
static inline Words compress(Words a, std::uint32_t bits) {
    return {_mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), a.v)};
}
// The lane of `bits` that holds the least, the lowest of equals; 8 when `bits` is 0.
static inline std::uint32_t lane_of_least(Float a, std::uint32_t bits) {
    const __mmask8 mask = static_cast<__mmask8>(bits);
    const __m256 masked = _mm256_mask_mov_ps(_mm256_set1_ps(__builtin_inff()), mask, a.v);
    const std::uint32_t lanes =
        _mm256_mask_cmp_ps_mask(mask, masked, _mm256_set1_ps(least(masked)), _CMP_EQ_OQ);
    return static_cast<std::uint32_t>(__builtin_ctz(lanes | 0x100u));
}
// Lanes where a shares a bit with b.
static inline std::uint32_t common_bits(Words a, std::uint32_t b) {
    return _mm256_test_epi32_mask(a.v, _mm256_set1_epi32(static_cast<int>(b)));
}
static inline std::uint32_t less_equal_bits(Float a, Float b) {
    return _mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ);
}
static inline std::uint32_t opposite_bits(Float a, Float b) {
    const __m256 zero = _mm256_setzero_ps();
    const __mmask8 below = _mm256_cmp_ps_mask(a.v, zero, _CMP_LT_OQ);
    return _mm256_mask_cmp_ps_mask(below, b.v, zero, _CMP_GT_OQ);
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
