// Each stage by itself: what it promises in its header, on inputs whose answer is known.
#include "base/random.h"
#include "filter/albedo.h"
#include "filter/anti_lag.h"
#include "filter/atrous.h"
#include "filter/bilateral.h"
#include "filter/enlarge.h"
#include "filter/gaussian.h"
#include "filter/mend.h"
#include "filter/synthetic.h"
#include "filter/temporal.h"
#include "filter/variance.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gh {
namespace {

using filter::Plane;
using filter::Plane3;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr int kWidth = 80, kHeight = 48;

Plane3 noise(int width, int height, std::uint64_t seed) {
    Random random(seed);
    Plane3 out(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) out.set(x, y, {random.unit(), random.unit(), random.unit()});
    }
    return out;
}

double mean_of(const Plane& plane) {
    double sum = 0.0;
    for (int y = 0; y < plane.height(); ++y) {
        for (int x = 0; x < plane.width(); ++x) sum += static_cast<double>(plane.at(x, y));
    }
    return sum / (static_cast<double>(plane.width()) * plane.height());
}

float largest_difference(const Plane3& a, const Plane3& b) {
    float most = 0.0f;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const glm::vec3 off = glm::abs(a.get(x, y) - b.get(x, y));
            if (!(std::max({off.x, off.y, off.z}) <= most)) most = std::max({off.x, off.y, off.z});
        }
    }
    return most;
}

// A wall straight ahead at distance 2, its right half at distance 3: as surfaces, one picture high or twice that.
filter::GBuffer stepped_wall(int width, int height) {
    filter::GBuffer surfaces;
    surfaces.fit(width, height);
    const float pixel = 1.0f / static_cast<float>(height);
    const float left = -0.5f * static_cast<float>(width) * pixel;
    surfaces.lens = {.eye = glm::vec3(0.0f),
                     .corner = {left, 0.5f, -1.0f},
                     .right = {pixel, 0, 0},
                     .down = {0, -pixel, 0}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::vec3 d = surfaces.lens.corner + surfaces.lens.right * (static_cast<float>(x) + 0.5f) +
                                surfaces.lens.down * (static_cast<float>(y) + 0.5f);
            surfaces.position.set(x, y, d * (x < width / 2 ? 2.0f : 3.0f));
            surfaces.normal.set(x, y, {0.0f, 0.0f, 1.0f});
            surfaces.part.at(x, y) = x < width / 2 ? 1u : 2u;
        }
    }
    return surfaces;
}

filter::Guides guides_of(const filter::GBuffer& surfaces) {
    filter::Guides guides;
    filter::make_guides(surfaces, Jobs(1), guides);
    return guides;
}

TEST(Guides, AFloorForetellsTheNearnessOfItsNeighboursAtAnySlant) {
    const test::Frame frame = test::render({}, kWidth, kHeight, 3);  // jittered
    const filter::Guides guides = guides_of(frame.surfaces);
    int seen = 0;
    for (int y = 0; y + 1 < kHeight; ++y) {
        for (int x = 0; x + 1 < kWidth; ++x) {
            if (frame.surfaces.part.at(x, y) != test::kFloor ||
                frame.surfaces.part.at(x + 1, y) != test::kFloor ||
                frame.surfaces.part.at(x, y + 1) != test::kFloor) {
                continue;
            }
            const float here = guides.nearness.at(x, y);
            EXPECT_NEAR(guides.nearness.at(x + 1, y), here + guides.slope_x.at(x, y), 1e-4f * here);
            EXPECT_NEAR(guides.nearness.at(x, y + 1), here + guides.slope_y.at(x, y), 1e-4f * here);
            ++seen;
        }
    }
    EXPECT_GT(seen, 200);
}

