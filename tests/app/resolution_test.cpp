#include "app/resolution.h"

#include <gtest/gtest.h>

namespace gh::app {
namespace {

float lit_pixels(const PictureShape& shape) {
    return static_cast<float>(shape.lit.x * shape.lit.y);
}

// What a lit pixel costs, and what every pixel does that is looked at.
float ms_of(const PictureShape& shape, float ns_a_pixel) {
    const float shown = lit_pixels(shape) * static_cast<float>(shape.step * shape.step);
    return (lit_pixels(shape) + 0.08f * shown) * ns_a_pixel * 1e-6f;
}

// A machine that takes a fixed time a pixel: the frame rate a player chose is reached, and then kept still.
TEST(Resolution, SettlesWhereAPictureTakesTheTimeThatIsWanted) {
    const glm::ivec2 framebuffer(1920, 1080);
    for (const float ns_a_pixel : {3.0f, 20.0f, 60.0f, 150.0f, 900.0f}) {
        Resolution resolution;
        const auto ms = [&] { return ms_of(resolution.shape_for(framebuffer), ns_a_pixel); };
        for (int frame = 0; frame < 120; ++frame) resolution.note_frame(ms(), 33.3f, framebuffer);
        const PictureShape before = resolution.shape_for(framebuffer);
        // A tenth is the dead band, the rest the rounding of both sides to 8 pixels.
        EXPECT_LT(ms(), 33.3f * 1.2f) << ns_a_pixel << " ns a pixel";
        const bool shows_all = before.shown().x >= framebuffer.x;
        if (!shows_all) {
            EXPECT_GT(ms(), 33.3f * 0.8f) << ns_a_pixel << " ns a pixel";
        }
        for (int frame = 0; frame < 60; ++frame) {
            resolution.note_frame(ms(), 33.3f, framebuffer);
            EXPECT_EQ(before, resolution.shape_for(framebuffer)) << "the picture breathes";
        }
    }
}

// Every sixteenth, ninth, fourth, all: a faster machine never shows less of the window, nor lights fewer pixels.
TEST(Resolution, AFasterMachineShowsAndLightsAtLeastAsMuch) {
    const glm::ivec2 framebuffer(1280, 720);
    PictureShape slower;
    slower.lit = glm::ivec2(1);
    for (float ns_a_pixel = 3000.0f; ns_a_pixel > 5.0f; ns_a_pixel *= 0.7f) {
        Resolution resolution;
        for (int frame = 0; frame < 200; ++frame)
            resolution.note_frame(ms_of(resolution.shape_for(framebuffer), ns_a_pixel), 33.3f, framebuffer);
        const PictureShape shape = resolution.shape_for(framebuffer);
        EXPECT_GE(lit_pixels(shape), lit_pixels(slower)) << ns_a_pixel;
        EXPECT_GE(shape.shown().x + 1, slower.shown().x) << ns_a_pixel;
        slower = shape;
    }
    EXPECT_EQ(slower.step, 1);
}

TEST(Resolution, KeepsTheShapeAndHardlyExceedsTheWindow) {
    Resolution resolution;
    const glm::ivec2 framebuffer(640, 360);
    for (int i = 0; i < 100; ++i) resolution.note_frame(1.0f, 33.3f, framebuffer);
    EXPECT_EQ(resolution.shape_for(framebuffer), (PictureShape{{640, 360}, 1}));
    EXPECT_EQ(resolution.shape_for({0, 0}).lit, glm::ivec2(0, 0));
    EXPECT_EQ(resolution.shape_for({100, 50}), (PictureShape{{100, 50}, 1}))
        << "a tiny window is drawn in full";
    for (int i = 0; i < 200; ++i) resolution.note_frame(1000.0f, 33.3f, {1280, 720});
    const glm::ivec2 least = resolution.shape_for({1280, 720}).shown();
    EXPECT_GE(least.x, 288);
    EXPECT_NEAR(static_cast<double>(least.x) / least.y, 16.0 / 9.0, 0.03);  // half a lit pixel of 45
    for (const glm::ivec2 odd : {glm::ivec2(1279, 721), glm::ivec2(77, 1023), glm::ivec2(1, 1)}) {
        const glm::ivec2 shown = resolution.shape_for(odd).shown();
        EXPECT_LE(shown.x, odd.x + 31);
        EXPECT_LE(shown.y, odd.y + 31);
    }
}

// What is much smaller than the window is added up in twice its sides; what nearly fills it is not.
TEST(Resolution, DoublesWhatIsMuchSmallerThanTheWindow) {
    const glm::ivec2 framebuffer(1280, 720);
    bool has_doubled = false, has_not = false;
    for (float ns_a_pixel = 3000.0f; ns_a_pixel > 5.0f; ns_a_pixel *= 0.8f) {
        Resolution resolution;
        for (int frame = 0; frame < 200; ++frame)
            resolution.note_frame(ms_of(resolution.shape_for(framebuffer), ns_a_pixel), 33.3f, framebuffer);
        const PictureShape shape = resolution.shape_for(framebuffer);
        EXPECT_EQ(shape.doubles, 7 * shape.shown().x <= 5 * framebuffer.x) << shape.shown().x;
        EXPECT_EQ(shape.made(), shape.doubles ? 2 * shape.shown() : shape.shown());
        (shape.doubles ? has_doubled : has_not) = true;
    }
    EXPECT_TRUE(has_doubled && has_not);
}

// A slow machine at high quality shows fewer frames, a fast one at low quality does not light more than was asked for;
// and what was asked for last holds at once.
TEST(Resolution, StaysWithinTheBoundsOfTheQualityThatWasChosen) {
    const glm::ivec2 framebuffer(3840, 2160);
    const auto pixels = [&](const Resolution& resolution) {
        return lit_pixels(resolution.shape_for(framebuffer));
    };
    const float rounding = 1.05f;  // sides are multiples of 8
    for (const int step : {3, kMostStep}) {
        const auto shown = [&](const Resolution& resolution) {
            return pixels(resolution) * static_cast<float>(step * step);
        };
        Resolution resolution;
        resolution.bound(1200.0f * 675.0f, 640.0f * 360.0f, step);
        EXPECT_GE(shown(resolution) * rounding, 1200.0f * 675.0f);
        for (int i = 0; i < 100; ++i) resolution.note_frame(500.0f, 33.3f, framebuffer);
        EXPECT_GE(shown(resolution) * rounding, 1200.0f * 675.0f);
        EXPECT_EQ(resolution.shape_for(framebuffer).step, step);
        for (int i = 0; i < 100; ++i) resolution.note_frame(1.0f, 33.3f, framebuffer);
        EXPECT_LE(pixels(resolution), 640.0f * 360.0f * rounding);
        resolution.bound(576.0f * 324.0f, 320.0f * 180.0f, step);
        EXPECT_LE(pixels(resolution), 320.0f * 180.0f * rounding);
    }
}

TEST(Resolution, IgnoresTimesThatAreNone) {
    Resolution resolution;
    const float before = resolution.pixels();
    resolution.note_frame(0.0f, 33.3f, {640, 360});
    resolution.note_frame(std::numeric_limits<float>::quiet_NaN(), 33.3f, {640, 360});
    resolution.note_frame(1.0f, 33.3f, {0, 360});
    EXPECT_EQ(resolution.pixels(), before);
}

}  // namespace
}  // namespace gh::app
