// Light in few pixels must become the large picture it was taken of, follow it when the camera moves, and let go of it at
// once when it changes: a lamp that was switched off must not glow on.
#include "filter/temporal_upscale.h"

#include "filter/isa.h"
#include "filter/wall.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace gh {
namespace {

using test::kHeight, test::kStep, test::kWidth, test::lens_at, test::on_wall;
using test::shoot, test::Shot, test::Wall;

float plain(const glm::vec2&) {
    return 0.8f;
}

// The wall itself, each pixel the mean of 8x8 places in it.
Image truth(const Wall& wall, const glm::vec2& eye, int width, int height) {
    Image image(width, height);
    const filter::Pinhole lens = lens_at(eye, width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            float sum = 0.0f;
            for (int i = 0; i < 64; ++i) {
                const glm::vec2 in((static_cast<float>(i % 8) + 0.5f) / 8,
                                   (static_cast<float>(i / 8) + 0.5f) / 8);
                sum += wall(glm::vec2(on_wall(lens, glm::vec2(x, y) + in)));
            }
            image.at(x, y) = glm::vec3(sum / 64);
        }
    }
    return image;
}

double error(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const auto d = static_cast<double>(a.pixels[i].x - b.pixels[i].x);
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

// Slanted bars a few pixels wide: of every sixteenth pixel alone their edges can not be told.
float bars(const glm::vec2& p) {
    return std::sin(25.0f * p.x + 9.0f * p.y) > 0.0f ? 0.9f : 0.2f;
}

const glm::ivec2 kSize(kWidth* kStep, kHeight* kStep);

// Colours and edges are there from the first picture on, whichever pixels are lit.
TEST(TemporalUpscale, ColoursAreEveryPixelsOwnFromTheFirstPicture) {
    filter::TemporalUpscaler upscaler;
    Image out;
    const Shot shot = shoot(bars, plain, glm::vec2(0.0f), 0);
    upscaler.add(shot.frame(), Jobs(1), out);
    ASSERT_EQ(glm::ivec2(out.width, out.height), kSize);
    for (std::size_t i = 0; i < out.pixels.size(); ++i)
        EXPECT_NEAR(out.pixels[i].x, 0.8f * shot.albedo[i].x, 1e-6f);
}

TEST(TemporalUpscale, LightOfFewPixelsSharpensIntoThatOfAll) {
    filter::TemporalUpscaler upscaler;
    const Jobs jobs(1);
    const Image wanted = truth(bars, glm::vec2(0.0f), kSize.x, kSize.y);
    Image out;
    upscaler.add(shoot(plain, bars, glm::vec2(0.0f), 0).frame(), jobs, out);
    const auto scaled = [&] {
        Image light = out;
        for (glm::vec3& pixel : light.pixels) pixel /= 0.8f;
        return light;
    };
    const double first = error(scaled(), wanted);
    for (std::uint32_t i = 1; i < 48; ++i)
        upscaler.add(shoot(plain, bars, glm::vec2(0.0f), i).frame(), jobs, out);
    EXPECT_LT(error(scaled(), wanted), 0.6 * first);
}

// An edge is taken through other places of its pixels in each frame, and becomes as smooth as the mean of many.
TEST(TemporalUpscale, EdgesAreSmoothAfterAFewPictures) {
    filter::TemporalUpscaler upscaler;
    const Jobs jobs(1);
    Image wanted = truth(bars, glm::vec2(0.0f), kSize.x, kSize.y);
    for (glm::vec3& pixel : wanted.pixels) pixel *= 0.8f;
    Image out;
    upscaler.add(shoot(bars, plain, glm::vec2(0.0f), 0).frame(), jobs, out);
    const double first = error(out, wanted);
    for (std::uint32_t i = 1; i < 32; ++i)
        upscaler.add(shoot(bars, plain, glm::vec2(0.0f), i).frame(), jobs, out);
    EXPECT_LT(error(out, wanted), 0.4 * first);
}

TEST(TemporalUpscale, WhatMovesUnderTheCameraIsCarriedAlong) {
    filter::TemporalUpscaler upscaler;
    const Jobs jobs(1);
    Image out, one;
    const glm::vec2 step(0.013f, 0.004f);
    glm::vec2 eye(0.0f);
    for (std::uint32_t i = 0; i < 32; ++i, eye += step) {
        const Shot shot = shoot(bars, plain, eye, i);
        upscaler.add(shot.frame(), jobs, out);
        filter::TemporalUpscaler().add(shot.frame(), jobs, one);
    }
    Image wanted = truth(bars, eye - step, kSize.x, kSize.y);
    for (glm::vec3& pixel : wanted.pixels) pixel *= 0.8f;
    EXPECT_LT(error(out, wanted), 0.8 * error(one, wanted));
}

// A grey post half-way to the wall and of one part with it, as everything that stands still may be.
constexpr float kPostHalfWidth = 0.08f;

bool is_post(const glm::vec3& on_the_wall, const glm::vec3& eye) {
    return std::abs(0.5f * (on_the_wall.x + eye.x)) < kPostHalfWidth;
}

// The light on the wall is bright and that on the post dark, or the other way round.
TEST(TemporalUpscale, WhatAPostUncoversKeepsNoTraceOfIt) {
    for (const float of_post : {0.05f, 4.0f}) {
        filter::TemporalUpscaler upscaler;
        const Jobs jobs(1);
        constexpr float kSlide = 0.04f;  // the post slides by 2.4 pixels a frame along the wall
        constexpr std::uint32_t kFrames = 24;
        Image out;
        Shot shot;
        glm::vec3 eye;
        for (std::uint32_t i = 0; i < kFrames; ++i) {
            shot = shoot(plain, plain, glm::vec2(kSlide * static_cast<float>(i) - 0.5f, 0.0f), i);
            eye = shot.seen.lens.eye;
            for (std::size_t k = 0; k < shot.position.size(); ++k) {
                if (!is_post(shot.position[k], eye)) continue;
                shot.position[k] = 0.5f * (shot.position[k] + eye);
            }
            shot.light(plain);
            for (int v = 0; v < kHeight; ++v) {
                for (int u = 0; u < kWidth; ++u) {
                    if (shot.position[shot.place(u, v)].z > -0.75f) shot.radiance.at(u, v) *= of_post;
                }
            }
            upscaler.add(shot.frame(), jobs, out);
        }
        // All of the wall is lit alike: what differs is a trace. The pixel beside the post may mix both.
        double worst = 0.0;
        int uncovered = 0;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 1; x + 1 < kSize.x; ++x) {
                const auto is_wall = [&](int at) { return shot.position[out.index(at, y)].z < -0.75f; };
                if (!is_wall(x - 1) || !is_wall(x) || !is_wall(x + 1)) continue;
                const glm::vec3 p = on_wall(shot.seen.lens, glm::vec2(x, y) + 0.5f);
                uncovered += is_post(p, {eye.x - 3.0f * kSlide, eye.y, 0.0f}) ? 1 : 0;
                worst = std::max(worst, std::abs(static_cast<double>(out.at(x, y).x) - 0.64));
            }
        }
        EXPECT_GT(uncovered, 100);
        EXPECT_LT(worst, 0.02) << "a post " << of_post << " times as bright";
    }
}

