// kernels/simd_avx2.h - eight floats in one AVX register.
#pragma once

#include <immintrin.h>

#ifndef RC_ISA
#define RC_ISA isa_avx2
#endif

namespace rc::kernel::RC_ISA {

struct Float {
    __m256 v;
};

static inline Float load(const float* p) {
    return {_mm256_loadu_ps(p)};
}
static inline void store(float* p, Float a) {
    _mm256_storeu_ps(p, a.v);
}
static inline Float splat(float a) {
    return {_mm256_set1_ps(a)};
}
static inline Float operator-(Float a, Float b) {
    return {_mm256_sub_ps(a.v, b.v)};
}
static inline Float operator*(Float a, Float b) {
    return {_mm256_mul_ps(a.v, b.v)};
}
static inline Float min(Float a, Float b) {
    return {_mm256_min_ps(a.v, b.v)};
}
static inline Float max(Float a, Float b) {
    return {_mm256_max_ps(a.v, b.v)};
}
static inline Float about_fma(Float a, Float b, Float c) {
    return {_mm256_fmadd_ps(a.v, b.v, c.v)};
}

#ifdef __AVX512VL__
static inline std::uint32_t less_equal_bits(Float a, Float b) {
    return _mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ);
}
static inline std::uint32_t opposite_bits(Float a, Float b) {
    const __m256 zero = _mm256_setzero_ps();
    const __mmask8 below = _mm256_cmp_ps_mask(a.v, zero, _CMP_LT_OQ);
    return _mm256_mask_cmp_ps_mask(below, b.v, zero, _CMP_GT_OQ);
}
#else
static inline std::uint32_t less_equal_bits(Float a, Float b) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
}
static inline std::uint32_t opposite_bits(Float a, Float b) {
    const __m256 zero = _mm256_setzero_ps();
    const __m256 both =
        _mm256_and_ps(_mm256_cmp_ps(a.v, zero, _CMP_LT_OQ), _mm256_cmp_ps(b.v, zero, _CMP_GT_OQ));
    return static_cast<std::uint32_t>(_mm256_movemask_ps(both));
}
#endif

}  // namespace rc::kernel::RC_ISA
