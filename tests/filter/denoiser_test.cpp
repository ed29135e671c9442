// The whole chain on a room whose light is known: what a player would see of it.
#include "filter/denoiser.h"

#include "base/random.h"
#include "filter/isa.h"
#include "filter/synthetic.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gh {
namespace {

using filter::Denoiser;
using filter::Plane;
using filter::Plane3;

constexpr int kWidth = 96, kHeight = 64;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

bool same_bits(const Plane3& a, const Plane3& b) {
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            if (!(a.get(x, y) == b.get(x, y))) return false;  // NaN is a difference too
        }
    }
    return a.width() == b.width() && a.height() == b.height();
}

// Five frames of a walk past a moving ball.
Plane3 walk(const Jobs& jobs) {
    Denoiser denoiser;
    test::Room room;
    Plane3 out;
    for (std::uint32_t i = 0; i < 5; ++i) {
        room.ball_before = room.ball;
        room.ball.x -= 0.07f;
        room.eye.z -= 0.03f;
        room.yaw += 0.01f;
        const test::Frame frame =
            test::render(room, kWidth - 3, kHeight, i);  // not a whole number of vectors
        denoiser.denoise(frame.surfaces, frame.noisy, {}, jobs, out);
    }
    return out;
}

TEST(Denoiser, EveryInstructionSetAndAnyNumberOfThreadsMakeTheSameBits) {
    const Plane3 best = walk(Jobs(1));
    EXPECT_TRUE(same_bits(walk(Jobs(3)), best)) << "three threads";
    const std::vector<std::string> isas = filter::isa_names();
    ASSERT_GE(isas.size(), 2u) << "nothing to compare with";
    for (const std::string& isa : isas) {
        ASSERT_TRUE(filter::use_isa(isa));
        EXPECT_TRUE(same_bits(walk(Jobs(2)), best)) << isa;
    }
    filter::use_isa("");
}

TEST(Denoiser, LeavesATwentiethOfTheNoiseAndLessWithEveryFrameOfAWalk) {
    Denoiser denoiser;
    const Jobs jobs(1);
    test::Room room;
    Plane3 out;
    double first_gain = 0.0, last_gain = 0.0;
    for (std::uint32_t i = 0; i < 10; ++i) {
        room.eye.x += 0.01f;
        room.yaw += 0.003f;
        const test::Frame frame = test::render(room, kWidth, kHeight, i);
        denoiser.denoise(frame.surfaces, frame.noisy, {}, jobs, out);
        const Plane3 truth = test::total(frame.truth);
        last_gain = test::rel_mse(test::total(frame.noisy), truth) / test::rel_mse(out, truth);
        if (i == 0) first_gain = last_gain;
    }
    EXPECT_GT(first_gain, 5.0) << "a first frame has nothing but its neighbours";
    EXPECT_GT(last_gain, 20.0);
}

// Who renders one picture has nothing to add up, and sees the blotches that the next frames would take away.
TEST(Denoiser, AStillPictureIsSmoothedFurtherThanAFrameOfManyAndErrsLess) {
    const Jobs jobs(1);
    const test::Frame frame = test::render({}, kWidth, kHeight, 0);
    const Plane3 truth = test::total(frame.truth);
    double left[2] = {};
    for (const int more : {0, 2}) {
        Plane3 out;
        Denoiser().denoise(frame.surfaces, frame.noisy, {.more_levels_at_first = more}, jobs, out);
        left[more / 2] = test::rel_mse(out, truth);
    }
    EXPECT_LT(left[1], 0.9 * left[0]);
    Denoiser wide, narrow;
    Plane3 a, b;
    for (int i = 0; i < 2; ++i) {
        wide.denoise(frame.surfaces, frame.noisy, {.more_levels_at_first = 2}, jobs, a);
        narrow.denoise(frame.surfaces, frame.noisy, {.more_levels_at_first = 0}, jobs, b);
    }
    EXPECT_TRUE(same_bits(a, b)) << "the second frame is like any other";
}

