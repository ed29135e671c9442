// Small pictures added up must become the large picture they were taken of, follow it when the camera moves, and let go
// of it at once when it changes: a lamp that was switched off must not glow on.
#include "filter/temporal_upscale.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace gh {
namespace {

constexpr int kWidth = 40, kHeight = 30;

// A wall at z = -1 seen through a lens that looks along -z; its colour is a function of the place on it.
using Wall = std::function<float(const glm::vec2&)>;

filter::Pinhole lens_at(const glm::vec2& eye, int width, int height) {
    return {.eye = glm::vec3(eye, 0.0f),
            .corner = {-1.0f, 0.75f, -1.0f},
            .right = {2.0f / static_cast<float>(width), 0, 0},
            .down = {0, -1.5f / static_cast<float>(height), 0}};
}

glm::vec3 on_wall(const filter::Pinhole& lens, const glm::vec2& at) {
    return lens.eye + lens.corner + lens.right * at.x + lens.down * at.y;
}

struct Shot {
    Image radiance{kWidth, kHeight};
    filter::Pinhole lens;
    glm::vec2 jitter;
    std::vector<std::uint32_t> part;
    std::vector<glm::vec3> position;

    [[nodiscard]] filter::JitteredFrame frame() const {
        return {radiance, lens, jitter, part, position, position};
    }
};

Shot shoot(const Wall& wall, const glm::vec2& eye, std::uint32_t number) {
    Shot shot;
    shot.lens = lens_at(eye, kWidth, kHeight);
    shot.jitter = filter::halton_jitter(number);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const glm::vec3 p = on_wall(shot.lens, glm::vec2(x, y) + 0.5f + shot.jitter);
            shot.radiance.at(x, y) = glm::vec3(wall(glm::vec2(p)));
            shot.part.push_back(7);
            shot.position.push_back(p);
        }
    }
    return shot;
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

// Slanted bars a little wider than a small pixel: a small picture alone can not show their edges.
float bars(const glm::vec2& p) {
    return std::sin(25.0f * p.x + 9.0f * p.y) > 0.0f ? 0.9f : 0.2f;
}

TEST(TemporalUpscale, AStillPictureSharpensIntoTheLargeOne) {
    filter::TemporalUpscaler upscaler;
    const Jobs jobs(1);
    const glm::ivec2 size(2 * kWidth, 2 * kHeight);
    const Image wanted = truth(bars, glm::vec2(0.0f), size.x, size.y);
    Image out;
    upscaler.add(shoot(bars, glm::vec2(0.0f), 0).frame(), size, jobs, out);
    const double first = error(out, wanted);
    for (std::uint32_t i = 1; i < 48; ++i)
        upscaler.add(shoot(bars, glm::vec2(0.0f), i).frame(), size, jobs, out);
    EXPECT_LT(error(out, wanted), 0.5 * first);
}

// Bars in front of a wall, each a thing of its own: a pixel at their edges shows now one and now the other. While neither
// the eye nor the bars move both belong to the picture, and the edge stands as still as a painted one.
TEST(TemporalUpscale, AnEdgeBetweenThingsThatStandStillStandsStill) {
    const Jobs jobs(1);
    const glm::ivec2 size(kWidth, kHeight);
    double change[2] = {0.0, 0.0};
    for (const bool are_apart : {false, true}) {
        filter::TemporalUpscaler upscaler;
        Image out, before;
        for (std::uint32_t i = 0; i < 64; ++i) {
            Shot shot = shoot(bars, glm::vec2(0.0f), i);
            for (std::size_t k = 0; k < shot.position.size() && are_apart; ++k) {
                if (shot.radiance.pixels[k].x < 0.5f) continue;
                shot.part[k] = 8;
                shot.position[k] = shot.lens.eye + 0.5f * (shot.position[k] - shot.lens.eye);
            }
            before = out;
            upscaler.add(shot.frame(), size, jobs, out);
            if (i >= 32) change[are_apart ? 1 : 0] += error(out, before);
        }
    }
    EXPECT_LT(change[1], 1.01 * change[0]) << "of the picture from frame to frame";
}

TEST(TemporalUpscale, WhatMovesUnderTheCameraIsCarriedAlong) {
    filter::TemporalUpscaler upscaler;
    const Jobs jobs(1);
    const glm::ivec2 size(2 * kWidth, 2 * kHeight);
    Image out;
    glm::vec2 eye(0.0f);
    double alone = 0.0;
    for (std::uint32_t i = 0; i < 32; ++i, eye += glm::vec2(0.013f, 0.004f)) {
        const Shot shot = shoot(bars, eye, i);
        upscaler.add(shot.frame(), size, jobs, out);
        filter::TemporalUpscaler single;
        Image one;
        single.add(shot.frame(), size, jobs, one);
        alone = error(one, truth(bars, eye, size.x, size.y));
    }
    eye -= glm::vec2(0.013f, 0.004f);
    EXPECT_LT(error(out, truth(bars, eye, size.x, size.y)), 0.8 * alone);
}

// A grey post half-way to the wall and of one part with it, as everything that stands still may be.
constexpr float kPostHalfWidth = 0.08f;

