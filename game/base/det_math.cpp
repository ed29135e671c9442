#include "base/det_math.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace gh {

namespace {

constexpr double kPiD = 3.14159265358979323846;
constexpr double kHalfPiD = 1.57079632679489661923;
constexpr double kTwoOverPi = 0.63661977236758134308;
constexpr double kLn2 = 0.69314718055994530942;
constexpr double kLog2E = 1.44269504088896340736;
constexpr double kLog10Of2 = 0.30102999566398119521;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

bool is_finite(float x) {
    return std::abs(x) < std::numeric_limits<float>::infinity();
}

// An angle as quarter turns, modulo 4, and a rest within pi/4 of zero (rounding aside).
struct Reduced {
    double rest;
    unsigned quarter;
};

// The first 256 binary digits of 2/pi.
constexpr std::array<std::uint32_t, 8> kTwoOverPiDigits = {
    0xA2F9836Eu, 0x4E441529u, 0xFC2757D1u, 0xF534DDC0u, 0xDB629599u, 0x3C439041u, 0xFE5163ABu, 0xDEBBC561u};

// 32 digits of 2/pi from digit `at` on.
std::uint32_t two_over_pi_digits(unsigned at) {
    const std::uint64_t pair =
        (std::uint64_t{kTwoOverPiDigits[at / 32]} << 32) | kTwoOverPiDigits[at / 32 + 1];
    return static_cast<std::uint32_t>((pair << (at % 32)) >> 32);
}

// For 2^25 <= x < infinity (Payne and Hanek 1983). x is m * 2^e with m an integer of 24 bits, e >= 2. Digits
// of 2/pi whose weight times x is a multiple of 4 turn whole circles and are skipped; m times the next 64
// gives quarter turns as 2 + 62 binary digits (what overflows is whole circles again), and 32 more digits
// refine the end.
Reduced reduce_large(float x) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(x);
    const std::uint64_t m = (bits & 0x7FFFFFu) | 0x800000u;
    const unsigned skipped = (bits >> 23) - 127 - 23 - 2;

    const std::uint64_t digits =
        (std::uint64_t{two_over_pi_digits(skipped)} << 32) | two_over_pi_digits(skipped + 32);
    const std::uint64_t tail = m * two_over_pi_digits(skipped + 64);
    std::uint64_t quarters = m * digits + (tail >> 32);

    const std::uint64_t rounded = quarters + (std::uint64_t{1} << 61);
    const auto quarter = static_cast<unsigned>(rounded >> 62);
    quarters -= std::uint64_t{quarter} << 62;  // now in [-1/2, 1/2) as two's complement
    const double fraction = static_cast<double>(static_cast<std::int64_t>(quarters)) +
                            static_cast<double>(tail & 0xFFFFFFFFu) * 0x1p-32;
    return {fraction * 0x1p-62 * kHalfPiD, quarter};
}

// For finite x. Below 2^25, k * pi/2 is subtracted in three parts (Cody and Waite 1980); the first two have
// 26 digits, so that their products with k, at most 2^25, are exact.
Reduced reduce(float x) {
    if (std::abs(x) >= 0x1p25f) {
        const Reduced positive = reduce_large(std::abs(x));
        return x > 0.0f ? positive : Reduced{-positive.rest, (4 - positive.quarter) & 3u};
    }
    constexpr double kPart1 = 0x1.921fb5p+0;
    constexpr double kPart2 = 0x1.110b46p-26;
    constexpr double kPart3 = 0x1.1a62633145c07p-54;
    const double k = std::floor(static_cast<double>(x) * kTwoOverPi + 0.5);
    const double rest = ((static_cast<double>(x) - k * kPart1) - k * kPart2) - k * kPart3;
    return {rest, static_cast<unsigned>(static_cast<std::int64_t>(k)) & 3u};
}

// Taylor series on [-pi/4, pi/4]: the first term left out is below 3e-14 of the value.
double sin_near_zero(double r) {
    const double z = r * r;
    double sum = 1.0 / 6227020800.0;
    sum = sum * z - 1.0 / 39916800.0;
    sum = sum * z + 1.0 / 362880.0;
    sum = sum * z - 1.0 / 5040.0;
    sum = sum * z + 1.0 / 120.0;
    sum = sum * z - 1.0 / 6.0;
    return r + r * z * sum;
}