// A room in constant light: whatever the filter does with weights, light times albedo must come out again. The chain
// rounds about thirty times on the way; 1e-5 is a hundred roundings.
TEST(Denoiser, ConstantLightOnATextureComesOutAsItWentIn) {
    Denoiser denoiser;
    const Jobs jobs(1);
    test::Room room;
    Plane3 out;
    for (std::uint32_t i = 0; i < 6; ++i) {
        room.eye.x += 0.02f;
        test::Frame frame = test::render(room, kWidth, kHeight, i);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const bool sky = frame.surfaces.part.at(x, y) == filter::kNoSurface;
                const glm::vec3 albedo = frame.surfaces.albedo.get(x, y);
                frame.noisy.direct.set(x, y, sky ? glm::vec3(0.0f) : albedo * glm::vec3(3.0f, 2.0f, 0.5f));
                frame.noisy.indirect.set(x, y, sky ? glm::vec3(0.0f) : albedo * 0.25f);
                frame.noisy.specular.set(x, y, sky ? glm::vec3(0.0f) : glm::vec3(0.125f));
            }
        }
        denoiser.denoise(frame.surfaces, frame.noisy, {}, jobs, out);
        const Plane3 wanted = test::total(frame.noisy);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const glm::vec3 off = glm::abs(out.get(x, y) - wanted.get(x, y));
                ASSERT_LT(std::max({off.x, off.y, off.z}), 1e-5f * (0.1f + wanted.get(x, y).x))
                    << x << ' ' << y;
            }
        }
    }
}

// A matt hob let into a varnished worktop: one plane, one nearness, one normal. What the varnish mirrors, noisily, must
// not shine on the hob, neither by way of its neighbours nor by way of the past of a jittered edge.
TEST(Denoiser, WhatVarnishMirrorsDoesNotShineOnTheMattPlateLetIntoIt) {
    Denoiser denoiser;
    const Jobs jobs(1);
    const test::Room room;
    Random random(5);
    Plane3 out;
    const auto is_plate = [](int x, int y, std::uint32_t frame) {
        const int left =
            40 + static_cast<int>(frame % 2);  // jitter shows now one side of its edge, now the other
        return x >= left && x < left + 8 && y >= 36 && y < 44;
    };
    for (std::uint32_t i = 0; i < 8; ++i) {
        test::Frame frame = test::render(room, kWidth, kHeight, i);
        frame.surfaces.gloss = Plane3(kWidth, kHeight);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const bool plate = is_plate(x, y, i);
                if (plate) frame.surfaces.part.at(x, y) += 1000;
                frame.surfaces.gloss.set(x, y, glm::vec3(plate ? 0.04f : 0.8f));
                const float mirrored = random.unit() < 0.25f ? 4.0f : 0.0f;
                frame.noisy.specular.set(x, y, glm::vec3(plate ? 0.01f : mirrored));
                frame.noisy.direct.set(x, y, glm::vec3(0.0f));
                frame.noisy.indirect.set(x, y, glm::vec3(0.0f));
                frame.noisy.clean.set(x, y, glm::vec3(0.0f));
            }
        }
        denoiser.denoise(frame.surfaces, frame.noisy, {}, jobs, out);
        for (int y = 36; y < 44; ++y) {
            for (int x = 40; x < 48; ++x) {
                if (is_plate(x, y, i)) {
                    EXPECT_NEAR(out.get(x, y).y, 0.01f, 1e-3f) << x << ' ' << y << " frame " << i;
                }
            }
        }
    }
    EXPECT_NEAR(out.get(30, 40).y, 1.0f, 0.7f) << "the varnish itself is smoothed";
}

TEST(Denoiser, KeepsTheEnergyOfASkewedNoise) {
    Denoiser denoiser;
    const Jobs jobs(1);
    const test::Room room;
    Plane3 out;
    double found = 0.0, truth = 0.0;
    for (std::uint32_t i = 0; i < 24; ++i) {
        const test::Frame frame = test::render(room, kWidth, kHeight, i);
        denoiser.denoise(frame.surfaces, frame.noisy, {}, jobs, out);
        if (i < 8) continue;
        const Plane3 wanted = test::total(frame.truth);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                found += static_cast<double>(out.luminance_at(x, y));
                truth += static_cast<double>(wanted.luminance_at(x, y));
            }
        }
    }
    // Sixteen frames, of which the means share samples: about 24 independent samples at each of 6144 pixels, relative
    // deviation of one about 1.8, so four standard errors are 2 %. What settle() may lose must stay within that.
    EXPECT_NEAR(found / truth, 1.0, 0.02);
}