bool is_post(const glm::vec3& on_the_wall, const glm::vec3& eye) {
    return std::abs(0.5f * (on_the_wall.x + eye.x)) < kPostHalfWidth;
}

Shot shoot_with_post(const glm::vec2& eye, std::uint32_t number) {
    Shot shot = shoot(bars, eye, number);
    for (std::size_t i = 0; i < shot.position.size(); ++i) {
        if (!is_post(shot.position[i], shot.lens.eye)) continue;
        shot.position[i] = 0.5f * (shot.position[i] + shot.lens.eye);
        shot.radiance.pixels[i] = glm::vec3(0.55f);
    }
    return shot;
}

// The bars behind are both darker and brighter than the post, so that colours alone can not tell its trace from them.
TEST(TemporalUpscale, WhatAPostUncoversKeepsNoTraceOfIt) {
    filter::TemporalUpscaler upscaler;
    const Jobs jobs(1);
    const glm::ivec2 size(2 * kWidth, 2 * kHeight);
    constexpr float kStep = 0.04f;  // the post slides by 1.6 large pixels a frame along the wall
    constexpr std::uint32_t kFrames = 24;
    Image out, one;
    for (std::uint32_t i = 0; i < kFrames; ++i) {
        const Shot shot = shoot_with_post(glm::vec2(kStep * static_cast<float>(i) - 0.5f, 0.0f), i);
        upscaler.add(shot.frame(), size, jobs, out);
        filter::TemporalUpscaler().add(shot.frame(), size, jobs, one);
    }
    const glm::vec2 eye(kStep * static_cast<float>(kFrames - 1) - 0.5f, 0.0f);
    const glm::vec3 before(eye.x - 3.0f * kStep, eye.y, 0.0f);
    const filter::Pinhole lens = lens_at(eye, size.x, size.y);
    const Image wanted = truth(bars, eye, size.x, size.y);
    double added = 0.0, alone = 0.0;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const glm::vec3 p = on_wall(lens, glm::vec2(x, y) + 0.5f);
            if (is_post(p, lens.eye) || !is_post(p, before)) continue;
            added += std::abs(static_cast<double>(out.at(x, y).x - wanted.at(x, y).x));
            alone += std::abs(static_cast<double>(one.at(x, y).x - wanted.at(x, y).x));
        }
    }
    // Beside what was just uncovered the sharp filter still reaches into the post: a fifth more than without a past. With
    // the post's past it was three times as much.
    EXPECT_LT(added, 1.5 * alone);
}

TEST(TemporalUpscale, AConstantStaysExactlyThat) {
    filter::TemporalUpscaler upscaler;
    Image out;
    const Wall grey = [](const glm::vec2&) { return 0.37f; };
    for (std::uint32_t i = 0; i < 20; ++i) {
        upscaler.add(shoot(grey, glm::vec2(0.02f) * static_cast<float>(i), i).frame(), {77, 53}, Jobs(1),
                     out);
    }
    for (const glm::vec3& pixel : out.pixels) EXPECT_NEAR(pixel.x, 0.37f, 1e-6f);
}

// The colours around a pixel bound what is believed of its past: with all of them 0, so is it.
TEST(TemporalUpscale, ALampSwitchedOffIsDarkInTheNextPicture) {
    filter::TemporalUpscaler upscaler;
    Image out;
    for (std::uint32_t i = 0; i < 30; ++i)
        upscaler.add(shoot(bars, glm::vec2(0.0f), i).frame(), {80, 60}, Jobs(1), out);
    const Wall dark = [](const glm::vec2&) { return 0.0f; };
    upscaler.add(shoot(dark, glm::vec2(0.0f), 30).frame(), {80, 60}, Jobs(1), out);
    for (const glm::vec3& pixel : out.pixels) EXPECT_EQ(pixel, glm::vec3(0.0f));
}

TEST(TemporalUpscale, ASampleThatIsNoNumberIsForgotten) {
    filter::TemporalUpscaler upscaler;
    Image out;
    for (std::uint32_t i = 0; i < 4; ++i) {
        Shot shot = shoot(bars, glm::vec2(0.0f), i);
        shot.radiance.at(11, 12) = glm::vec3(std::numeric_limits<float>::quiet_NaN());
        shot.position[20] = glm::vec3(std::numeric_limits<float>::infinity());
        upscaler.add(shot.frame(), {80, 60}, Jobs(1), out);
        for (const glm::vec3& pixel : out.pixels) EXPECT_TRUE(std::isfinite(pixel.x));
    }
}

TEST(TemporalUpscale, ThreadsDoNotMatterAndSizesMayChange) {
    const auto run = [](int threads) {
        const Jobs jobs(threads);
        filter::TemporalUpscaler upscaler;
        Image out;
        for (std::uint32_t i = 0; i < 6; ++i) {
            const glm::ivec2 size = i < 3 ? glm::ivec2(80, 60) : glm::ivec2(64, 50);
            upscaler.add(shoot(bars, glm::vec2(0.01f) * static_cast<float>(i), i).frame(), size, jobs, out);
        }
        return out.pixels;
    };
    const auto one = run(1);
    EXPECT_EQ(one.size(), 64u * 50u);
    EXPECT_EQ(one, run(3));
}

}  // namespace
}  // namespace gh
