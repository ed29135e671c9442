#include "app/resolution.h"

#include <gtest/gtest.h>

namespace gh::app {
namespace {

// A machine that takes a fixed time a pixel: the frame rate a player chose is reached, and then kept still.
TEST(Resolution, SettlesWhereAPictureTakesTheTimeThatIsWanted) {
    for (const float ns_a_pixel : {20.0f, 150.0f, 900.0f}) {
        Resolution resolution;
        const glm::ivec2 framebuffer(1920, 1080);
        const auto ms = [&] {
            const glm::ivec2 size = resolution.size_for(framebuffer);
            return static_cast<float>(size.x * size.y) * ns_a_pixel * 1e-6f;
        };
        for (int frame = 0; frame < 120; ++frame) resolution.note_frame(ms(), 33.3f);
        // A tenth is the dead band, the rest the rounding of both sides to 8 pixels.
        const bool is_full = resolution.size_for(framebuffer) == framebuffer;
        if (!is_full) {
            EXPECT_NEAR(ms(), 33.3f, 33.3f * 0.2f) << ns_a_pixel << " ns a pixel";
        }
        const glm::ivec2 before = resolution.size_for(framebuffer);
        for (int frame = 0; frame < 30; ++frame) resolution.note_frame(ms(), 33.3f);
        EXPECT_EQ(before, resolution.size_for(framebuffer)) << "the picture breathes";
    }
}

TEST(Resolution, KeepsTheShapeAndNeverExceedsTheWindow) {
    Resolution resolution;
    for (int i = 0; i < 100; ++i) resolution.note_frame(1.0f, 33.3f);
    EXPECT_EQ(resolution.size_for({640, 360}), glm::ivec2(640, 360));
    EXPECT_EQ(resolution.size_for({0, 0}), glm::ivec2(0, 0));
    EXPECT_EQ(resolution.size_for({100, 50}), glm::ivec2(100, 50)) << "a tiny window is drawn in full";
    for (int i = 0; i < 200; ++i) resolution.note_frame(1000.0f, 33.3f);
    const glm::ivec2 least = resolution.size_for({1280, 720});
    EXPECT_GE(least.x, 160);
    EXPECT_NEAR(static_cast<double>(least.x) / least.y, 16.0 / 9.0, 0.1);
}

// A slow machine at high quality shows fewer frames, a fast one at low quality does not draw more than was asked for;
// and what was asked for last holds at once.
TEST(Resolution, StaysWithinTheBoundsOfTheQualityThatWasChosen) {
    const glm::ivec2 framebuffer(1280, 720);
    const auto pixels = [&](const Resolution& resolution) {
        const glm::ivec2 size = resolution.size_for(framebuffer);
        return static_cast<float>(size.x * size.y);
    };
    const float rounding = 1.05f;  // sides are multiples of 8
    Resolution resolution;
    resolution.bound(400.0f * 225.0f, 640.0f * 360.0f);
    EXPECT_GE(pixels(resolution) * rounding, 400.0f * 225.0f);
    for (int i = 0; i < 100; ++i) resolution.note_frame(500.0f, 33.3f);
    EXPECT_GE(pixels(resolution) * rounding, 400.0f * 225.0f);
    for (int i = 0; i < 100; ++i) resolution.note_frame(1.0f, 33.3f);
    EXPECT_LE(pixels(resolution), 640.0f * 360.0f * rounding);
    resolution.bound(192.0f * 108.0f, 320.0f * 180.0f);
    EXPECT_LE(pixels(resolution), 320.0f * 180.0f * rounding);
}

TEST(Resolution, IgnoresTimesThatAreNone) {
    Resolution resolution;
    const float before = resolution.pixels();
    resolution.note_frame(0.0f, 33.3f);
    resolution.note_frame(std::numeric_limits<float>::quiet_NaN(), 33.3f);
    EXPECT_EQ(resolution.pixels(), before);
}

}  // namespace
}  // namespace gh::app
