// det_math against long double: a recording made on one machine is only true on another if these bits are.
#include "base/det_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace gh {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// Distance of `got` from the true value in units of the last place of floats of that size.
double error_ulp(float got, long double truth) {
    if (std::isnan(truth)) return std::isnan(got) ? 0.0 : 1e9;
    if (std::isnan(got)) return 1e9;
    // Beyond the largest float, the nearest one is infinity from half a unit on.
    constexpr long double kOverflow = 0x1.ffffffp127L;
    if (std::abs(truth) >= kOverflow)
        return got == std::copysign(kInfinity, static_cast<float>(truth)) ? 0.0 : 1e9;
    int exponent = 0;
    std::frexp(truth, &exponent);
    const int last_place = std::max(exponent - 24, -149);
    return static_cast<double>(std::abs(static_cast<long double>(got) - truth) /
                               std::ldexp(1.0L, last_place));
}

// Every float, in steps of a prime number of representations.
template <class F>
void for_many_floats(F&& f) {
    constexpr std::uint32_t kStep = 12'007;
    for (std::uint64_t bits = 0; bits <= 0xFFFFFFFFu; bits += kStep) {
        f(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    }
}

struct Worst {
    double error = 0.0;
    float at = 0.0f;
    void add(double e, float x) {
        if (e > error) {
            error = e;
            at = x;
        }
    }
};

template <class Ours, class Truth>
Worst worst_over_floats(Ours&& ours, Truth&& truth) {
    Worst worst;
    for_many_floats([&](float x) { worst.add(error_ulp(ours(x), truth(static_cast<long double>(x))), x); });
    return worst;
}

constexpr double kMaxUlp = 0.501;

#define EXPECT_ACCURATE(function)                                                              \
    do {                                                                                       \
        const Worst worst = worst_over_floats([](float x) { return det::function(x); },        \
                                              [](long double x) { return std::function(x); }); \
        EXPECT_LT(worst.error, kMaxUlp) << #function << " at " << worst.at;                    \
        RecordProperty(#function, std::to_string(worst.error));                                \
    } while (false)

TEST(DetMath, SineAndCosineAreTheNearestFloatAtEveryAngle) {
    EXPECT_ACCURATE(sin);
    EXPECT_ACCURATE(cos);
}

TEST(DetMath, TangentIsTheNearestFloatAtEveryAngle) {
    EXPECT_ACCURATE(tan);
}

TEST(DetMath, InverseFunctionsAreTheNearestFloat) {
    EXPECT_ACCURATE(asin);
    EXPECT_ACCURATE(acos);
    EXPECT_ACCURATE(atan);
}

TEST(DetMath, ExponentialsAreTheNearestFloat) {
    EXPECT_ACCURATE(exp);
    EXPECT_ACCURATE(exp2);
}

TEST(DetMath, LogarithmsAreTheNearestFloat) {
    EXPECT_ACCURATE(log);
    EXPECT_ACCURATE(log2);
    EXPECT_ACCURATE(log10);
}

// Floats close to multiples of a quarter turn, from 1 to the largest: where a reduction with too few digits
// of pi gives garbage.
TEST(DetMath, AnglesNextToQuarterTurnsKeepTheirDigits) {
    Worst worst;
    for (int octave = 0; octave < 128; ++octave) {
        const auto start = std::bit_cast<std::uint32_t>(std::ldexp(1.0f, octave));
        // Around the multiples of pi/2 themselves where floats are dense enough, all over the octave
        // elsewhere.
        for (std::uint32_t i = 0; i < 0x800000u; i += 16'001) {
            const float anywhere = std::bit_cast<float>(start + i);
            const long double quarter = 1.57079632679489661923132169163975144L;
            const auto multiple =
                static_cast<float>(std::round(static_cast<long double>(anywhere) / quarter) * quarter);
            for (const float x : {multiple, std::nextafter(multiple, 0.0f), anywhere}) {
                worst.add(error_ulp(det::sin(x), std::sin(static_cast<long double>(x))), x);
                worst.add(error_ulp(det::cos(x), std::cos(static_cast<long double>(x))), x);
            }
        }
    }
    EXPECT_LT(worst.error, kMaxUlp) << "at " << worst.at;
}

TEST(DetMath, AtanOfTwoArgumentsIsTheNearestFloatInEveryQuadrant) {
    Worst worst;
    for_many_floats([&](float y) {
        const float x = std::bit_cast<float>(std::bit_cast<std::uint32_t>(y) * 2654435761u);
        if (std::isnan(x)) return;
        worst.add(
            error_ulp(det::atan2(y, x), std::atan2(static_cast<long double>(y), static_cast<long double>(x))),
            y);
        const float close = y * 1.7f;  // ratios around one
        worst.add(error_ulp(det::atan2(y, close),
                            std::atan2(static_cast<long double>(y), static_cast<long double>(close))),
                  y);
    });
    EXPECT_LT(worst.error, kMaxUlp) << "y = " << worst.at;
}

TEST(DetMath, PowersAreTheNearestFloat) {
    Worst worst;
    for_many_floats([&](float base) {
        const std::uint32_t mixed = std::bit_cast<std::uint32_t>(base) * 2654435761u;
        const float any = std::bit_cast<float>(mixed);
        const float usual = static_cast<float>(mixed >> 8) * 0x1p-20f - 8.0f;  // in [-8, 8)
        const float whole = std::floor(usual);
        for (const float exponent : {any, usual, whole}) {
            const long double truth =
                std::pow(static_cast<long double>(base), static_cast<long double>(exponent));
            worst.add(error_ulp(det::pow(base, exponent), truth), base);
        }
        const float near_one = 1.0f + static_cast<float>(mixed & 0xFFu) * 0x1p-23f;
        const float large = static_cast<float>(mixed >> 4);
        worst.add(error_ulp(det::pow(near_one, large),
                            std::pow(static_cast<long double>(near_one), static_cast<long double>(large))),
                  near_one);
    });
    EXPECT_LT(worst.error, kMaxUlp) << "base " << worst.at;
}

TEST(DetMath, PolesSignedZerosAndInfinitiesAnswerAsInC) {
    const float special[] = {0.0f, -0.0f, 1.0f,   -1.0f,   0.5f,  -0.5f,  2.0f,      -2.0f,      3.0f, -3.0f,
                             2.5f, -2.5f, 1e-45f, -1e-45f, 3e38f, -3e38f, kInfinity, -kInfinity, kNaN};
    const auto same = [](float a, float b) {
        return std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
    };
    for (const float x : special) {
        EXPECT_TRUE(same(det::sin(x), static_cast<float>(std::sin(static_cast<double>(x))))) << x;
        EXPECT_TRUE(same(det::tan(x), static_cast<float>(std::tan(static_cast<double>(x))))) << x;
        EXPECT_TRUE(same(det::asin(x), static_cast<float>(std::asin(static_cast<double>(x))))) << x;
        EXPECT_TRUE(same(det::acos(x), static_cast<float>(std::acos(static_cast<double>(x))))) << x;
        EXPECT_TRUE(same(det::exp(x), static_cast<float>(std::exp(static_cast<double>(x))))) << x;
        EXPECT_TRUE(same(det::log(x), static_cast<float>(std::log(static_cast<double>(x))))) << x;
        for (const float y : special) {
            const auto xd = static_cast<double>(x), yd = static_cast<double>(y);
            EXPECT_TRUE(same(det::atan2(y, x), static_cast<float>(std::atan2(yd, xd)))) << y << ", " << x;
            EXPECT_TRUE(same(det::pow(x, y), static_cast<float>(std::pow(xd, yd)))) << x << " to the " << y;
        }
    }
}

// Guards turn by wrapped differences: one that comes out beyond half a turn sends them round the wrong way.
TEST(DetMath, AWrappedAngleIsTheSameDirectionWithinHalfATurn) {
    EXPECT_EQ(wrap_angle(1.0f), 1.0f);
    EXPECT_EQ(wrap_angle(kPi), kPi);
    EXPECT_EQ(wrap_angle(-kPi), -kPi);
    EXPECT_TRUE(std::isnan(wrap_angle(kInfinity)));
    for (int i = -20'000; i <= 20'000; ++i) {
        const float angle = static_cast<float>(i) * 0.37f;
        const float wrapped = wrap_angle(angle);
        ASSERT_LE(std::abs(wrapped), kPi);
        const long double truth =
            std::remainder(static_cast<long double>(angle), 2 * 3.14159265358979323846264338327950288L);
        // At half a turn either end is right.
        const long double off = std::abs(static_cast<long double>(wrapped) - truth);
        ASSERT_LT(std::min(off, std::abs(off - 6.28318530717958647692528676655900577L)), 2e-7L) << angle;
    }
}

// Changing one bit of these functions changes every recording.
TEST(DetMath, BitsAreThoseOfTheFirstDay) {
    std::uint64_t sum = 0;
    for_many_floats([&](float x) {
        for (const float y : {det::sin(x), det::cos(x), det::tan(x), det::atan(x), det::exp(x), det::log(x),
                              det::exp2(x), det::log2(x), det::pow(x, 1.37f), det::asin(x), det::acos(x)}) {
            const std::uint32_t bits = std::isnan(y) ? 0x7FC00000u : std::bit_cast<std::uint32_t>(y);
            sum = (sum ^ bits) * 0x100000001B3u;  // FNV-1a
        }
    });
    EXPECT_EQ(sum, 3146024823694228559u);
}

}  // namespace
}  // namespace gh
