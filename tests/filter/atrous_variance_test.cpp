// What a level says of the noise it leaves is what each further level goes by, and the last one shows: held against the
// noise itself.
#include "base/random.h"
#include "filter/atrous.h"

#include <gtest/gtest.h>

namespace gh {
namespace {

constexpr int kWidth = 192, kHeight = 128, kBorder = 16;
constexpr float kVariance = 1.0f / 12.0f;  // of a number that lies evenly in [0, 1]

filter::GBuffer wall_ahead() {
    filter::GBuffer surfaces;
    surfaces.fit(kWidth, kHeight);
    const float pixel = 1.0f / kHeight;
    surfaces.lens = {.eye = glm::vec3(0.0f),
                     .corner = {-0.5f * pixel * kWidth, 0.5f, -1.0f},
                     .right = {pixel, 0.0f, 0.0f},
                     .down = {0.0f, -pixel, 0.0f}};
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            surfaces.part.at(x, y) = 1;
            surfaces.normal.set(x, y, {0.0f, 0.0f, 1.0f});
            surfaces.position.set(
                x, y,
                2.0f * (surfaces.lens.corner + surfaces.lens.right * (static_cast<float>(x) + 0.5f) +
                        surfaces.lens.down * (static_cast<float>(y) + 0.5f)));
        }
    }
    return surfaces;
}

struct Noise {
    double said = 0.0, found = 0.0;
};

Noise noise_left(const filter::Signal& signal) {
    Noise noise;
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (int y = kBorder; y < kHeight - kBorder; ++y) {
        for (int x = kBorder; x < kWidth - kBorder; ++x) {
            const auto light = static_cast<double>(signal.light.y.at(x, y));
            sum += light;
            squares += light * light;
            noise.said += static_cast<double>(signal.variance.at(x, y));
            count += 1.0;
        }
    }
    noise.said /= count;
    noise.found = squares / count - sum / count * (sum / count);
    return noise;
}

// Neighbours are independent for the first level alone; later ones see blurred noise, so that what is left is more than
// is said: 1.4 times for 3x3, 2.6 times for 5x5.
TEST(Atrous, SaysHowMuchNoiseItLeaves) {
    const Jobs jobs(1);
    filter::Guides guides;
    filter::make_guides(wall_ahead(), jobs, guides);
    for (const int radius : {1, 2}) {
        Random random(3);
        filter::Plane3 light(kWidth, kHeight);
        filter::Plane variance(kWidth, kHeight);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                light.set(x, y, glm::vec3(1.0f + random.unit()));
                variance.at(x, y) = kVariance;
            }
        }
        filter::Signal signal, once, twice;
        filter::make_signal(light, variance, jobs, signal);
        // Light may differ by as much as it likes: weights do not hang on the noise.
        const filter::AtrousSettings settings{.radius = radius, .luminance_sigmas = 1e4f};
        filter::atrous_level(guides, view_of(signal), settings, 0, jobs, once);
        const Noise first = noise_left(once);
        EXPECT_LT(first.found, 0.3 * static_cast<double>(kVariance));
        EXPECT_NEAR(first.said / first.found, 1.0, 0.06) << "radius " << radius;
        filter::atrous_level(guides, view_of(once), settings, 1, jobs, twice);
        const Noise second = noise_left(twice);
        EXPECT_LT(second.said, 0.5 * first.said);
        EXPECT_GT(second.said / second.found, 0.35) << "radius " << radius;
        EXPECT_LT(second.said / second.found, 1.1) << "radius " << radius;
    }
}

}  // namespace
}  // namespace gh