TEST(Gaussian, KeepsAConstantAndTheEnergyAndSpreadsAPointLikeTheBell) {
    const Jobs jobs(2);
    Plane3 out;
    filter::gaussian(Plane3(33, 17, {0.5f, 2.0f, 7.0f}), 3.0f, jobs, out);
    EXPECT_LT(largest_difference(out, Plane3(33, 17, {0.5f, 2.0f, 7.0f})), 7e-6f);

    Plane3 point(65, 65);
    point.set(32, 32, glm::vec3(1.0f));
    filter::gaussian(point, 2.0f, jobs, out);
    EXPECT_NEAR(mean_of(out.x) * 65 * 65, 1.0, 1e-5);
    // Sampled and cut off at three sigma: exp(-1/8) and exp(-9/8) of the middle.
    EXPECT_NEAR(out.x.at(33, 32) / out.x.at(32, 32), std::exp(-0.125f), 1e-5f);
    EXPECT_NEAR(out.x.at(32, 35) / out.x.at(32, 32), std::exp(-1.125f), 1e-5f);
}

TEST(Gaussian, FillsInWhatIsNotANumber) {
    Plane3 in(20, 20, glm::vec3(0.75f));
    in.set(10, 10, {kNan, 1.0f, 1.0f});
    in.set(0, 0, {1.0f, kInf, 1.0f});
    Plane3 out;
    filter::gaussian(in, 1.5f, Jobs(1), out);
    EXPECT_LT(largest_difference(out, Plane3(20, 20, glm::vec3(0.75f))), 1e-6f);
}

// Noise of known variance on two flat halves: every filter must come nearer to the truth than the noise is, and those
// that know of the edge nearer than the one that does not.
TEST(Blurs, AllBeatNoFilterAndThoseThatSeeTheEdgeBeatTheGaussian) {
    const Jobs jobs(2);
    const filter::GBuffer surfaces = stepped_wall(kWidth, kHeight);
    const filter::Guides guides = guides_of(surfaces);
    Plane3 truth(kWidth, kHeight), noisy(kWidth, kHeight);
    const Plane3 random = noise(kWidth, kHeight, 7);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            truth.set(x, y, glm::vec3(x < kWidth / 2 ? 0.4f : 1.6f));
            noisy.set(x, y, truth.get(x, y) * (0.5f + random.get(x, y)));
        }
    }
    const double none = test::rel_mse(noisy, truth);
    Plane3 out;
    filter::gaussian(noisy, 2.0f, jobs, out);
    const double gaussian = test::rel_mse(out, truth);
    filter::bilateral(noisy, {.sigma_px = 2.0f, .luminance = 0.8f}, jobs, out);
    const double bilateral = test::rel_mse(out, truth);
    filter::cross_bilateral(noisy, guides, {}, {.sigma_px = 2.0f, .luminance = 0.0f}, jobs, out);
    const double by_guides = test::rel_mse(out, truth);
    filter::cross_bilateral(noisy, guides, truth, {.sigma_px = 2.0f, .luminance = 0.0f, .albedo = 0.3f}, jobs,
                            out);
    const double by_albedo = test::rel_mse(out, truth);
    filter::Signal signal, scratch[2];
    filter::make_signal(noisy, Plane(kWidth, kHeight, 0.05f), jobs, signal);
    filter::colour_from(filter::atrous(guides, view_of(signal), {.levels = 3}, jobs, scratch).light, jobs,
                        out);
    const double atrous = test::rel_mse(out, truth);
    EXPECT_LT(gaussian, 0.5 * none);
    EXPECT_LT(bilateral, 0.3 * none);
    // Gaussian weights cut off by falloff() average more than 12 pixels: a twelfth of the variance is left at most.
    EXPECT_LT(by_guides, none / 12.0);
    EXPECT_LT(by_albedo, none / 12.0);
    EXPECT_LT(by_guides, 0.5 * gaussian);
    EXPECT_LT(atrous, none / 20.0);
}

