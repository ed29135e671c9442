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

}  // namespace
}  // namespace gh
