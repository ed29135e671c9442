// Adaptive subsampling leaves out work, not light: where the light is smooth it is off by less than it was allowed to
// be, where it is not it works out every pixel, and what is seen never depends on it.
#include "render/lattice.h"
#include "studio.h"

#include <gtest/gtest.h>

namespace gh {
namespace {

using test::Studio;

render::WhittedSettings adaptive(float contrast) {
    render::WhittedSettings settings = test::exact();
    settings.shares_samples = true;
    settings.is_adaptive = true;
    settings.contrast = contrast;
    return settings;
}

render::WhittedSettings every_pixel() {
    render::WhittedSettings settings = test::exact();
    settings.shares_samples = true;
    return settings;
}

const render::Camera kDownwards{.position = {0, 3, 0}, .pitch = -1.5707964f, .fov_y = 0.9f};

render::Film film_of(const Studio& studio, const render::Camera& camera,
                     const render::WhittedSettings& settings) {
    render::Film film(80, 60);
    render::render_whitted({studio.level, studio.snapshot, studio.prepared}, camera, settings, 0, Jobs(1),
                           film);
    return film;
}

void add_floor_and_bulb(Studio& studio) {
    studio.add_sheet({0, 0, 0}, {5, 0, 0}, {0, 0, -5}, test::matte({0.8f, 0.4f, 0.2f}));
    studio.add_lamp({.name = {},
                     .shape = world::LampShape::Point,
                     .position = {1.0f, 2.0f, 0.5f},
                     .intensity = {7, 8, 9}});
}

TEST(Lattice, EveryPixelIsVisitedOnceAndStandsBetweenEarlierOnes) {
    for (int length = 1; length <= 16; ++length) {
        const render::Lattice<16> lattice(length);
        EXPECT_EQ(lattice.pass[0], 0);
        EXPECT_EQ(lattice.pass[static_cast<std::size_t>(length - 1)], 0);
        for (int i = 0; i < length; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const std::size_t pass = lattice.pass[at];
            if (pass == 0) continue;
            const std::size_t before = lattice.before[pass][at], after = lattice.after[pass][at];
            EXPECT_LT(before, at);
            EXPECT_GT(after, at);
            EXPECT_LT(lattice.pass[before], pass);
            EXPECT_LT(lattice.pass[after], pass);
            EXPECT_LE(after - before, static_cast<std::size_t>(render::kLatticeStep));
        }
    }
}

// A point lamp over a floor falls off steadily, so a pixel's true light lies between those of the pixels around it, but
// for the bump right below the lamp, where it exceeds them by less than they differ. They differ by no more than the
// contrast allowed; so does the blend from the truth.
TEST(WhittedAdaptive, SmoothLightIsBlendedFromFewPixelsAndOffByLessThanTheContrastAllowed) {
    Studio studio;
    add_floor_and_bulb(studio);
    studio.open();
    constexpr float kContrast = 0.2f;
    const render::Film full = film_of(studio, kDownwards, every_pixel());
    const render::Film few = film_of(studio, kDownwards, adaptive(kContrast));
    EXPECT_EQ(full.stats.lit_pixels, 80u * 60u);
    EXPECT_LT(few.stats.lit_pixels, 80u * 60u / 3);
    for (std::size_t i = 0; i < full.radiance.pixels.size(); ++i) {
        const glm::vec3 truth = full.radiance.pixels[i], seen = few.radiance.pixels[i];
        ASSERT_LE(glm::length(seen - truth), kContrast * glm::length(truth) + 1e-6f) << "pixel " << i;
    }
}

// Whatever the contrast, no light is carried over the edge of a shadow or of a thing.
TEST(WhittedAdaptive, NothingIsCarriedFromOneThingToAnother) {
    Studio studio;
    add_floor_and_bulb(studio);
    studio.add_box({-0.6f, 0.2f, -0.6f}, {0.1f, 0.5f, 0.1f}, test::matte({0.1f, 0.1f, 0.9f}));
    studio.open();
    const render::Film full = film_of(studio, kDownwards, every_pixel());
    const render::Film few = film_of(studio, kDownwards, adaptive(0.1f));
    double wrong = 0.0;
    for (std::size_t i = 0; i < full.radiance.pixels.size(); ++i) {
        const glm::vec3 truth = full.radiance.pixels[i], seen = few.radiance.pixels[i];
        if (glm::length(seen - truth) > 0.15f * glm::length(truth) + 1e-3f) wrong += 1.0;
    }
    // A corner of the shadow may slip between the first pixels of the lattice: here a few at most.
    EXPECT_LT(wrong / 4800.0, 0.004);
}

TEST(WhittedAdaptive, AMirrorShowsItsPictureInEveryPixel) {
    Studio studio;
    add_floor_and_bulb(studio);
    studio.add_sheet({0, 1.2f, -2}, {2, 0, 0}, {0, 1.2f, 0}, test::mirror(0.9f));
    studio.add_box({-0.5f, 0.2f, 0.5f}, {0.5f, 0.9f, 1.0f}, test::matte({0.2f, 0.8f, 0.2f}));
    studio.open();
    const render::Camera camera{.position = {0.3f, 1.2f, 3}, .pitch = -0.05f, .fov_y = 0.9f};
    const render::Film full = film_of(studio, camera, every_pixel());
    const render::Film few = film_of(studio, camera, adaptive(0.05f));
    double difference = 0.0, light = 0.0;
    for (std::size_t i = 0; i < full.radiance.pixels.size(); ++i) {
        difference += static_cast<double>(glm::length(full.radiance.pixels[i] - few.radiance.pixels[i]));
        light += static_cast<double>(glm::length(full.radiance.pixels[i]));
    }
    EXPECT_LT(few.stats.lit_pixels, full.stats.lit_pixels * 3 / 4);
    EXPECT_LT(difference, 0.05 * light);  // the contrast allowed
}

}  // namespace
}  // namespace gh
