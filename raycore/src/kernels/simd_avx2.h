// kernels/simd_avx2.h - eight floats in one AVX register.
#pragma once

#include <immintrin.h>

#ifndef RC_ISA
#define RC_ISA isa_avx2
#endif

namespace rc::kernel::RC_ISA {
namespace {

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
static inline Float operator+(Float a, Float b) {
    return {_mm256_add_ps(a.v, b.v)};
}
static inline Float operator-(Float a, Float b) {
    return {_mm256_sub_ps(a.v, b.v)};
}
static inline Float operator*(Float a, Float b) {
    return {_mm256_mul_ps(a.v, b.v)};
}
static inline Float operator/(Float a, Float b) {
    return {_mm256_div_ps(a.v, b.v)};
}
static inline Float absolute(Float a) {
    return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v)};
}
// a, which is not negative, with the sign of b.
static inline Float with_sign_of(Float a, Float b) {
    return {_mm256_or_ps(a.v, _mm256_and_ps(_mm256_set1_ps(-0.0f), b.v))};
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

// Eight 32-bit words.
struct Words {
    __m256i v;
};
static inline Words load(const std::uint32_t* p) {
    return {_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p))};
}
// Eight words as the floats of the same bits.
static inline Float as_floats(Words a) {
    return {_mm256_castsi256_ps(a.v)};
}
// The bits of eight floats.
static inline Words words_at(const float* p) {
    return {_mm256_castps_si256(_mm256_loadu_ps(p))};
}
static inline void store(std::uint32_t* p, Words a) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), a.v);
}
static inline float least(__m256 a) {
    __m128 m = _mm_min_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps(a, 1));
    m = _mm_min_ps(m, _mm_movehl_ps(m, m));
    m = _mm_min_ss(m, _mm_movehdup_ps(m));
    return _mm_cvtss_f32(m);
}

static inline float least_of(Float a) {
    return least(a.v);
}

static inline Words splat(std::uint32_t a) {
    return {_mm256_set1_epi32(static_cast<int>(a))};
}

// Eight half words, their highest bits being the words' own.
static inline Words load_halves(const void* p) {
    return {_mm256_cvtepi16_epi32(_mm_loadu_si128(static_cast<const __m128i*>(p)))};
}
static inline std::uint32_t half_sign_bits(Words halves) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(halves.v)));
}
static inline Words shift_right(Words a, int bits) {
    return {_mm256_srli_epi32(a.v, bits)};
}

// Eight blocks of eight floats, `step` bytes apart, turned: out[i] holds the i-th of every block.
static inline void load_turned(const void* first, std::uint64_t step, Float out[8]) {
    const char* at = static_cast<const char*>(first);
    __m256 row[8], pairs[8], fours[8];
    for (std::uint64_t i = 0; i < 8; ++i)
        row[i] = _mm256_loadu_ps(static_cast<const float*>(static_cast<const void*>(at + step * i)));
    for (int i = 0; i < 8; i += 2) {
        pairs[i] = _mm256_unpacklo_ps(row[i], row[i + 1]);
        pairs[i + 1] = _mm256_unpackhi_ps(row[i], row[i + 1]);
    }
    for (int i = 0; i < 8; i += 4) {
        fours[i] = _mm256_shuffle_ps(pairs[i], pairs[i + 2], 0x44);
        fours[i + 1] = _mm256_shuffle_ps(pairs[i], pairs[i + 2], 0xEE);
        fours[i + 2] = _mm256_shuffle_ps(pairs[i + 1], pairs[i + 3], 0x44);
        fours[i + 3] = _mm256_shuffle_ps(pairs[i + 1], pairs[i + 3], 0xEE);
    }
    for (int i = 0; i < 4; ++i) {
        out[i].v = _mm256_permute2f128_ps(fours[i], fours[i + 4], 0x20);
        out[i + 4].v = _mm256_permute2f128_ps(fours[i], fours[i + 4], 0x31);
    }
}
// The other way: the i-th lanes of four vectors become block i, sixteen bytes of every `step`.
static inline void store_turned(void* first, std::uint64_t step, Float a, Float b, Float c, Float d) {
    char* at = static_cast<char*>(first);
    const __m256 ab_low = _mm256_unpacklo_ps(a.v, b.v), ab_high = _mm256_unpackhi_ps(a.v, b.v);
    const __m256 cd_low = _mm256_unpacklo_ps(c.v, d.v), cd_high = _mm256_unpackhi_ps(c.v, d.v);
    const __m256 block[4] = {_mm256_shuffle_ps(ab_low, cd_low, 0x44), _mm256_shuffle_ps(ab_low, cd_low, 0xEE),
                             _mm256_shuffle_ps(ab_high, cd_high, 0x44),
                             _mm256_shuffle_ps(ab_high, cd_high, 0xEE)};
    for (std::uint64_t i = 0; i < 4; ++i) {
        float* low = static_cast<float*>(static_cast<void*>(at + step * i));
        float* high = static_cast<float*>(static_cast<void*>(at + step * (i + 4)));
        _mm_storeu_ps(low, _mm256_castps256_ps128(block[i]));
        _mm_storeu_ps(high, _mm256_extractf128_ps(block[i], 1));
    }
}

}  // namespace
}  // namespace rc::kernel::RC_ISA

#ifdef __AVX512VL__
#include "kernels/simd_masks_avx512.h"
#else
#include "kernels/simd_masks_avx2.h"
#endif