TEST(Denoiser, WhatIsNotANumberIsMendedAndReachesNobody) {
    const Jobs jobs(1);
    const test::Room room;
    Denoiser clean_denoiser, denoiser;
    Plane3 clean, out;
    for (std::uint32_t i = 0; i < 6; ++i) {
        const test::Frame good = test::render(room, kWidth, kHeight, i);
        test::Frame bad = good;
        bad.noisy.direct.set(40, 40, glm::vec3(kNan));
        bad.noisy.indirect.set(50, 40, {1.0f, std::numeric_limits<float>::infinity(), 0.0f});
        bad.noisy.specular.set(45, 60, {-1.0f, 0.0f, 0.0f});
        bad.surfaces.position.set(20, 50, glm::vec3(kNan));
        bad.surfaces.normal.set(70, 50, glm::vec3(kNan));
        bad.surfaces.albedo.set(60, 50, {kNan, 0.5f, 0.5f});
        bad.surfaces.roughness.at(30, 60) = kNan;
        bad.surfaces.reflected.at(31, 60) = kNan;
        bad.surfaces.previous.set(32, 60, glm::vec3(kNan));
        clean_denoiser.denoise(good.surfaces, good.noisy, {}, jobs, clean);
        denoiser.denoise(bad.surfaces, bad.noisy, {}, jobs, out);
    }
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const glm::vec3 c = out.get(x, y);
            ASSERT_TRUE(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z)) << x << ' ' << y;
        }
    }
    // The mended pixel looks like the room, though none of its own samples ever counted.
    EXPECT_NEAR(out.luminance_at(40, 40), clean.luminance_at(40, 40),
                0.25f * clean.luminance_at(40, 40) + 0.01f);
    EXPECT_EQ(out.get(5, 5), clean.get(5, 5)) << "far away nothing changed";
}

TEST(Denoiser, TakesEmptyLightsAndAnEmptyPicture) {
    const Jobs jobs(1);
    Denoiser denoiser;
    Plane3 out;
    denoiser.denoise({}, {}, {}, jobs, out);
    EXPECT_TRUE(out.empty());
    test::Frame frame = test::render({}, kWidth, kHeight, 0);
    frame.noisy.specular = {};
    frame.noisy.indirect = {};
    denoiser.denoise(frame.surfaces, frame.noisy, {}, jobs, out);
    const float direct_only = out.luminance_at(48, 50);
    EXPECT_GT(direct_only, 0.0f);
    frame.noisy.direct = {};
    denoiser.denoise(frame.surfaces, frame.noisy, {}, jobs, out);
    EXPECT_EQ(out.get(48, 50), frame.noisy.clean.get(48, 50));
}

// Pictures may be filled row by row as the filters come to them, and the film's is put together as they leave: nobody may
// look at a row before it is there.
TEST(Denoiser, RowsThatAreFilledAndTakenAsTheyAreNeededGiveTheSameBits) {
    for (const int threads : {1, 3}) {
        const Jobs jobs(threads);
        Denoiser whole, by_rows;
        test::Room room;
        Plane3 expected, out;
        for (std::uint32_t i = 0; i < 4; ++i) {
            const test::Frame frame = test::render(room, kWidth, kHeight, i);
            room.eye.x += 0.02f;
            whole.denoise(frame.surfaces, frame.noisy, {}, jobs, expected);
            test::Frame late = frame;
            late.noisy.direct = late.noisy.indirect = late.noisy.specular =
                Plane3(kWidth, kHeight, glm::vec3(kNan));
            late.surfaces.position = late.surfaces.normal = Plane3(kWidth, kHeight, glm::vec3(kNan));
            Plane3 taken(kWidth, kHeight);
            const auto copy = [](const Plane3& from, int y, Plane3& to) {
                for (int x = 0; x < kWidth; ++x) to.set(x, y, from.get(x, y));
            };
            by_rows.denoise(late.surfaces, late.noisy, {}, jobs, out,
                            {.before =
                                 [&](int y) {
                                     copy(frame.noisy.direct, y, late.noisy.direct);
                                     copy(frame.noisy.indirect, y, late.noisy.indirect);
                                     copy(frame.noisy.specular, y, late.noisy.specular);
                                     copy(frame.surfaces.position, y, late.surfaces.position);
                                     copy(frame.surfaces.normal, y, late.surfaces.normal);
                                 },
                             .after = [&](int y) { copy(out, y, taken); }});
            ASSERT_TRUE(same_bits(out, expected)) << "frame " << i << ", " << threads << " threads";
            ASSERT_TRUE(same_bits(taken, expected)) << "frame " << i << ", " << threads << " threads";
        }
    }
}

}  // namespace
}  // namespace gh
