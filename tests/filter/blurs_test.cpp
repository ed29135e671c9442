// Blurs over one picture: what they keep, that they let nothing over an edge, and that each beats no filter.
#include "base/jobs.h"
#include "filter/albedo.h"
#include "filter/atrous.h"
#include "filter/bilateral.h"
#include "filter/gaussian.h"
#include "filter/mend.h"
#include "filter/planes.h"
#include "filter/synthetic.h"

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

TEST(Guides, AFloorForetellsTheNearnessOfItsNeighboursAtAnySlant) {
    const test::Frame frame = test::render({}, kWidth, kHeight, 3);  // jittered
    const filter::Guides guides = test::guides_of(frame.surfaces);
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
    EXPECT_LT(test::largest_difference(out, Plane3(33, 17, {0.5f, 2.0f, 7.0f})), 7e-6f);

    Plane3 point(65, 65);
    point.set(32, 32, glm::vec3(1.0f));
    filter::gaussian(point, 2.0f, jobs, out);
    EXPECT_NEAR(test::mean_of(out.x) * 65 * 65, 1.0, 1e-5);
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
    EXPECT_LT(test::largest_difference(out, Plane3(20, 20, glm::vec3(0.75f))), 1e-6f);
}

// Noise of known variance on two flat halves: every filter must come nearer to the truth than the noise is, and those
// that know of the edge nearer than the one that does not.
TEST(Blurs, AllBeatNoFilterAndThoseThatSeeTheEdgeBeatTheGaussian) {
    const Jobs jobs(2);
    const filter::GBuffer surfaces = test::stepped_wall(kWidth, kHeight);
    const filter::Guides guides = test::guides_of(surfaces);
    Plane3 truth(kWidth, kHeight), noisy(kWidth, kHeight);
    const Plane3 random = test::noise(kWidth, kHeight, 7);
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
    const filter::GBuffer surfaces = test::stepped_wall(kWidth, kHeight);
    const filter::Guides guides = test::guides_of(surfaces);
    Plane3 in(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x)
            in.set(x, y, x < kWidth / 2 ? glm::vec3(1.0f) : glm::vec3(0.0f, 0.0f, 64.0f));
    }
    Plane3 out;
    filter::cross_bilateral(in, guides, {}, {.sigma_px = 3.0f, .luminance = 0.0f}, jobs, out);
    EXPECT_LT(test::largest_difference(out, in), 1e-4f);
    filter::Signal signal, scratch[2];
    filter::make_signal(in, Plane(kWidth, kHeight, 1e6f), jobs,
                        signal);  // any light may mix, for all it knows
    filter::colour_from(filter::atrous(guides, view_of(signal), {.levels = 5}, jobs, scratch).light, jobs,
                        out);
    EXPECT_LT(test::largest_difference(out, in), 1e-4f);
}

TEST(Blurs, WhatIsNotANumberIsMendedAndGoesNoFurther) {
    const Jobs jobs(1);
    const filter::Guides guides = test::guides_of(test::stepped_wall(kWidth, kHeight));
    Plane3 in(kWidth, kHeight, glm::vec3(0.5f));
    in.set(20, 20, glm::vec3(kNan));
    in.set(60, 20, {kInf, 0.0f, 0.0f});
    in.set(0, 0, {0.0f, -3.0f, 0.0f});
    const Plane3 wanted(kWidth, kHeight, glm::vec3(0.5f));
    Plane3 out;
    filter::mend(in, {}, jobs, out);
    EXPECT_LT(test::largest_difference(out, wanted), 1e-6f);
    filter::bilateral(in, {}, jobs, out);
    EXPECT_LT(test::largest_difference(out, wanted), 1e-6f);
    Plane3 albedo = wanted;
    albedo.set(30, 30, glm::vec3(kNan));
    filter::cross_bilateral(in, guides, albedo, {}, jobs, out);
    EXPECT_LT(test::largest_difference(out, wanted), 1e-6f);
    Plane variance(kWidth, kHeight, 0.1f);
    variance.at(25, 25) = kNan;
    variance.at(26, 25) = -kInf;
    filter::Signal signal, scratch[2];
    filter::make_signal(in, variance, jobs, signal);
    filter::colour_from(filter::atrous(guides, view_of(signal), {}, jobs, scratch).light, jobs, out);
    EXPECT_LT(test::largest_difference(out, wanted), 1e-5f);
}

}  // namespace
}  // namespace gh
