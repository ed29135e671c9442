// Metrics are judges: each is held against values worked out by hand and against what it must do by its definition.
#include "metrics/picture_metrics.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using gh::Image;

Image constant(int width, int height, const glm::vec3& value) {
    Image image(width, height);
    for (glm::vec3& pixel : image.pixels) pixel = value;
    return image;
}

Image checkered(int side, float low, float high) {
    Image image(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) image.at(x, y) = glm::vec3(((x / 4 + y / 4) & 1) != 0 ? high : low);
    }
    return image;
}

TEST(RelMse, IsTheMeanOfWhatTheFormulaSays) {
    Image reference = constant(10, 1, glm::vec3(1.0f)), picture = reference;
    picture.at(3, 0) = glm::vec3(1.5f);
    // One pixel of ten errs by 0.5: 0.25 / 1.01 / 10.
    EXPECT_NEAR(metrics::rel_mse(picture, reference).all, 0.25 / 1.01 / 10.0, 1e-9);
    EXPECT_EQ(metrics::rel_mse(reference, reference).all, 0.0);
    reference.at(0, 0) = glm::vec3(0.0f);
    picture.at(0, 0) = {0.1f, 0.0f, 0.0f};  // in the dark the floor takes over: 0.01 / 0.01 / 3 channels
    EXPECT_NEAR(metrics::rel_mse(picture, reference).all, (0.25 / 1.01 + 1.0 / 3.0) / 10.0, 1e-7);
}

TEST(RelMse, TrimsTheWorstThousandthAndCountsWhatIsNotANumber) {
    Image reference = constant(100, 20, glm::vec3(1.0f)), picture = constant(100, 20, glm::vec3(1.1f));
    picture.at(5, 5) = glm::vec3(1000.0f);
    picture.at(6, 6) = glm::vec3(2000.0f);
    metrics::RelMse error = metrics::rel_mse(picture, reference);
    EXPECT_NEAR(error.trimmed, 0.01 / 1.01, 1e-6);
    EXPECT_GT(error.all, 1000.0);
    picture.at(7, 7) = glm::vec3(std::numeric_limits<float>::quiet_NaN());
    error = metrics::rel_mse(picture, reference);
    EXPECT_EQ(error.not_finite, 1u);
    EXPECT_TRUE(std::isfinite(error.all));
}

TEST(Ssim, IsOneForItselfAndWorksOutByHandForConstants) {
    const Image board = checkered(48, 0.2f, 0.8f);
    EXPECT_NEAR(metrics::ssim(board, board), 1.0, 1e-12);
    // No variance: only the first factor is left, (2 a b + C1) / (a^2 + b^2 + C1).
    const double a = 0.5f, b = 0.25f;
    EXPECT_NEAR(metrics::ssim(constant(32, 32, glm::vec3(0.5f)), constant(32, 32, glm::vec3(0.25f))),
                (2.0 * a * b + 1e-4) / (a * a + b * b + 1e-4), 1e-9);
    EXPECT_LT(metrics::ssim(board, checkered(48, 0.8f, 0.2f)), -0.5)
        << "an inverted picture is anticorrelated";
}

TEST(Ssim, NoiseMakesItLessTheMoreThereIs) {
    test::Random random(3);
    const Image board = checkered(48, 0.3f, 0.7f);
    double before = 1.0;
    for (const float strength : {0.05f, 0.1f, 0.2f, 0.4f}) {
        Image noisy = board;
        for (glm::vec3& pixel : noisy.pixels) pixel += glm::vec3((random.unit() - 0.5f) * strength);
        const double now = metrics::ssim(noisy, board);
        EXPECT_LT(now, before);
        before = now;
    }
}