TEST(Blurs, NothingCrossesAStepInDepth) {
    const Jobs jobs(1);
    const filter::GBuffer surfaces = stepped_wall(kWidth, kHeight);
    const filter::Guides guides = guides_of(surfaces);
    Plane3 in(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x)
            in.set(x, y, x < kWidth / 2 ? glm::vec3(1.0f) : glm::vec3(0.0f, 0.0f, 64.0f));
    }
    Plane3 out;
    filter::cross_bilateral(in, guides, {}, {.sigma_px = 3.0f, .luminance = 0.0f}, jobs, out);
    EXPECT_LT(largest_difference(out, in), 1e-4f);
    filter::Signal signal, scratch[2];
    filter::make_signal(in, Plane(kWidth, kHeight, 1e6f), jobs,
                        signal);  // any light may mix, for all it knows
    filter::colour_from(filter::atrous(guides, view_of(signal), {.levels = 5}, jobs, scratch).light, jobs,
                        out);
    EXPECT_LT(largest_difference(out, in), 1e-4f);
}

TEST(Blurs, WhatIsNotANumberIsMendedAndGoesNoFurther) {
    const Jobs jobs(1);
    const filter::Guides guides = guides_of(stepped_wall(kWidth, kHeight));
    Plane3 in(kWidth, kHeight, glm::vec3(0.5f));
    in.set(20, 20, glm::vec3(kNan));
    in.set(60, 20, {kInf, 0.0f, 0.0f});
    in.set(0, 0, {0.0f, -3.0f, 0.0f});
    const Plane3 wanted(kWidth, kHeight, glm::vec3(0.5f));
    Plane3 out;
    filter::mend(in, {}, jobs, out);
    EXPECT_LT(largest_difference(out, wanted), 1e-6f);
    filter::bilateral(in, {}, jobs, out);
    EXPECT_LT(largest_difference(out, wanted), 1e-6f);
    Plane3 albedo = wanted;
    albedo.set(30, 30, glm::vec3(kNan));
    filter::cross_bilateral(in, guides, albedo, {}, jobs, out);
    EXPECT_LT(largest_difference(out, wanted), 1e-6f);
    Plane variance(kWidth, kHeight, 0.1f);
    variance.at(25, 25) = kNan;
    variance.at(26, 25) = -kInf;
    filter::Signal signal, scratch[2];
    filter::make_signal(in, variance, jobs, signal);
    filter::colour_from(filter::atrous(guides, view_of(signal), {}, jobs, scratch).light, jobs, out);
    EXPECT_LT(largest_difference(out, wanted), 1e-5f);
}

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
    EXPECT_EQ(largest_difference(out, lamp), 0.0f);
}

TEST(Albedo, LightComesOutAsItWentInOverBlackAndWhiteToo) {
    const Jobs jobs(1);
    Plane3 light = noise(kWidth, kHeight, 3), albedo = noise(kWidth, kHeight, 4), apart, luma, out;
    albedo.set(3, 3, glm::vec3(0.0f));
    albedo.set(4, 4, {1.0f, kNan, -1.0f});
    filter::demodulate(light, albedo, jobs, apart);
    filter::luma_from(apart, jobs, luma);
    filter::remodulate({.direct = &luma}, albedo, jobs, out);
    // Green comes back from a luminance that a near-black red may have made a hundred times as large.
    EXPECT_LT(largest_difference(out, light), 3e-5f);
}

