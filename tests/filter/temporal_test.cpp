// What stands between a sample and its mean: the door it comes in by, the colour it falls on, the mean over frames.
#include "filter/temporal.h"

#include "filter/albedo.h"
#include "filter/mend.h"
#include "filter/planes.h"
#include "filter/variance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gh {
namespace {

using filter::Plane;
using filter::Plane3;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr int kWidth = 80, kHeight = 48;

TEST(Mend, ClampsALoneFireflyAndLeavesWhatIsDarkerThanTheFloorAlone) {
    const Jobs jobs(1);
    Plane3 in(20, 20, glm::vec3(0.5f));
    in.set(10, 10, {4000.0f, 2000.0f, 1000.0f});
    in.set(5, 5, glm::vec3(7.0f));
    Plane3 out;
    filter::mend(in, {.floor = 8.0f, .factor = 8.0f}, jobs, out);
    EXPECT_EQ(out.get(5, 5), glm::vec3(7.0f));
    EXPECT_NEAR(out.luminance_at(10, 10), 8.0f, 1e-3f);
    EXPECT_NEAR(out.x.at(10, 10) / out.z.at(10, 10), 4.0f, 1e-3f) << "its hue stays";
    // A lamp's face is bright all over: that is no firefly.
    const Plane3 lamp(20, 20, glm::vec3(900.0f));
    filter::mend(lamp, {.floor = 8.0f, .factor = 8.0f}, jobs, out);
    EXPECT_EQ(test::largest_difference(out, lamp), 0.0f);
}

TEST(Albedo, LightComesOutAsItWentInOverBlackAndWhiteToo) {
    const Jobs jobs(1);
    Plane3 light = test::noise(kWidth, kHeight, 3), albedo = test::noise(kWidth, kHeight, 4), apart, luma,
           out;
    albedo.set(3, 3, glm::vec3(0.0f));
    albedo.set(4, 4, {1.0f, kNan, -1.0f});
    filter::demodulate(light, albedo, jobs, apart);
    filter::luma_from(apart, jobs, luma);
    filter::remodulate({.direct = &luma}, albedo, jobs, out);
    // Green comes back from a luminance that a near-black red may have made a hundred times as large.
    EXPECT_LT(test::largest_difference(out, light), 3e-5f);
}

// One pixel's mean over n frames of independent samples has the n-th part of their variance, until the cap. Over 3840
// pixels the estimate of a variance is good to 2.3 % (one deviation); 10 % is four of them.
TEST(Temporal, StaticNoiseFallsAsOneOverTheNumberOfFramesUntilTheCap) {
    const Jobs jobs(2);
    const filter::Taps taps = test::taps_of_still_wall(kWidth, kHeight, jobs);
    filter::Accumulated mean, before;
    double variance_at_1 = 0.0;
    for (int n = 1; n <= 64; ++n) {
        std::swap(mean, before);
        filter::accumulate(test::noise(kWidth, kHeight, static_cast<std::uint64_t>(n)), {}, {taps, before},
                           {.longest = 16.0f}, jobs, mean);
        double sum = 0.0, squares = 0.0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const auto v = static_cast<double>(mean.light.x.at(x, y));
                sum += v;
                squares += v * v;
            }
        }
        const double count = kWidth * kHeight;
        const double variance = squares / count - sum / count * (sum / count);
        if (n == 1) variance_at_1 = variance;
        if (n == 4 || n == 16) {
            EXPECT_NEAR(variance / variance_at_1, 1.0 / n, 0.1 / n) << n;
        }
        // Then an exponential mean with share a = 1/16: a / (2 - a) = 1/31.
        if (n == 64) {
            EXPECT_NEAR(variance / variance_at_1, 1.0 / 31.0, 0.1 / 31.0);
        }
    }
    EXPECT_EQ(mean.length.at(7, 7), 16.0f);
}

TEST(Temporal, TheVarianceItFindsIsThatOfTheMeanWhetherFromTimeOrFromSpace) {
    const Jobs jobs(1);
    const filter::Taps taps = test::taps_of_still_wall(kWidth, kHeight, jobs);
    // Luminance of three uniform numbers: (0.2126^2 + 0.7152^2 + 0.0722^2) / 12.
    const double of_one = (0.2126 * 0.2126 + 0.7152 * 0.7152 + 0.0722 * 0.0722) / 12.0;
    filter::Accumulated mean, before;
    for (int n = 1; n <= 16; ++n) {
        std::swap(mean, before);
        filter::accumulate(test::noise(kWidth, kHeight, static_cast<std::uint64_t>(n)), {}, {taps, before},
                           {}, jobs, mean);
        Plane variance;
        filter::estimate_variance(mean, jobs, variance);
        // Twenty-five pixels underestimate by the share that their own mean takes, and few samples are doubted: twice.
        if (n == 1) {
            EXPECT_NEAR(test::mean_of(variance), 2.0 * of_one * 24.0 / 25.0, 0.1 * of_one);
        }
        if (n == 16) {
            EXPECT_NEAR(test::mean_of(variance), of_one / 16.0, 0.1 * of_one / 16.0);
        }
    }
}

}  // namespace
}  // namespace gh