TEST(Flip, IsZeroForItselfAndOneForGreenAgainstBlue) {
    const Image board = checkered(64, 0.1f, 0.9f);
    EXPECT_EQ(metrics::flip(board, board).mean, 0.0);
    // By definition: the largest distance of the colour pipeline.
    EXPECT_NEAR(metrics::flip(constant(40, 40, {0, 1, 0}), constant(40, 40, {0, 0, 1})).mean, 1.0, 1e-9);
}

// Without edges the error is the colour's alone. Black against white is HyAB = 100, so 100^0.7 = 25.1189. Green is L*a*b*
// (87.735, -86.183, 83.180) and blue (32.299, 79.188, -107.860); with Hunt's factor 0.01 L that is (87.735, -75.613,
// 72.978) and (32.299, 25.577, -34.838), HyAB 55.436 + 147.83 = 203.27 and the largest 203.27^0.7 = 41.277. The knee at
// 0.4 of it is 16.511; 0.95 + 0.05 (25.119 - 16.511) / (41.277 - 16.511) = 0.9674.
TEST(Flip, BlackAgainstWhiteWorksOutByHand) {
    const metrics::Flip error =
        metrics::flip(constant(40, 40, glm::vec3(0.0f)), constant(40, 40, glm::vec3(1.0f)));
    EXPECT_NEAR(error.mean, 0.9674, 5e-4);
    for (const float pixel : error.map) EXPECT_NEAR(pixel, error.mean, 1e-6);
}

// A small difference on a flat field: grey code g has L* = 116 cbrt(Y) - 16, and the error is (dL)^0.7 0.95 / 16.511.
TEST(Flip, ASmallGreyDifferenceWorksOutByHand) {
    const auto lightness = [](double code) {
        return 116.0 * std::cbrt(std::pow((code + 0.055) / 1.055, 2.4)) - 16.0;
    };
    const double step = lightness(0.52) - lightness(0.5);
    const metrics::Flip error =
        metrics::flip(constant(40, 40, glm::vec3(0.52f)), constant(40, 40, glm::vec3(0.5f)));
    EXPECT_NEAR(error.mean, std::pow(step, 0.7) * 0.95 / 16.511, 1e-3);
}

TEST(Flip, IsSymmetricAndGrowsWithTheDifference) {
    const Image reference = checkered(64, 0.4f, 0.5f);
    double before = 0.0;
    for (const float high : {0.55f, 0.6f, 0.7f, 0.9f}) {
        const Image picture = checkered(64, 0.4f, high);
        const double there = metrics::flip(picture, reference).mean,
                     back = metrics::flip(reference, picture).mean;
        EXPECT_NEAR(there, back, 1e-12);
        EXPECT_GT(there, before);
        before = there;
    }
}

// What is too fine to be seen from afar is not an error: the same pixels, seen from further away, differ less.
TEST(Flip, FineDetailFadesWithDistance) {
    Image fine(96, 96), flat = constant(96, 96, glm::vec3(0.5f));
    for (int y = 0; y < 96; ++y) {
        for (int x = 0; x < 96; ++x) fine.at(x, y) = glm::vec3(((x + y) & 1) != 0 ? 0.6f : 0.4f);
    }
    const double near_by = metrics::flip(fine, flat, 15.0).mean,
                 far_away = metrics::flip(fine, flat, 120.0).mean;
    EXPECT_LT(far_away, 0.5 * near_by);
    EXPECT_NEAR(metrics::pixels_per_degree(0.7, 0.7, 3840), metrics::kUsualPixelsPerDegree, 1e-9);
}

// A lone bright pixel is noticed more than the same light spread evenly: that is what the feature term is for.
TEST(Flip, AFireflyIsNoticedWhereItIs) {
    Image reference = constant(65, 65, glm::vec3(0.3f)), picture = reference;
    picture.at(32, 32) = glm::vec3(1.0f);
    const metrics::Flip error = metrics::flip(picture, reference);
    EXPECT_GT(error.map[32 * 65 + 32], 0.3f);
    EXPECT_LT(error.map[0], 1e-6f);
}

}  // namespace
