// The whole chain where something changes: a lamp goes out, a guard walks past, the picture gets another size.
#include "filter/anti_lag.h"
#include "filter/denoiser.h"
#include "filter/synthetic.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gh {
namespace {

using filter::Denoiser;
using filter::Plane;
using filter::Plane3;

constexpr int kWidth = 96, kHeight = 64;

// The verb of the game: a lamp is switched off after two seconds in its light.
int frames_until_dark(bool change_is_known, bool settles) {
    Denoiser denoiser;
    const Jobs jobs(1);
    test::Room room;
    Plane3 out;
    const filter::DenoiseSettings settings{.settles = settles};
    const auto mean_light = [&] {
        double sum = 0.0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) sum += static_cast<double>(out.luminance_at(x, y));
        }
        return sum;
    };
    room.sky = 0.0f;
    std::uint32_t frame_number = 0;
    for (; frame_number < 40; ++frame_number) {
        const test::Frame frame = test::render(room, kWidth, kHeight, frame_number);
        denoiser.denoise(frame.surfaces, frame.noisy, settings, jobs, out);
    }
    const double lit = mean_light();
    room.lamp_power = 0.0f;
    for (int dark_frames = 1; dark_frames < 60; ++dark_frames) {
        test::Frame frame = test::render(room, kWidth, kHeight, frame_number++);
        if (change_is_known && dark_frames == 1) {
            const Plane now(kWidth, kHeight, 0.0f), then(kWidth, kHeight, 1.0f);
            filter::lamp_change(now, then, jobs, frame.noisy.direct_change);
            frame.noisy.indirect_change = frame.noisy.direct_change;
        }
        denoiser.denoise(frame.surfaces, frame.noisy, settings, jobs, out);
        if (mean_light() < 0.1 * lit) return dark_frames;
    }
    return 60;
}

TEST(Denoiser, ALampSwitchedOffIsDarkAtOnceWhenTheRendererSaysSoAndSoonWhenItDoesNot) {
    EXPECT_EQ(frames_until_dark(true, true), 1);
    EXPECT_EQ(frames_until_dark(true, false), 1);
    // Nobody said anything, and the light's noise is 1.8 times the light: two standard errors of 75 samples are 0.42 of
    // it, which have to be waited for.
    EXPECT_LE(frames_until_dark(false, true), 7);
    // Without either the mean of 32 frames needs ln 0.1 / ln (31/32) = 73 of them: the tests above can fail.
    EXPECT_EQ(frames_until_dark(false, false), 60);
}

// A guard walks past: behind him the wall must be as clean as elsewhere, neither darkened by his picture nor by the
// shadow he took along.
TEST(Denoiser, AMovingBallLeavesNoGhost) {
    Denoiser denoiser;
    const Jobs jobs(1);
    test::Room room;
    room.ball.x = 1.6f;
    Plane3 out;
    test::Frame frame;
    constexpr float kStep = 0.06f;
    for (std::uint32_t i = 0; i < 40; ++i) {
        room.ball_before = room.ball;
        room.ball.x -= kStep;
        frame = test::render(room, kWidth, kHeight, i);
        denoiser.denoise(frame.surfaces, frame.noisy, {}, jobs, out);
    }
    // Where the ball was five to fifteen frames ago and is no more.
    const Plane3 truth = test::total(frame.truth);
    test::Room before = room;
    before.ball.x += 10.0f * kStep;
    const test::Frame past = test::render(before, kWidth, kHeight, 99);
    double ghost = 0.0, wanted = 0.0, bright_ghost = 0.0;
    int count = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (past.surfaces.part.at(x, y) != test::kBall || frame.surfaces.part.at(x, y) == test::kBall)
                continue;
            ghost +=
                static_cast<double>(out.luminance_at(x, y)) - static_cast<double>(truth.luminance_at(x, y));
            bright_ghost += static_cast<double>(test::total(past.truth).luminance_at(x, y)) -
                            static_cast<double>(truth.luminance_at(x, y));
            wanted += static_cast<double>(truth.luminance_at(x, y));
            ++count;
        }
    }
    ASSERT_GT(count, 40);
    ASSERT_GT(std::abs(bright_ghost), 0.3 * wanted) << "the ball looks like the wall; nothing to see";
    EXPECT_LT(std::abs(ghost), 0.1 * wanted);
}

TEST(Denoiser, AChangeOfThePicturesSizeKeepsWhatWasLearnt) {
    const Jobs jobs(1);
    const test::Room room;
    Denoiser denoiser;
    Plane3 out;
    for (std::uint32_t i = 0; i < 12; ++i) {
        const test::Frame frame = test::render(room, kWidth, kHeight, i);
        denoiser.denoise(frame.surfaces, frame.noisy, {}, jobs, out);
    }
    const test::Frame larger = test::render(room, 120, 80, 50);
    denoiser.denoise(larger.surfaces, larger.noisy, {}, jobs, out);
    double length = 0.0;
    int surfaces = 0;
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 120; ++x) {
            if (larger.surfaces.part.at(x, y) == filter::kNoSurface) continue;
            length += static_cast<double>(denoiser.history_length().at(x, y));
            ++surfaces;
        }
    }
    EXPECT_GT(length / surfaces, 9.0);
    denoiser.forget();
    denoiser.denoise(larger.surfaces, larger.noisy, {}, jobs, out);
    EXPECT_EQ(denoiser.history_length().at(60, 60), 1.0f);
}

}  // namespace
}  // namespace gh
