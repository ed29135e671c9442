#include "filter/tone_map.h"

#include "filter/isa.h"
#include "filter/upscale.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace gh {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

Image constant(int width, int height, const glm::vec3& value) {
    Image image(width, height);
    for (glm::vec3& pixel : image.pixels) pixel = value;
    return image;
}

TEST(Srgb, HasTheStandardsValuesAndGoesThereAndBack) {
    EXPECT_EQ(filter::srgb_from_linear(0.0f), 0.0f);
    EXPECT_EQ(filter::srgb_from_linear(1.0f), 1.0f);
    EXPECT_NEAR(filter::srgb_from_linear(0.5f), 0.735357f, 1e-6f);
    EXPECT_NEAR(filter::srgb_from_linear(0.001f), 0.01292f, 1e-7f);
    for (int i = 0; i <= 255; ++i) {
        const float code = static_cast<float>(i) / 255.0f;
        EXPECT_NEAR(filter::srgb_from_linear(filter::linear_from_srgb(code)), code, 1e-6f);
    }
}

TEST(ToneMap, TheCurveIsStraightInTheDarksRisesForEverAndNeverReachesWhite) {
    EXPECT_EQ(filter::film_curve(0.0f), 0.0f);
    EXPECT_EQ(filter::film_curve(0.1f), 0.1f);
    float before = -1.0f;
    for (float x = 0.0f; x < 100.0f; x += 0.01f) {
        const float y = filter::film_curve(x);
        ASSERT_GT(y, before) << x;
        ASSERT_LT(y, 1.0f) << x;
        before = y;
    }
}

TEST(ToneMap, AConstantPictureStaysWithinOneCodeAndBlackStaysBlack) {
    const Jobs jobs(1);
    Image8 out;
    for (const float value : {0.0f, 0.002f, 0.05f, 0.4f, 3.0f}) {
        for (std::uint32_t frame = 0; frame < 4; ++frame) {
            filter::tone_map(constant(16, 16, glm::vec3(value)), 1.0f, frame, jobs, out);
            const auto [low, high] = std::minmax_element(out.bytes.begin(), out.bytes.end());
            EXPECT_LE(*high - *low, 1) << value;
            if (value == 0.0f) {
                EXPECT_EQ(*high, 0);
            }
        }
    }
}

// Without dither a dark gradient would step where the code does; with it the mean follows.
TEST(ToneMap, DitherKeepsTheMeanOfWhatLiesBetweenTwoCodes) {
    const Jobs jobs(1);
    Image8 out;
    const float between = filter::linear_from_srgb(20.5f / 255.0f);
    filter::tone_map(constant(64, 64, glm::vec3(between)), 1.0f, 0, jobs, out);
    double sum = 0.0;
    for (const std::uint8_t byte : out.bytes) sum += byte;
    EXPECT_NEAR(sum / static_cast<double>(out.bytes.size()), 20.5, 0.15);
}

TEST(ToneMap, WhatIsNotANumberIsBlackAndStaysAlone) {
    const Jobs jobs(1);
    Image image = constant(8, 8, glm::vec3(0.2f));
    Image8 clean, out;
    filter::tone_map(image, 1.0f, 0, jobs, clean);
    image.at(3, 3) = glm::vec3(kNan);
    image.at(5, 5) = glm::vec3(kInf);
    filter::tone_map(image, 1.0f, 0, jobs, out);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            if (x == 3 && y == 3)
                EXPECT_EQ(out.at(x, y)[0], 0);
            else if (x == 5 && y == 5)
                EXPECT_GE(out.at(x, y)[0], 254);
            else
                EXPECT_EQ(out.at(x, y)[0], clean.at(x, y)[0]);
        }
    }
    EXPECT_TRUE(std::isfinite(filter::metered_exposure(image)));
}

TEST(ToneMap, AVeryBrightColourTurnsWhite) {
    const Jobs jobs(1);
    Image8 out;
    filter::tone_map(constant(1, 1, {2000.0f, 200.0f, 50.0f}), 1.0f, 0, jobs, out);
    EXPECT_GT(out.bytes[2], 240);
}

// A film rendered on one machine and gone on with on another must not change its colours in between.
TEST(ToneMap, EveryInstructionSetMakesTheSameBytesAtAnyWidth) {
    for (const int width : {1, 7, 16, 61}) {
        Image image(width, 5);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const auto x = static_cast<float>(i);
            image.pixels[i] = glm::vec3(x * x * 0.001f, 3.0f / (1.0f + x), i % 11 == 0 ? kNan : x * 0.01f);
        }
        Image8 best, other;
        filter::tone_map(image, 1.7f, 3, Jobs(1), best);
        for (const std::string& isa : filter::isa_names()) {
            ASSERT_TRUE(filter::use_isa(isa));
            filter::tone_map(image, 1.7f, 3, Jobs(1), other);
            EXPECT_EQ(best.bytes, other.bytes) << isa << " at width " << width;
        }
        filter::use_isa("");
        // What the header says of the curve holds for bytes, too: within one code for dither.
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const float grey = 0.01f * static_cast<float>(i);
            Image one(1, 1);
            one.at(0, 0) = glm::vec3(grey);
            filter::tone_map(one, 1.0f, 0, Jobs(1), other);
            const float peak = filter::film_curve(grey);
            EXPECT_NEAR(other.bytes[0], 255.0f * filter::srgb_from_linear(peak), 1.0f) << grey;
        }
    }
}