double cos_near_zero(double r) {
    const double z = r * r;
    double sum = -1.0 / 87178291200.0;
    sum = sum * z + 1.0 / 479001600.0;
    sum = sum * z - 1.0 / 3628800.0;
    sum = sum * z + 1.0 / 40320.0;
    sum = sum * z - 1.0 / 720.0;
    sum = sum * z + 1.0 / 24.0;
    return 1.0 - 0.5 * z + z * z * sum;
}

double sin_of(const Reduced& angle) {
    const double value = angle.quarter % 2 == 0 ? sin_near_zero(angle.rest) : cos_near_zero(angle.rest);
    return angle.quarter < 2 ? value : -value;
}

double cos_of(const Reduced& angle) {
    return sin_of({angle.rest, (angle.quarter + 1) % 4});
}

// atan(k/8).
constexpr std::array<double, 9> kAtanOfEighths = {
    0x0.0p+0,
    0x1.fd5ba9aac2f6ep-4,
    0x1.f5b75f92c80ddp-3,
    0x1.6f61941e4def1p-2,
    0x1.dac670561bb4fp-2,
    0x1.1e00babdefeb4p-1,
    0x1.4978fa3269ee1p-1,
    0x1.700a7c5784634p-1,
    0x1.921fb54442d18p-1,
};

// For q in [0, 1]: from the nearest eighth c, atan q = atan c + atan((q - c) / (1 + q c)), the latter within
// 1/16.
double atan_below_one(double q) {
    const double nearest = std::floor(q * 8.0 + 0.5);
    const double c = nearest * 0.125;
    const double r = (q - c) / (1.0 + q * c);
    const double z = r * r;
    double sum = 1.0 / 9.0;
    sum = sum * z - 1.0 / 7.0;
    sum = sum * z + 1.0 / 5.0;
    sum = sum * z - 1.0 / 3.0;
    return kAtanOfEighths[static_cast<std::size_t>(nearest)] + (r + r * z * sum);
}

// Neither is NaN.
double atan2_of(double y, double x) {
    double larger = std::abs(x);
    double smaller = std::abs(y);
    const bool is_steep = smaller > larger;
    if (is_steep) std::swap(larger, smaller);

    double ratio = 0.0;
    if (std::isinf(smaller)) {
        ratio = 1.0;
    } else if (larger > 0.0) {
        ratio = smaller / larger;
    }
    double angle = atan_below_one(ratio);
    if (is_steep) angle = kHalfPiD - angle;
    if (std::signbit(x)) angle = kPiD - angle;
    return std::copysign(angle, y);
}

// For finite x > 0, a double that was a float: never subnormal. x = 2^e * m with m in [sqrt(1/2), sqrt(2)),
// and ln m = 2 artanh(s) with s = (m - 1) / (m + 1), within 0.172 of zero.
double log2_of(double x) {
    constexpr std::uint64_t kSqrtHalfBits = 0x3FE6A09E667F3BCDu;
    constexpr std::uint64_t kExponentMask = 0xFFF0000000000000u;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t above = bits - kSqrtHalfBits;
    const double m = std::bit_cast<double>(bits - (above & kExponentMask));
    const auto e = static_cast<double>(static_cast<std::int64_t>(above & kExponentMask) >> 52);

    const double s = (m - 1.0) / (m + 1.0);
    const double z = s * s;
    double sum = 1.0 / 17.0;
    for (const double coefficient :
         {1.0 / 15.0, 1.0 / 13.0, 1.0 / 11.0, 1.0 / 9.0, 1.0 / 7.0, 1.0 / 5.0, 1.0 / 3.0}) {
        sum = sum * z + coefficient;
    }
    return e + (2.0 * kLog2E) * (s + s * z * sum);
}

// 1/n!
constexpr std::array<double, 12> kInverseFactorials = {
    1.0,         1.0,          1.0 / 2.0,     1.0 / 6.0,      1.0 / 24.0,      1.0 / 120.0,
    1.0 / 720.0, 1.0 / 5040.0, 1.0 / 40320.0, 1.0 / 362880.0, 1.0 / 3628800.0, 1.0 / 39916800.0,
};

