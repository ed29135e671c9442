// kernels/simd_scalar.h - eight floats in plain C++: what every other ISA must equal in every bit.
#pragma once

#define RC_ISA isa_scalar

namespace rc::kernel::RC_ISA {
namespace {

struct Float {
    float lane[8];
};

template <class Op>
static inline Float each(Op op) {
    Float r;
    for (int i = 0; i < 8; ++i) r.lane[i] = op(i);
    return r;
}

static inline Float load(const float* p) {
    return each([&](int i) { return p[i]; });
}
static inline void store(float* p, Float a) {
    for (int i = 0; i < 8; ++i) p[i] = a.lane[i];
}
static inline Float splat(float a) {
    return each([&](int) { return a; });
}
static inline Float operator+(Float a, Float b) {
    return each([&](int i) { return a.lane[i] + b.lane[i]; });
}
static inline Float operator-(Float a, Float b) {
    return each([&](int i) { return a.lane[i] - b.lane[i]; });
}
static inline Float operator*(Float a, Float b) {
    return each([&](int i) { return a.lane[i] * b.lane[i]; });
}
static inline Float operator/(Float a, Float b) {
    return each([&](int i) { return a.lane[i] / b.lane[i]; });
}
static inline Float absolute(Float a) {
    return each([&](int i) { return __builtin_fabsf(a.lane[i]); });
}
// a, which is not negative, with the sign of b.
static inline Float with_sign_of(Float a, Float b) {
    return each([&](int i) { return __builtin_copysignf(a.lane[i], b.lane[i]); });
}
// The second operand when either is NaN, as the machine instructions have it.
static inline Float min(Float a, Float b) {
    return each([&](int i) { return a.lane[i] < b.lane[i] ? a.lane[i] : b.lane[i]; });
}
static inline Float max(Float a, Float b) {
    return each([&](int i) { return a.lane[i] > b.lane[i] ? a.lane[i] : b.lane[i]; });
}
static inline float least_of(Float a) {
    float least = a.lane[0];
    for (const float lane : a.lane) least = lane < least ? lane : least;
    return least;
}
// Fused or not as the ISA likes: for box tests alone, whose padding covers either rounding.
static inline Float about_fma(Float a, Float b, Float c) {
    return each([&](int i) { return a.lane[i] * b.lane[i] + c.lane[i]; });
}
static inline std::uint32_t less_equal_bits(Float a, Float b) {
    std::uint32_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= std::uint32_t{a.lane[i] <= b.lane[i]} << i;
    return bits;
}
// Lanes where a < 0 and b > 0.
static inline std::uint32_t opposite_bits(Float a, Float b) {
    std::uint32_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= std::uint32_t{a.lane[i] < 0.0f && b.lane[i] > 0.0f} << i;
    return bits;
}

struct Words {
    std::uint32_t lane[8];
};
static inline Words load(const std::uint32_t* p) {
    Words r;
    for (int i = 0; i < 8; ++i) r.lane[i] = p[i];
    return r;
}
// Eight words as the floats of the same bits.
static inline Float as_floats(Words a) {
    Float r;
    __builtin_memcpy(r.lane, a.lane, sizeof(r.lane));
    return r;
}
// The bits of eight floats.
static inline Words words_at(const float* p) {
    Words r;
    __builtin_memcpy(r.lane, p, sizeof(r.lane));
    return r;
}
static inline void store(std::uint32_t* p, Words a) {
    for (int i = 0; i < 8; ++i) p[i] = a.lane[i];
}
static inline Words splat(std::uint32_t a) {
    return {{a, a, a, a, a, a, a, a}};
}

// A value of every corner of a leaf, and whatever lies behind the last.
struct Row {
    float lane[16];
};
template <class Op>
static inline Row each_corner(Op op) {
    Row r;
    for (int i = 0; i < 16; ++i) r.lane[i] = op(i);
    return r;
}
static inline Row load_row(const float* p) {
    return each_corner([&](int i) { return p[i]; });
}
static inline Row splat_row(float a) {
    return each_corner([&](int) { return a; });
}
static inline Row operator-(const Row& a, const Row& b) {
    return each_corner([&](int i) { return a.lane[i] - b.lane[i]; });
}
static inline Row operator*(const Row& a, const Row& b) {
    return each_corner([&](int i) { return a.lane[i] * b.lane[i]; });
}
// Lane i: the value of the corner that the lowest four bits of `which` name.
static inline Float pick(const Row& row, Words which) {
    return each([&](int i) { return row.lane[which.lane[i] & 15u]; });
}
// The same where all that are named are among the first eight.
static inline Float pick_low(const Row& row, Words which) {
    return pick(row, which);
}
// Eight half words, and the highest bits of them.
static inline Words load_halves(const void* p) {
    std::uint16_t half[8];
    __builtin_memcpy(half, p, sizeof(half));
    Words r;
    for (int i = 0; i < 8; ++i) r.lane[i] = half[i];
    return r;
}
static inline std::uint32_t half_sign_bits(Words halves) {
    std::uint32_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= (halves.lane[i] >> 15 & 1u) << i;
    return bits;
}
static inline Words shift_right(Words a, int bits) {
    for (std::uint32_t& lane : a.lane) lane >>= bits;
    return a;
}

// Eight blocks of eight floats, `step` bytes apart, turned: out[i] holds the i-th of every block.
static inline void load_turned(const void* first, std::uint64_t step, Float out[8]) {
    for (std::uint64_t ray = 0; ray < 8; ++ray) {
        Float block;
        __builtin_memcpy(block.lane, static_cast<const char*>(first) + step * ray, sizeof(block.lane));
        for (int i = 0; i < 8; ++i) out[i].lane[ray] = block.lane[i];
    }
}

// The other way: the i-th lanes of four vectors become block i, sixteen bytes of every `step`.
static inline void store_turned(void* first, std::uint64_t step, Float a, Float b, Float c, Float d) {
    for (std::uint64_t i = 0; i < 8; ++i) {
        const float block[4] = {a.lane[i], b.lane[i], c.lane[i], d.lane[i]};
        __builtin_memcpy(static_cast<char*>(first) + step * i, block, sizeof(block));
    }
}

// Which lanes, for `where`.
struct Lanes {
    bool lane[8];
};
static inline Lanes lanes_of(std::uint32_t bits) {
    Lanes r;
    for (int i = 0; i < 8; ++i) r.lane[i] = (bits >> i & 1) != 0;
    return r;
}
static inline Lanes is_above(Float a, Float b) {
    Lanes r;
    for (int i = 0; i < 8; ++i) r.lane[i] = a.lane[i] > b.lane[i];
    return r;
}
static inline Lanes has_sign(Float a) {
    Lanes r;
    for (int i = 0; i < 8; ++i) r.lane[i] = __builtin_signbit(a.lane[i]) != 0;
    return r;
}
template <class Vector>
static inline Vector where(Lanes lanes, Vector yes, Vector no) {
    for (int i = 0; i < 8; ++i) no.lane[i] = lanes.lane[i] ? yes.lane[i] : no.lane[i];
    return no;
}

inline constexpr bool kHasWideDoubles = false;  // one register holds a Double
struct Double {
    double lane[8];
};
template <class Op>
static inline Double each_double(Op op) {
    Double r;
    for (int i = 0; i < 8; ++i) r.lane[i] = op(i);
    return r;
}
static inline Double load(const double* p) {
    return each_double([&](int i) { return p[i]; });
}
static inline void store(double* p, Double a) {
    for (int i = 0; i < 8; ++i) p[i] = a.lane[i];
}
static inline Double splat(double a) {
    return each_double([&](int) { return a; });
}
static inline Double widen(Float a) {
    return each_double([&](int i) { return double(a.lane[i]); });
}
static inline Float narrow(Double a) {
    return each([&](int i) { return float(a.lane[i]); });
}
static inline Double operator+(Double a, Double b) {
    return each_double([&](int i) { return a.lane[i] + b.lane[i]; });
}
static inline Double operator-(Double a, Double b) {
    return each_double([&](int i) { return a.lane[i] - b.lane[i]; });
}
static inline Double operator*(Double a, Double b) {
    return each_double([&](int i) { return a.lane[i] * b.lane[i]; });
}
static inline Double operator/(Double a, Double b) {
    return each_double([&](int i) { return a.lane[i] / b.lane[i]; });
}
static inline std::uint32_t not_negative_bits(Double a) {
    std::uint32_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= std::uint32_t{a.lane[i] >= 0} << i;
    return bits;
}
static inline std::uint32_t not_positive_bits(Double a) {
    std::uint32_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= std::uint32_t{a.lane[i] <= 0} << i;
    return bits;
}
// Leaves the lanes outside `bits` as they are.
template <class Word, class Vector>
static inline void store_where(Word* p, Vector a, std::uint32_t bits) {
    for (; bits != 0; bits &= bits - 1) p[__builtin_ctz(bits)] = a.lane[__builtin_ctz(bits)];
}
static inline std::uint32_t equal_bits(Words a, Words b) {
    std::uint32_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= std::uint32_t{a.lane[i] == b.lane[i]} << i;
    return bits;
}
static inline std::uint32_t above_bits(Words a, Words b) {
    std::uint32_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= std::uint32_t{a.lane[i] > b.lane[i]} << i;
    return bits;
}
// The lanes of `bits` side by side, in their order; what follows them means nothing.
template <class Vector>
static inline Vector compress(Vector a, std::uint32_t bits) {
    Vector r = a;
    for (int n = 0; bits != 0; bits &= bits - 1) r.lane[n++] = a.lane[__builtin_ctz(bits)];
    return r;
}
// The lane of `bits` that holds the least, the lowest of equals; 8 when `bits` is 0.
static inline std::uint32_t lane_of_least(Float a, std::uint32_t bits) {
    std::uint32_t best = 8;
    for (; bits != 0; bits &= bits - 1) {
        const auto lane = std::uint32_t(__builtin_ctz(bits));
        if (best == 8 || a.lane[lane] < a.lane[best]) best = lane;
    }
    return best;
}
// Lanes where a shares a bit with b.
static inline std::uint32_t common_bits(Words a, std::uint32_t b) {
    std::uint32_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= std::uint32_t{(a.lane[i] & b) != 0} << i;
    return bits;
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