// Where the curve is straight a grey that fits a code is shown by that very code, whatever the dither: the polynomial for
// the standard's curve is nowhere off by the quarter of a code that would change it.
TEST(ToneMap, AGreyThatFitsACodeIsShownByIt) {
    Image greys(136, 1);
    int shown = 0;
    while (shown < greys.width && filter::linear_from_srgb(static_cast<float>(shown) / 255.0f) < 0.25f) {
        greys.at(shown, 0) = glm::vec3(filter::linear_from_srgb(static_cast<float>(shown) / 255.0f));
        ++shown;
    }
    ASSERT_GT(shown, 130);
    for (std::uint32_t frame = 0; frame < 64; ++frame) {
        Image8 out;
        filter::tone_map(greys, 1.0f, frame, Jobs(1), out);
        for (int code = 0; code < shown; ++code) ASSERT_EQ(out.at(code, 0)[0], code) << "frame " << frame;
    }
}

TEST(ToneMap, OneAndEightThreadsMakeTheSameBytes) {
    Image image(97, 53);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = glm::vec3(static_cast<float>(i % 101) * 0.01f);
    Image8 one, eight;
    filter::tone_map(image, 1.3f, 5, Jobs(1), one);
    filter::tone_map(image, 1.3f, 5, Jobs(8), eight);
    EXPECT_EQ(one.bytes, eight.bytes);
}

TEST(Exposure, FollowsTheLightFastAndTheDarkSlowlyWithoutOvershoot) {
    const Image bright = constant(8, 8, glm::vec3(1.0f)), dark = constant(8, 8, glm::vec3(0.02f));
    const float for_bright = filter::metered_exposure(bright), for_dark = filter::metered_exposure(dark);
    ASSERT_LT(for_bright, for_dark);
    float down = for_dark, up = for_bright;
    for (int i = 0; i < 30; ++i) {
        down = filter::adapted_exposure(bright, down, 1.0f / 60.0f);
        up = filter::adapted_exposure(dark, up, 1.0f / 60.0f);
    }
    const auto way = [&](float at, float from, float to) {
        return std::log(at / from) / std::log(to / from);
    };
    EXPECT_NEAR(way(down, for_dark, for_bright), 1.0f - std::exp(-0.5f / 0.3f), 1e-3f);
    EXPECT_NEAR(way(up, for_bright, for_dark), 1.0f - std::exp(-0.5f / 2.0f), 1e-3f);
    EXPECT_EQ(filter::adapted_exposure(bright, 0.7f, 0.0f), 0.7f);
}

TEST(Exposure, HasBounds) {
    const float most = filter::metered_exposure(constant(4, 4, glm::vec3(0.0f)));
    EXPECT_TRUE(std::isfinite(most));
    EXPECT_EQ(filter::metered_exposure(Image{}), most);
    EXPECT_GT(filter::metered_exposure(constant(4, 4, glm::vec3(1e9f))), 0.0f);
}

TEST(Resample, AConstantStaysThatConstantInEverySize) {
    const Image in = constant(13, 7, {0.25f, 1.5f, 30.0f});
    for (const glm::ivec2 size :
         {glm::ivec2(26, 14), glm::ivec2(100, 3), glm::ivec2(1, 1), glm::ivec2(13, 7)}) {
        Image out(size.x, size.y);
        filter::resample(in, Jobs(1), out);
        for (const glm::vec3& pixel : out.pixels) EXPECT_LT(glm::length(pixel - in.pixels[0]), 1e-4f);
    }
}

TEST(Resample, OvershootsNowhereAndLetsNoNanSpread) {
    Image in(16, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) in.at(x, y) = glm::vec3(x < 8 ? 0.0f : 1.0f);
    }
    in.at(12, 4) = glm::vec3(kNan);
    Image out(40, 40);
    filter::resample(in, Jobs(1), out);
    for (const glm::vec3& pixel : out.pixels) EXPECT_TRUE(pixel.x >= 0.0f && pixel.x <= 1.0f);
    EXPECT_EQ(out.at(39, 39).x, 1.0f);
    EXPECT_EQ(out.at(0, 0).x, 0.0f);
}

TEST(Resample, OneAndEightThreadsMakeTheSameBits) {
    Image in(31, 17);
    for (std::size_t i = 0; i < in.pixels.size(); ++i)
        in.pixels[i] = glm::vec3(static_cast<float>(i * 7919 % 523));
    Image one(64, 40), eight(64, 40);
    filter::resample(in, Jobs(1), one);
    filter::resample(in, Jobs(8), eight);
    EXPECT_EQ(one.pixels, eight.pixels);
}

TEST(Resample, BytesKeepTheirSteadyValuesToo) {
    Image8 in(9, 9, 4);
    for (std::size_t i = 0; i < in.bytes.size(); ++i)
        in.bytes[i] = static_cast<std::uint8_t>(10 + 60 * (i % 4));
    Image8 out(20, 5, 4);
    filter::resample(in, Jobs(1), out);
    for (std::size_t i = 0; i < out.bytes.size(); ++i) EXPECT_EQ(out.bytes[i], 10 + 60 * (i % 4));
}

}  // namespace
}  // namespace gh