// For any t but NaN; what lies beyond a float's range comes out as 2^+-200, which rounds to infinity or zero.
double exp2_of(double t) {
    t = t < -200.0 ? -200.0 : (t > 200.0 ? 200.0 : t);
    const double k = std::floor(t + 0.5);
    const double r = (t - k) * kLn2;  // within 0.347 of zero; the first term left out is below 1e-14
    double sum = kInverseFactorials[11];
    for (std::size_t n = 11; n-- > 0;) sum = sum * r + kInverseFactorials[n];
    const double scale =
        std::bit_cast<double>(static_cast<std::uint64_t>(static_cast<std::int64_t>(k) + 1023) << 52);
    return sum * scale;
}

// log2 with the poles; for the three bases.
double log2_or_pole(float x) {
    if (x > 0.0f) return std::isinf(x) ? static_cast<double>(x) : log2_of(static_cast<double>(x));
    if (x == 0.0f) return -std::numeric_limits<double>::infinity();
    return static_cast<double>(kNaN);
}

bool is_integer(double x) {
    return std::floor(x) == x;
}
bool is_odd_integer(double x) {
    return is_integer(x) && !is_integer(x * 0.5);
}

}  // namespace

float wrap_angle(float radians) {
    if (std::abs(radians) <= kPi) return radians;
    if (!is_finite(radians)) return kNaN;
    const Reduced angle = reduce(radians);
    constexpr std::array<double, 4> kQuarters = {0.0, kHalfPiD, kPiD, -kHalfPiD};
    double wrapped = kQuarters[angle.quarter] + angle.rest;
    if (wrapped > kPiD) wrapped -= 2.0 * kPiD;
    return static_cast<float>(wrapped);
}

namespace det {

SinCos sin_cos(float radians) {
    if (!is_finite(radians)) return {kNaN, kNaN};
    if (radians == 0.0f) return {radians, 1.0f};  // keeps -0
    const Reduced angle = reduce(radians);
    return {static_cast<float>(sin_of(angle)), static_cast<float>(cos_of(angle))};
}

float sin(float radians) {
    if (!is_finite(radians)) return kNaN;
    return radians == 0.0f ? radians : static_cast<float>(sin_of(reduce(radians)));
}

float cos(float radians) {
    return is_finite(radians) ? static_cast<float>(cos_of(reduce(radians))) : kNaN;
}

float tan(float radians) {
    if (!is_finite(radians)) return kNaN;
    if (radians == 0.0f) return radians;
    const Reduced angle = reduce(radians);
    return static_cast<float>(sin_of(angle) / cos_of(angle));
}

float asin(float x) {
    if (!(std::abs(x) <= 1.0f)) return kNaN;
    const auto sine = static_cast<double>(x);
    return static_cast<float>(atan2_of(sine, std::sqrt((1.0 - sine) * (1.0 + sine))));
}

float acos(float x) {
    if (!(std::abs(x) <= 1.0f)) return kNaN;
    const auto cosine = static_cast<double>(x);
    return static_cast<float>(atan2_of(std::sqrt((1.0 - cosine) * (1.0 + cosine)), cosine));
}

float atan(float x) {
    return atan2(x, 1.0f);
}

float atan2(float y, float x) {
    if (std::isnan(y) || std::isnan(x)) return kNaN;
    return static_cast<float>(atan2_of(static_cast<double>(y), static_cast<double>(x)));
}

float exp(float x) {
    if (std::isnan(x)) return kNaN;
    return static_cast<float>(exp2_of(static_cast<double>(x) * kLog2E));
}

float exp2(float x) {
    if (std::isnan(x)) return kNaN;
    return static_cast<float>(exp2_of(static_cast<double>(x)));
}

float log(float x) {
    return static_cast<float>(log2_or_pole(x) * kLn2);
}

float log2(float x) {
    return static_cast<float>(log2_or_pole(x));
}

float log10(float x) {
    return static_cast<float>(log2_or_pole(x) * kLog10Of2);
}

float pow(float base, float exponent) {
    if (exponent == 0.0f || base == 1.0f) return 1.0f;  // even where the other is NaN, as in C
    if (std::isnan(base) || std::isnan(exponent)) return kNaN;

    const auto y = static_cast<double>(exponent);
    const float size = std::abs(base);
    const bool is_root_of_negative = base < 0.0f && !std::isinf(base) && !is_integer(y);
    if (is_root_of_negative) return kNaN;
    const double magnitude = size == 1.0f ? 1.0 : exp2_of(y * log2_or_pole(size));
    const bool is_negative = std::signbit(base) && !std::isinf(exponent) && is_odd_integer(y);
    return static_cast<float>(is_negative ? -magnitude : magnitude);
}

}  // namespace det
}  // namespace gh
