// kernels/simd_masks_avx2.h - eight doubles in two registers, and masks made of them (AVX2).
#pragma once

namespace rc::kernel::RC_ISA {
namespace {

static inline __m256i words_of(std::uint32_t bits) {
    const __m256i lane_bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    return _mm256_cmpeq_epi32(_mm256_and_si256(_mm256_set1_epi32(static_cast<int>(bits)), lane_bit),
                              lane_bit);
}
struct Lanes {
    __m256 sign;
};
static inline Lanes lanes_of(std::uint32_t bits) {
    return {_mm256_castsi256_ps(words_of(bits))};
}
static inline Lanes is_above(Float a, Float b) {
    return {_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ)};
}
static inline Lanes has_sign(Float a) {
    return {a.v};
}
static inline Float where(Lanes lanes, Float yes, Float no) {
    return {_mm256_blendv_ps(no.v, yes.v, lanes.sign)};
}
static inline Words where(Lanes lanes, Words yes, Words no) {
    return {_mm256_castps_si256(
        _mm256_blendv_ps(_mm256_castsi256_ps(no.v), _mm256_castsi256_ps(yes.v), lanes.sign))};
}
// A value of every corner of a leaf, and whatever lies behind the last.
struct Row {
    Float low, high;
};
static inline Row load_row(const float* p) {
    return {load(p), load(p + 8)};
}
static inline Row splat_row(float a) {
    return {splat(a), splat(a)};
}
static inline Row operator-(Row a, Row b) {
    return {a.low - b.low, a.high - b.high};
}
static inline Row operator*(Row a, Row b) {
    return {a.low * b.low, a.high * b.high};
}
// Lane i: the value of the corner that the lowest four bits of `which` name.
static inline Float pick(Row row, Words which) {
    const __m256 low = _mm256_permutevar8x32_ps(row.low.v, which.v),
                 high = _mm256_permutevar8x32_ps(row.high.v, which.v),
                 is_high = _mm256_castsi256_ps(_mm256_slli_epi32(which.v, 28));
    return {_mm256_blendv_ps(low, high, is_high)};
}
// The same where all that are named are among the first eight.
static inline Float pick_low(Row row, Words which) {
    return {_mm256_permutevar8x32_ps(row.low.v, which.v)};
}
inline constexpr bool kHasWideDoubles = false;  // one register holds a Double
struct Double {
    __m256d low, high;
};
static inline Double load(const double* p) {
    return {_mm256_loadu_pd(p), _mm256_loadu_pd(p + 4)};
}
static inline void store(double* p, Double a) {
    _mm256_storeu_pd(p, a.low);
    _mm256_storeu_pd(p + 4, a.high);
}
static inline Double splat(double a) {
    return {_mm256_set1_pd(a), _mm256_set1_pd(a)};
}
static inline Double widen(Float a) {
    return {_mm256_cvtps_pd(_mm256_castps256_ps128(a.v)), _mm256_cvtps_pd(_mm256_extractf128_ps(a.v, 1))};
}
static inline Float narrow(Double a) {
    return {_mm256_set_m128(_mm256_cvtpd_ps(a.high), _mm256_cvtpd_ps(a.low))};
}
static inline Double operator+(Double a, Double b) {
    return {_mm256_add_pd(a.low, b.low), _mm256_add_pd(a.high, b.high)};
}
static inline Double operator-(Double a, Double b) {
    return {_mm256_sub_pd(a.low, b.low), _mm256_sub_pd(a.high, b.high)};
}
static inline Double operator*(Double a, Double b) {
    return {_mm256_mul_pd(a.low, b.low), _mm256_mul_pd(a.high, b.high)};
}
static inline Double operator/(Double a, Double b) {
    return {_mm256_div_pd(a.low, b.low), _mm256_div_pd(a.high, b.high)};
}
static inline std::uint32_t bits_of(__m256d low, __m256d high) {
    return static_cast<std::uint32_t>(_mm256_movemask_pd(low) | _mm256_movemask_pd(high) << 4);
}
static inline std::uint32_t not_negative_bits(Double a) {
    const __m256d zero = _mm256_setzero_pd();
    return bits_of(_mm256_cmp_pd(a.low, zero, _CMP_GE_OQ), _mm256_cmp_pd(a.high, zero, _CMP_GE_OQ));
}
static inline std::uint32_t not_positive_bits(Double a) {
    const __m256d zero = _mm256_setzero_pd();
    return bits_of(_mm256_cmp_pd(a.low, zero, _CMP_LE_OQ), _mm256_cmp_pd(a.high, zero, _CMP_LE_OQ));
}
// Written back whole, which takes a few cycles: a store under a mask takes dozens on some processors.
static inline void store_where(double* p, Double a, std::uint32_t bits) {
    const __m256i lanes = words_of(bits);
    const __m256d low = _mm256_castsi256_pd(_mm256_cvtepi32_epi64(_mm256_castsi256_si128(lanes)));
    const __m256d high = _mm256_castsi256_pd(_mm256_cvtepi32_epi64(_mm256_extracti128_si256(lanes, 1)));
    _mm256_storeu_pd(p, _mm256_blendv_pd(_mm256_loadu_pd(p), a.low, low));
    _mm256_storeu_pd(p + 4, _mm256_blendv_pd(_mm256_loadu_pd(p + 4), a.high, high));
}
static inline void store_where(float* p, Float a, std::uint32_t bits) {
    store(p, where(lanes_of(bits), a, load(p)));
}
static inline void store_where(std::uint32_t* p, Words a, std::uint32_t bits) {
    store(p, where(lanes_of(bits), a, load(p)));
}
static inline std::uint32_t equal_bits(Words a, Words b) {
    const __m256i equal = _mm256_cmpeq_epi32(a.v, b.v);
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(equal)));
}
static inline std::uint32_t above_bits(Words a, Words b) {
    const __m256i sign = _mm256_set1_epi32(INT32_MIN);
    const __m256i above = _mm256_cmpgt_epi32(_mm256_xor_si256(a.v, sign), _mm256_xor_si256(b.v, sign));
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(above)));
}
struct CompressLanes {
    std::uint64_t of[256];
    constexpr CompressLanes() : of{} {
        for (std::uint32_t bits = 0; bits < 256; ++bits) {
            int n = 0;
            for (std::uint64_t lane = 0; lane < 8; ++lane)
                if (bits >> lane & 1) of[bits] |= lane << (8 * n++);
        }
    }
};
inline constexpr CompressLanes kCompressLanes;

