// Pictures that are added up in one of twice their sides must show what no single one of them can, and neither smear what
// moves nor keep what is gone.
#include "filter/isa.h"
#include "filter/temporal_upscale.h"
#include "filter/upscale.h"
#include "filter/wall.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace gh {
namespace {

using test::kHeight, test::kStep, test::kWidth, test::lens_at, test::on_wall;
using test::shoot, test::Shot, test::Wall;

const glm::ivec2 kSmall(kWidth*kStep, kHeight*kStep), kLarge = 2 * kSmall;

float plain(const glm::vec2&) {
    return 0.8f;
}

// Slanted bars two and a half small pixels wide.
float bars(const glm::vec2& p) {
    return std::sin(90.0f * p.x + 40.0f * p.y) > 0.0f ? 0.9f : 0.2f;
}

// What adding `shot` makes of the frames before it.
void add(filter::TemporalUpscaler& upscaler, const Shot& shot, const Jobs& jobs, Image& out) {
    filter::GuidedFrame frame = shot.frame();
    frame.doubles = true;
    upscaler.add(frame, jobs, out);
}

// How far the picture is from the wall itself, each large pixel the mean of 6x6 places in it, away from the border.
double error(const Image& out, const glm::vec2& eye) {
    const filter::Pinhole lens = lens_at(eye, kLarge.x, kLarge.y);
    double sum = 0.0;
    int count = 0;
    for (int y = 4; y < kLarge.y - 4; ++y) {
        for (int x = 4; x < kLarge.x - 4; ++x, ++count) {
            float light = 0.0f;
            for (int i = 0; i < 36; ++i) {
                const glm::vec2 in((static_cast<float>(i % 6) + 0.5f) / 6,
                                   (static_cast<float>(i / 6) + 0.5f) / 6);
                light += 0.8f * bars(glm::vec2(on_wall(lens, glm::vec2(x, y) + in))) / 36;
            }
            const auto off = static_cast<double>(out.at(x, y).x - light);
            sum += off * off;
        }
    }
    return std::sqrt(sum / count);
}

// One after the other, the eye going on by `step` each time: doubled, and made as they are and stretched by a cubic.
struct Errors {
    double doubled, stretched;
};
Errors errors_after(std::uint32_t pictures, const glm::vec2& step) {
    const Jobs jobs(1);
    filter::TemporalUpscaler upscaler, usual;
    Image large, small, stretched(kLarge.x, kLarge.y);
    glm::vec2 eye(0.0f);
    for (std::uint32_t i = 0; i < pictures; ++i, eye += step) {
        const Shot shot = shoot(bars, plain, eye, i);
        add(upscaler, shot, jobs, large);
        usual.add(shot.frame(), jobs, small);
    }
    EXPECT_EQ(glm::ivec2(large.width, large.height), kLarge);
    filter::resample(small, jobs, stretched);
    return {error(large, eye - step), error(stretched, eye - step)};
}

// At rest .042 for .084, and .067 for .110 while the eye goes on by a pixel and a third in every picture.
TEST(TemporalDouble, ShowsWhatNoSinglePictureCan) {
    const Errors at_rest = errors_after(48, glm::vec2(0.0f));
    EXPECT_LT(at_rest.doubled, 0.6 * at_rest.stretched) << at_rest.doubled << ' ' << at_rest.stretched;
    const Errors moving = errors_after(32, glm::vec2(0.0167f, 0.0052f));
    EXPECT_LT(moving.doubled, 0.75 * moving.stretched) << moving.doubled << ' ' << moving.stretched;
}

// A first picture knows no more than its pixels, and is no worse than stretching it.
TEST(TemporalDouble, BeginsNoWorseThanAStretchedPicture) {
    const Errors first = errors_after(1, glm::vec2(0.0f));
    EXPECT_LT(first.doubled, 1.1 * first.stretched) << first.doubled << ' ' << first.stretched;
}

TEST(TemporalDouble, AConstantStaysThat) {
    filter::TemporalUpscaler upscaler;
    Image out;
    for (std::uint32_t i = 0; i < 20; ++i)
        add(upscaler, shoot(plain, plain, glm::vec2(0.013f) * static_cast<float>(i), i), Jobs(1), out);
    for (const glm::vec3& pixel : out.pixels) EXPECT_NEAR(pixel.x, 0.64f, 1e-6f);
}

TEST(TemporalDouble, ALampSwitchedOffIsDarkInTheNextPicture) {
    filter::TemporalUpscaler upscaler;
    Image out;
    for (std::uint32_t i = 0; i < 30; ++i) add(upscaler, shoot(bars, bars, glm::vec2(0.0f), i), Jobs(1), out);
    add(upscaler,
        shoot(
            bars, [](const glm::vec2&) { return 0.0f; }, glm::vec2(0.0f), 30),
        Jobs(1), out);
    for (const glm::vec3& pixel : out.pixels) EXPECT_EQ(pixel, glm::vec3(0.0f));
}

// Somebody dark walks by before a bright wall, a small pixel a picture: beside him stays nothing of him. Two large pixels
// at his edge lie between samples of both.
TEST(TemporalDouble, WhatSomethingThatWalkedOnHidIsShownAtOnce) {
    filter::TemporalUpscaler upscaler;
    Image out;
    for (int frame = 0; frame < 16; ++frame) {
        Shot shot = shoot(plain, plain, glm::vec2(0.0f), static_cast<std::uint32_t>(frame));
        shot.previous = shot.position;
        for (int y = 0; y < kSmall.y; ++y) {
            for (int x = 20 + frame; x < 36 + frame; ++x) {
                const std::size_t at = static_cast<std::size_t>(y * kSmall.x + x);
                shot.part[at] = 9;
                shot.previous[at] = shot.position[at] - shot.seen.lens.right;
            }
        }
        for (int v = 0; v < kHeight; ++v) {
            for (int u = 0; u < kWidth; ++u) {
                if (shot.part[shot.place(u, v)] == 9) shot.radiance.at(u, v) *= 0.02f;
            }
        }
        add(upscaler, shot, Jobs(1), out);
        if (frame == 0) continue;  // before it nothing moved
        for (int x = 0; x < kLarge.x; ++x) {
            if (x >= 2 * (20 + frame) - 3 && x < 2 * (36 + frame) + 3) continue;
            ASSERT_NEAR(out.at(x, kSmall.y).x, 0.64f, 0.01f) << frame << ' ' << x;
        }
    }
}

// Threads and instruction sets do not matter; a picture may become smaller, or no longer be doubled, and what was seen is
// kept; what is no number does not spread.
TEST(TemporalDouble, IsTheSameEverywhereWhateverIsAskedOfIt) {
    const auto run = [](int threads) {
        const Jobs jobs(threads);
        filter::TemporalUpscaler upscaler;
        std::vector<glm::vec3> all;
        for (std::uint32_t i = 0; i < 9; ++i) {
            Shot shot = shoot(bars, bars, glm::vec2(0.01f) * static_cast<float>(i), i);
            shot.position[2021] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
            shot.radiance.at(11, 12) = glm::vec3(std::numeric_limits<float>::quiet_NaN());
            Image out;
            filter::GuidedFrame frame = shot.frame();
            frame.doubles = i / 3 != 1;
            upscaler.add(frame, jobs, out);
            EXPECT_EQ(out.width, frame.doubles ? kLarge.x : kSmall.x);
            all.insert(all.end(), out.pixels.begin(), out.pixels.end());
        }
        return all;
    };
    const auto one = run(1);
    for (const glm::vec3& pixel : one) ASSERT_TRUE(std::isfinite(pixel.x));
    EXPECT_EQ(one, run(3));
    for (const std::string& isa : filter::isa_names()) {
        ASSERT_TRUE(filter::use_isa(isa));
        EXPECT_EQ(one, run(1)) << isa;
    }
    filter::use_isa("");
}

}  // namespace
}  // namespace gh