// One pixel's mean over n frames of independent samples has the n-th part of their variance, until the cap. Over 3840
// pixels the estimate of a variance is good to 2.3 % (one deviation); 10 % is four of them.
TEST(Temporal, StaticNoiseFallsAsOneOverTheNumberOfFramesUntilTheCap) {
    const Jobs jobs(2);
    filter::GBuffer surfaces = stepped_wall(kWidth, kHeight);
    const filter::Guides guides = guides_of(surfaces);
    const filter::SeenSurfaces seen{surfaces.lens, guides, surfaces.part};
    filter::Taps taps;
    filter::reproject(surfaces, guides, seen, filter::Motion::OfSurface, jobs, taps);
    filter::Accumulated mean, before;
    double variance_at_1 = 0.0;
    for (int n = 1; n <= 64; ++n) {
        std::swap(mean, before);
        filter::accumulate(noise(kWidth, kHeight, static_cast<std::uint64_t>(n)), {}, taps, before,
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
    filter::GBuffer surfaces = stepped_wall(kWidth, kHeight);
    const filter::Guides guides = guides_of(surfaces);
    const filter::SeenSurfaces seen{surfaces.lens, guides, surfaces.part};
    filter::Taps taps;
    filter::reproject(surfaces, guides, seen, filter::Motion::OfSurface, jobs, taps);
    // Luminance of three uniform numbers: (0.2126^2 + 0.7152^2 + 0.0722^2) / 12.
    const double of_one = (0.2126 * 0.2126 + 0.7152 * 0.7152 + 0.0722 * 0.0722) / 12.0;
    filter::Accumulated mean, before;
    for (int n = 1; n <= 16; ++n) {
        std::swap(mean, before);
        filter::accumulate(noise(kWidth, kHeight, static_cast<std::uint64_t>(n)), {}, taps, before, {}, jobs,
                           mean);
        Plane variance;
        filter::estimate_variance(mean, guides, jobs, variance);
        // Nine pixels underestimate by the ninth that their own mean takes.
        if (n == 1) {
            EXPECT_NEAR(mean_of(variance), of_one * 8.0 / 9.0, 0.1 * of_one);
        }
        if (n == 16) {
            EXPECT_NEAR(mean_of(variance), of_one / 16.0, 0.1 * of_one / 16.0);
        }
    }
}

TEST(AntiLag, ChangeIsTheShareOfTheLightThatIsNew) {
    const Jobs jobs(1);
    Plane now(8, 1), then(8, 1), change;
    const float pairs[8][3] = {{0, 0, 0},     {1, 1, 0},     {0, 5, 1},    {5, 0, 1},
                               {1, 4, 0.75f}, {4, 1, 0.75f}, {kNan, 1, 0}, {kInf, 1, 0}};
    for (int x = 0; x < 8; ++x) {
        now.at(x, 0) = pairs[x][0];
        then.at(x, 0) = pairs[x][1];
    }
    filter::lamp_change(now, then, jobs, change);
    for (int x = 0; x < 8; ++x) EXPECT_EQ(change.at(x, 0), pairs[x][2]) << x;
}

TEST(AntiLag, GradientsFindALampThatWentOutAndNoChangeInNoise) {
    const Jobs jobs(1);
    filter::Reshaded samples{Plane(30, 20), Plane(30, 20), 3};
    Random random(5);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 30; ++x) {
            const float light = random.unit();
            samples.then.at(x, y) = light;  // the same sample, shaded twice
            samples.now.at(x, y) = x < 15 ? light : 0.0f;
        }
    }
    Plane change;
    filter::gradients(samples, 90, 60, jobs, change);
    EXPECT_EQ(change.at(10, 30), 0.0f);
    EXPECT_EQ(change.at(80, 30), 1.0f);
}

