// Soft light worked out at half the sides must come back as it was, and on its own surfaces alone: a lit wall must not glow
// through the edge of the guard before it, nor a thin bar before the sky go dark.
#include "filter/halve.h"

#include "filter/denoiser.h"
#include "filter/isa.h"
#include "filter/planes.h"
#include "filter/synthetic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

namespace gh {
namespace {

using filter::Plane3;

// Halved, and widened again.
Plane3 there_and_back(const filter::GBuffer& surfaces, const Plane3& samples, const Jobs& jobs) {
    const int width = surfaces.width(), height = surfaces.height();
    const filter::Guides guides = test::guides_of(surfaces);
    filter::Halved half;
    const filter::Light light;
    half.fit(surfaces, light, samples, {});
    filter::run_rows((height + 1) / 2, jobs,
                     filter::halve_rows(surfaces, guides, light, samples, light.specular, half));
    filter::Luma3 small;
    filter::luma_from(half.light.indirect, jobs, small);
    const filter::Guides small_guides = test::guides_of(half.surfaces);
    Plane3 out = samples;
    EXPECT_EQ(small_guides.width(), (width + 1) / 2);
    filter::run_rows(height, jobs,
                     filter::widen_rows({.light = {&small, nullptr}, .out = {&out, nullptr}}, small_guides,
                                        half.surfaces.part, guides, surfaces.part));
    filter::colour_from(out, jobs, out);
    return out;
}

TEST(Halve, AConstantComesBackAtAnySize) {
    for (const auto& [width, height] :
         {std::pair(64, 32), std::pair(61, 33), std::pair(17, 1), std::pair(2, 7)}) {
        const Plane3 even(width, height, {3.0f, 0.5f, 0.25f});
        const Plane3 out = there_and_back(test::stepped_wall(width, height), even, Jobs(1));
        EXPECT_LT(test::largest_difference(out, even), 2e-6f) << width << 'x' << height;
    }
}

// The near half is dark, the far half is bright; the step lies between columns 30 and 31, inside a block.
TEST(Halve, LightStaysOnItsSideOfAStepThatCutsThroughBlocks) {
    constexpr int kWidth = 62, kHeight = 20;
    const filter::GBuffer surfaces = test::stepped_wall(kWidth, kHeight);
    Plane3 samples(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = kWidth / 2; x < kWidth; ++x) samples.set(x, y, glm::vec3(1.0f));
    }
    EXPECT_LT(test::largest_difference(there_and_back(surfaces, samples, Jobs(2)), samples), 1e-4f);
}

// A bar one pixel wide that no block stands for: there is sky in all of them.
TEST(Halve, AThinBarBeforeTheSkyKeepsItsOwnLight) {
    constexpr int kWidth = 40, kHeight = 24, kBar = 17;
    filter::GBuffer surfaces = test::stepped_wall(kWidth, kHeight);
    Plane3 samples(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (x != kBar) surfaces.part.at(x, y) = filter::kNoSurface;
        }
        samples.set(kBar, y, {0.5f, 0.4f, 0.3f});
    }
    const Plane3 out = there_and_back(surfaces, samples, Jobs(1));
    for (int y = 0; y < kHeight; ++y) {
        EXPECT_NEAR(out.get(kBar, y).y, 0.4f, 1e-5f);
        EXPECT_EQ(out.get(kBar + 1, y).y, 0.0f);
    }
}

// Whatever is halved: every instruction set, any number of threads, an odd size, a walk past a ball that moves.
TEST(Halve, DenoisingMakesTheSameBitsHoweverItIsRun) {
    const auto walk = [](const Jobs& jobs) {
        filter::Denoiser denoiser;
        test::Room room;
        Plane3 out;
        for (std::uint32_t i = 0; i < 4; ++i) {
            room.ball_before = room.ball;
            room.ball.x -= 0.07f;
            room.eye.z -= 0.03f;
            const test::Frame frame = test::render(room, 93, 61, i);
            denoiser.denoise(frame.surfaces, frame.noisy,
                             {.halves_indirect = true, .halves_specular = true, .adds_up = true}, jobs, out);
        }
        return out;
    };
    const Plane3 best = walk(Jobs(1));
    EXPECT_EQ(test::largest_difference(walk(Jobs(5)), best), 0.0f);
    for (const std::string& isa : filter::isa_names()) {
        ASSERT_TRUE(filter::use_isa(isa));
        EXPECT_EQ(test::largest_difference(walk(Jobs(2)), best), 0.0f) << isa;
    }
    filter::use_isa("");
}

// Half as much noise is left at half the sides as at all of them, or nearly: four samples are one to begin with.
TEST(Halve, LeavesNoMoreNoiseThanLightAtItsFullSize) {
    double left[2] = {};
    for (const bool halves : {false, true}) {
        filter::Denoiser denoiser;
        test::Room room;
        Plane3 out;
        test::Frame frame;
        for (std::uint32_t i = 0; i < 8; ++i) {
            room.eye.x += 0.01f;
            frame = test::render(room, 96, 64, i);
            frame.noisy.direct = frame.truth.direct;
            frame.noisy.specular = frame.truth.specular;
            denoiser.denoise(frame.surfaces, frame.noisy, {.halves_indirect = halves}, Jobs(1), out);
        }
        left[halves ? 1 : 0] = test::rel_mse(out, test::total(frame.truth));
    }
    EXPECT_LT(left[1], 1.2 * left[0]);
}

// Rows of half a picture among those of a whole one: nobody reads what is not there yet.
TEST(Halve, HalvedPassesFindWhatWasLeftForThem) {
    for (const int threads : {1, 3, 20}) {
        for (const int height : {1, 2, 7, 90, 181, 360}) {
            const int small = (height + 1) / 2;
            std::vector<std::atomic<int>> whole(static_cast<std::size_t>(height)),
                half(static_cast<std::size_t>(small));
            std::atomic<int> wrong = 0, calls = 0;
            const auto needs = [&](std::vector<std::atomic<int>>& rows, int first, int last, int pass) {
                for (int at = std::max(first, 0); at <= std::min(last, static_cast<int>(rows.size()) - 1);
                     ++at)
                    wrong += rows[static_cast<std::size_t>(at)] < pass;
            };
            filter::RowPasses passes, halved;
            passes.begin(0);
            passes.add([&](int y) { whole[static_cast<std::size_t>(y)] = 1; });
            for (int pass = 1; pass <= 3; ++pass) {
                halved.begin(pass == 1 ? 0 : 2 * pass);
                halved.add([&, pass](int v) {
                    if (pass == 1) needs(whole, 2 * v, 2 * v + 1, 1);
                    if (pass > 1) needs(half, v - 2 * pass, v + 2 * pass, pass - 1);
                    half[static_cast<std::size_t>(v)] = pass;
                    ++calls;
                });
            }
            passes.add_halved(std::move(halved), height, 1);
            passes.begin(filter::kWidenReach);
            passes.add([&](int y) { needs(half, (y + 1) / 2 - 1, (y + 1) / 2, 3); });
            passes.run(height, Jobs(threads));
            EXPECT_EQ(wrong, 0) << height << " rows, " << threads << " threads";
            EXPECT_EQ(calls, 3 * small);
        }
    }
}

}  // namespace
}  // namespace gh
