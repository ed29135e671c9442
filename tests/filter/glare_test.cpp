// The eye's halo: what it keeps, how it falls off, and that nothing else is spread by it.
#include "filter/glare.h"

#include "base/jobs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gh {
namespace {

Image constant(int width, int height, const glm::vec3& light) {
    Image image(width, height);
    for (glm::vec3& pixel : image.pixels) pixel = light;
    return image;
}

Image veiled(const Image& picture, const filter::GlareSettings& settings, int threads = 1) {
    filter::Glare glare;
    Image out;
    glare.veil(picture, settings, Jobs(threads), out);
    return out;
}

float off(const Image& a, const glm::vec3& light) {
    float most = 0.0f;
    for (const glm::vec3& pixel : a.pixels) {
        for (glm::length_t c = 0; c < 3; ++c) most = std::max(most, std::abs(pixel[c] / light[c] - 1.0f));
    }
    return most;
}

TEST(Glare, ConstantLightStaysThatConstant) {
    const glm::vec3 light(0.2f, 1.0f, 7.0f);
    for (const auto& [width, height] : {std::pair(640, 360), {1281, 719}, {7, 5}, {1, 1}, {2000, 3}})
        EXPECT_LT(off(veiled(constant(width, height, light), {.share = 0.3f}), light), 1e-6f)
            << width << 'x' << height;
    EXPECT_TRUE(veiled(Image(0, 9), {}).pixels.empty());
}

TEST(Glare, GivesAwayItsShareAndNoLightGetsLost) {
    Image picture(720, 720);  // a lamp in the middle, far from where the veil is cut off
    picture.at(360, 360) = glm::vec3(80.0f);
    const Image out = veiled(picture, {.share = 0.1f});
    double sum = 0.0;
    for (const glm::vec3& pixel : out.pixels) sum += static_cast<double>(pixel.x);
    EXPECT_NEAR(out.at(360, 360).x, 72.0f,
                1.0f);  // the veil of a pixel 16 of which are one block adds at most 8/16
    // Borders stand for what lies beyond them, which makes their blocks weigh more by a little.
    EXPECT_NEAR(sum, 80.0, 0.8);
}

// One over the square: twice as far, a quarter, within what a sum of doublings is uneven by.
TEST(Glare, FallsOffWithTheSquareOfTheAngle) {
    Image picture(1440, 720);
    for (int y = 356; y < 364; ++y) {
        for (int x = 716; x < 724; ++x) picture.at(x, y) = glm::vec3(90.0f);
    }
    const Image out = veiled(picture, {.share = 0.1f});
    for (const int far : {12, 16, 24, 32, 40}) {
        const float here = out.at(720 + far, 360).x, there = out.at(720 + 2 * far, 360).x;
        EXPECT_GT(here, there);
        EXPECT_NEAR(std::log2(here / there), 2.0f, 0.8f) << far;
    }
}

TEST(Glare, IsTheSameAtAnyResolution) {
    Image small(640, 360), large(1280, 720);
    for (int y = 0; y < 720; ++y) {
        for (int x = 0; x < 1280; ++x) {
            const bool is_lamp =
                std::hypot(static_cast<float>(x) - 600.0f, static_cast<float>(y) - 300.0f) < 20.0f;
            large.at(x, y) = small.at(x / 2, y / 2) = glm::vec3(is_lamp ? 50.0f : 0.1f);
        }
    }
    const Image coarse = veiled(small, {.share = 0.1f}), fine = veiled(large, {.share = 0.1f});
    for (const int x : {340, 400, 500})
        EXPECT_NEAR(coarse.at(x, 150).x / fine.at(2 * x, 300).x, 1.0f, 0.03f) << x;
}

TEST(Glare, ALampTooBrightVeilsLikeOneAtTheBoundAndKeepsItsHue) {
    Image bright(320, 180), bounded(320, 180);
    bright.at(100, 90) = {4000.0f, 2000.0f, 400.0f};
    bounded.at(100, 90) = {40.0f, 20.0f, 4.0f};
    const filter::GlareSettings settings{.share = 0.1f, .most = 40.0f};
    const Image a = veiled(bright, settings), b = veiled(bounded, settings);
    EXPECT_FLOAT_EQ(a.at(110, 90).x, b.at(110, 90).x);
    EXPECT_NEAR(a.at(110, 90).x / a.at(110, 90).z, 10.0f, 1e-3f);
    EXPECT_FLOAT_EQ(a.at(100, 90).x - b.at(100, 90).x, 0.9f * 3960.0f);  // itself it stays as bright
}

TEST(Glare, WhatIsNotANumberStaysWhereItIs) {
    Image picture = constant(320, 180, glm::vec3(0.5f));
    const Image clean = veiled(picture, {});
    picture.at(50, 60).y = std::numeric_limits<float>::quiet_NaN();
    picture.at(200, 90) = glm::vec3(-std::numeric_limits<float>::infinity());
    const Image out = veiled(picture, {});
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 320; ++x) {
            if ((x == 50 && y == 60) || (x == 200 && y == 90)) continue;
            ASSERT_NEAR(out.at(x, y).y, clean.at(x, y).y, 0.05f * 0.5f)
                << x << ',' << y;  // no brighter than it was
        }
    }
    picture.at(10, 10) = glm::vec3(std::numeric_limits<float>::infinity());
    EXPECT_TRUE(std::isfinite(veiled(picture, {}).at(12, 10).x));
}

TEST(Glare, AnyNumberOfThreadsGivesTheSameBits) {
    Image picture(333, 201);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        picture.pixels[i] = glm::vec3(static_cast<float>((i * 7919) % 1013));
    const Image one = veiled(picture, {}), eight = veiled(picture, {}, 8);
    EXPECT_TRUE(one.pixels == eight.pixels);
}

}  // namespace
}  // namespace gh