static inline Words compressed_lanes(std::uint32_t bits) {
    return {_mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(kCompressLanes.of[bits])))};
}
static inline Float compress(Float a, std::uint32_t bits) {
    return {_mm256_permutevar8x32_ps(a.v, compressed_lanes(bits).v)};
}
static inline Words compress(Words a, std::uint32_t bits) {
    return {_mm256_permutevar8x32_epi32(a.v, compressed_lanes(bits).v)};
}
static inline std::uint32_t lane_of_least(Float a, std::uint32_t bits) {
    const __m256 mask = _mm256_castsi256_ps(words_of(bits));
    const __m256 masked = _mm256_blendv_ps(_mm256_set1_ps(__builtin_inff()), a.v, mask);
    const __m256 is_least = _mm256_cmp_ps(masked, _mm256_set1_ps(least(masked)), _CMP_EQ_OQ);
    const std::uint32_t lanes = static_cast<std::uint32_t>(_mm256_movemask_ps(is_least)) & bits;
    return static_cast<std::uint32_t>(__builtin_ctz(lanes | 0x100u));
}
static inline std::uint32_t common_bits(Words a, std::uint32_t b) {
    const __m256i common = _mm256_and_si256(a.v, _mm256_set1_epi32(static_cast<int>(b)));
    const __m256i none = _mm256_cmpeq_epi32(common, _mm256_setzero_si256());
    return ~static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(none))) & 0xFFu;
}
static inline std::uint32_t less_equal_bits(Float a, Float b) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
}
static inline std::uint32_t opposite_bits(Float a, Float b) {
    const __m256 zero = _mm256_setzero_ps();
    const __m256 both =
        _mm256_and_ps(_mm256_cmp_ps(a.v, zero, _CMP_LT_OQ), _mm256_cmp_ps(b.v, zero, _CMP_GT_OQ));
    return static_cast<std::uint32_t>(_mm256_movemask_ps(both));
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