// Somebody dark walks by before a bright wall, a pixel a picture: beside him stays nothing of him.
TEST(TemporalUpscale, WhatSomethingThatWalkedOnHidIsShownAtOnce) {
    filter::TemporalUpscaler upscaler;
    Image out;
    for (int frame = 0; frame < 16; ++frame) {
        const auto is_thing = [&](int x) { return x >= 20 + frame && x < 36 + frame; };
        Shot shot = shoot(plain, plain, glm::vec2(0.0f), static_cast<std::uint32_t>(frame));
        shot.previous = shot.position;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 20 + frame; x < 36 + frame; ++x) {
                const std::size_t at = static_cast<std::size_t>(y * kSize.x + x);
                shot.part[at] = 9;
                shot.previous[at] = shot.position[at] - shot.seen.lens.right;
            }
        }
        for (int v = 0; v < kHeight; ++v) {
            for (int u = 0; u < kWidth; ++u) {
                if (shot.part[shot.place(u, v)] == 9) shot.radiance.at(u, v) *= 0.02f;
            }
        }
        upscaler.add(shot.frame(), Jobs(1), out);
        if (frame == 0) continue;  // before it nothing moved
        for (int x = 0; x < kSize.x; ++x) {
            if (is_thing(x)) continue;
            ASSERT_NEAR(out.at(x, kSize.y / 2).x, 0.64f, 0.01f) << frame << ' ' << x;
        }
    }
}

TEST(TemporalUpscale, AConstantStaysExactlyThat) {
    filter::TemporalUpscaler upscaler;
    Image out;
    for (std::uint32_t i = 0; i < 20; ++i)
        upscaler.add(shoot(plain, plain, glm::vec2(0.02f) * static_cast<float>(i), i).frame(), Jobs(1), out);
    for (const glm::vec3& pixel : out.pixels) EXPECT_NEAR(pixel.x, 0.64f, 1e-6f);
}