TEST(AntiLag, SettlingLeavesSteadyNoiseAloneAndPullsAStaleMeanDown) {
    const Jobs jobs(1);
    filter::GBuffer surfaces = stepped_wall(kWidth, kHeight);
    const filter::Guides guides = guides_of(surfaces);
    const filter::SeenSurfaces seen{surfaces.lens, guides, surfaces.part};
    filter::Taps taps;
    filter::reproject(surfaces, guides, seen, filter::Motion::OfSurface, jobs, taps);
    filter::Accumulated mean, before;
    Plane sums[2];
    for (int n = 1; n <= 32; ++n) {
        std::swap(mean, before);
        filter::accumulate(noise(kWidth, kHeight, static_cast<std::uint64_t>(n)), {}, taps, before, {}, jobs,
                           mean);
        filter::settle({}, jobs, mean, sums);
    }
    EXPECT_NEAR(mean_of(mean.light.y), 0.5, 0.005);
    EXPECT_GT(mean_of(mean.length), 30.0);
    for (int n = 0; n < 3; ++n) {
        std::swap(mean, before);
        filter::accumulate(Plane3(kWidth, kHeight), {}, taps, before, {}, jobs, mean);
        filter::settle({}, jobs, mean, sums);
    }
    EXPECT_LT(mean_of(mean.light.y), 0.2) << "without settling it were 0.5 (31/32)^3 = 0.45";
    EXPECT_LT(mean_of(mean.length), 15.0);
}

TEST(Enlarge, KeepsAConstantAtEveryRatioAndOvershootsNowhere) {
    const Jobs jobs(2);
    for (const auto& [width, height] :
         {std::pair(26, 14), std::pair(13, 7), std::pair(100, 31), std::pair(17, 8)}) {
        Plane3 out(width, height);
        filter::enlarge(Plane3(13, 7, {0.25f, 1.5f, 30.0f}), jobs, out);
        EXPECT_LT(largest_difference(out, Plane3(width, height, {0.25f, 1.5f, 30.0f})), 1e-4f);
    }
    Plane3 step(16, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 8; x < 16; ++x) step.set(x, y, glm::vec3(1.0f));
    }
    step.set(12, 4, glm::vec3(kNan));
    Plane3 out(41, 37);
    filter::enlarge(step, jobs, out);
    for (int y = 0; y < 37; ++y) {
        for (int x = 0; x < 41; ++x) ASSERT_TRUE(out.x.at(x, y) >= 0.0f && out.x.at(x, y) <= 1.0f);
    }
    EXPECT_EQ(out.x.at(40, 36), 1.0f);
    EXPECT_EQ(out.x.at(0, 0), 0.0f);
}

// A ramp is what linear interpolation gets right; the cubic too, but at the borders it has less to go on.
TEST(Enlarge, PutsARampWhereItBelongs) {
    Plane3 ramp(32, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 32; ++x) ramp.set(x, y, glm::vec3(static_cast<float>(x)));
    }
    Plane3 out(77, 19);
    filter::enlarge(ramp, Jobs(1), out);
    for (int x = 8; x < 69; ++x) {
        EXPECT_NEAR(out.x.at(x, 9), (static_cast<float>(x) + 0.5f) * 32.0f / 77.0f - 0.5f, 0.02f) << x;
    }
}

TEST(Enlarge, WithTheLargeSurfacesKnownAnEdgeIsAsSharpAsTheyAre) {
    const Jobs jobs(1);
    // The step lies in the middle of a small pixel column: 21 is odd.
    const int width = 21, height = 12;
    filter::GBuffer small = stepped_wall(width, height), large = stepped_wall(2 * width, 2 * height);
    const filter::Guides small_guides = guides_of(small), large_guides = guides_of(large);
    Plane3 in(width, height), wanted(2 * width, 2 * height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) in.set(x, y, glm::vec3(small.part.at(x, y) == 1 ? 1.0f : 0.0f));
    }
    for (int y = 0; y < 2 * height; ++y) {
        for (int x = 0; x < 2 * width; ++x)
            wanted.set(x, y, glm::vec3(large.part.at(x, y) == 1 ? 1.0f : 0.0f));
    }
    Plane3 joint, plain(2 * width, 2 * height);
    filter::joint_enlarge(in, small_guides, large_guides, jobs, joint);
    filter::enlarge(in, jobs, plain);
    EXPECT_LT(largest_difference(joint, wanted), 1e-3f);
    EXPECT_GT(largest_difference(plain, wanted), 0.4f) << "the test's edge is no challenge";
}

}  // namespace
}  // namespace gh
