// Pictures show now one side of an edge and now the other through the same pixel. Both may be of one part and as far away,
// but each has light of its own.
#include "filter/wall.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gh {
namespace {

using test::kHeight, test::kStep, test::kWidth, test::shoot, test::Shot;

float plain(const glm::vec2&) {
    return 0.8f;
}

// An upright groove in the wall, so many pixels wide; its side is of one part with the wall, and dark.
test::Wall groove(float pixels) {
    constexpr float kPixel = 2.0f / static_cast<float>(kWidth * kStep);
    return [pixels](const glm::vec2& p) {
        return std::abs(p.x - 0.2f * kPixel) < 0.5f * pixels * kPixel ? 0.1f : 1.0f;
    };
}

TEST(TemporalUpscale, BothFacesOfAnEdgeKeepTheirOwnLight) {
    constexpr int kFrames = 96, kMean = 64;  // all places in a pixel, twice; the first 32 settle
    for (const float pixels : {1.0f, 1.5f, 3.0f}) {
        filter::TemporalUpscaler upscaler;
        Image out;
        double lost = 0.0;
        const test::Wall light = groove(pixels);
        for (int i = 0; i < kFrames; ++i) {
            Shot shot = shoot(plain, plain, glm::vec2(0.0f), static_cast<std::uint32_t>(i));
            for (std::size_t k = 0; k < shot.position.size(); ++k) {
                if (light(glm::vec2(shot.position[k])) < 1.0f) shot.normal[k] = glm::vec3(1.0f, 0.0f, 0.0f);
            }
            shot.light(light);
            upscaler.add(shot.frame(), Jobs(1), out);
            if (i < kFrames - kMean) continue;
            for (const glm::vec3& pixel : out.pixels) lost += 0.8 - static_cast<double>(pixel.x);
        }
        // Of the light of a row's pixels: nine tenths of the groove's, here to .2 %. With one light for both faces a groove
        // of one pixel took an eighth of that.
        const double a_row = lost / (0.8 * kMean * kHeight * kStep);
        EXPECT_NEAR(a_row / static_cast<double>(pixels), 0.9, 0.01) << pixels;
    }
}

}  // namespace
}  // namespace gh
