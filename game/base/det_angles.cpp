// Sines, cosines and tangents of det_math: an angle is brought into [-pi/4, pi/4], where a short series does.
#include "base/det_constants.h"
#include "base/det_math.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace gh {

namespace {

constexpr double kTwoOverPi = 0.63661977236758134308;

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

}  // namespace det
}  // namespace gh
