// Arcs, exponentials and logarithms of det_math; det_angles.cpp has the rest.
#include "base/det_math.h"

#include "base/det_constants.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace gh {

namespace {

constexpr double kLn2 = 0.69314718055994530942;
constexpr double kLog2E = 1.44269504088896340736;
constexpr double kLog10Of2 = 0.30102999566398119521;

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

namespace det {

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