// What shines by itself is exact in every pixel, however few are lit.
TEST(TemporalUpscale, ABulbIsAsBrightAsItIs) {
    Image out;
    Shot shot = shoot(plain, plain, glm::vec2(0.0f), 3);
    const std::size_t bulb = shot.place(11, 12) + 1;  // beside a lit pixel
    shot.clean[bulb] = glm::vec3(50.0f);
    shot.light(plain);
    filter::TemporalUpscaler().add(shot.frame(), Jobs(1), out);
    EXPECT_NEAR(out.pixels[bulb].x, 50.64f, 1e-4f);
    EXPECT_NEAR(out.pixels[bulb - 1].x, 0.64f, 1e-6f);
}

// A guide may think that more shines than does: what lit pixels say is less than that comes off all around.
TEST(TemporalUpscale, WhatAGuideTakesForTooBrightIsAsDarkAsItIs) {
    Image out;
    Shot shot = shoot(plain, plain, glm::vec2(0.0f), 3);
    shot.light(plain);
    for (glm::vec3& clean : shot.clean) clean = glm::vec3(5.0f);  // of light of .64
    filter::TemporalUpscaler().add(shot.frame(), Jobs(1), out);
    for (const glm::vec3& pixel : out.pixels) EXPECT_NEAR(pixel.x, 0.64f, 1e-5f);
}

// The samples around a pixel bound what is believed of its past: with all of them 0, so is it.
TEST(TemporalUpscale, ALampSwitchedOffIsDarkInTheNextPicture) {
    filter::TemporalUpscaler upscaler;
    Image out;
    for (std::uint32_t i = 0; i < 30; ++i)
        upscaler.add(shoot(bars, bars, glm::vec2(0.0f), i).frame(), Jobs(1), out);
    const Wall dark = [](const glm::vec2&) { return 0.0f; };
    upscaler.add(shoot(bars, dark, glm::vec2(0.0f), 30).frame(), Jobs(1), out);
    for (const glm::vec3& pixel : out.pixels) EXPECT_EQ(pixel, glm::vec3(0.0f));
}

TEST(TemporalUpscale, ASampleThatIsNoNumberIsForgotten) {
    filter::TemporalUpscaler upscaler;
    Image out;
    for (std::uint32_t i = 0; i < 4; ++i) {
        Shot shot = shoot(bars, bars, glm::vec2(0.0f), i);
        shot.radiance.at(11, 12) = glm::vec3(std::numeric_limits<float>::quiet_NaN());
        shot.position[20] = glm::vec3(std::numeric_limits<float>::infinity());
        shot.albedo[900] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
        upscaler.add(shot.frame(), Jobs(1), out);
        for (const glm::vec3& pixel : out.pixels) EXPECT_TRUE(std::isfinite(pixel.x));
    }
}

TEST(TemporalUpscale, ThreadsAndInstructionSetsDoNotMatterAndSizesMayChange) {
    const auto run = [](int threads) {
        const Jobs jobs(threads);
        filter::TemporalUpscaler upscaler;
        Image out;
        for (std::uint32_t i = 0; i < 6; ++i) {
            Shot shot = shoot(bars, bars, glm::vec2(0.01f) * static_cast<float>(i), i);
            for (std::size_t k = 0; k < shot.part.size(); ++k)  // torn into many surfaces
                if (shot.albedo[k].x > 0.5f && k % 3 != i % 3) shot.part[k] = 8;
            shot.position[2021] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
            filter::GuidedFrame frame = shot.frame();
            Image small(kWidth, kHeight - 7);  // a guide with fewer rows, as a lower window has
            if (i >= 3) {
                std::copy_n(shot.radiance.pixels.begin(), small.pixels.size(), small.pixels.begin());
                frame.guide.height = small.height * kStep;
                const auto count = static_cast<std::size_t>(frame.guide.height * frame.guide.width);
                frame.guide.part = frame.guide.part.first(count);
                for (auto* plane : {&frame.guide.position, &frame.guide.previous, &frame.guide.geometric,
                                    &frame.guide.albedo, &frame.guide.clean})
                    *plane = plane->first(count);
                upscaler.add({small, kStep, frame.offset, frame.guide}, jobs, out);
            } else {
                upscaler.add(frame, jobs, out);
            }
        }
        return out.pixels;
    };
    const auto one = run(1);
    EXPECT_EQ(one.size(), static_cast<std::size_t>(kSize.x * (kSize.y - 7 * kStep)));
    EXPECT_EQ(one, run(3));
    const std::vector<std::string> isas = filter::isa_names();
    ASSERT_GE(isas.size(), 2u) << "nothing to compare with";
    for (const std::string& isa : isas) {
        ASSERT_TRUE(filter::use_isa(isa));
        EXPECT_EQ(one, run(1)) << isa;
    }
    filter::use_isa("");
}

}  // namespace
}  // namespace gh
