#include "input/command.h"

#include "base/det_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gh::input {
namespace {

TEST(Command, EveryYawSurvivesTheWayThroughRadians) {
    for (int yaw = -32768; yaw <= 32767; ++yaw) {
        const auto unit = static_cast<std::int16_t>(yaw);
        ASSERT_EQ(quantise_yaw(yaw_radians(unit)), unit);
        ASSERT_EQ(quantise_yaw(yaw_radians(unit) + kTwoPi), unit);
    }
}

TEST(Command, EveryPitchSurvivesTheWayThroughRadians) {
    for (int pitch = -kMaxPitch; pitch <= kMaxPitch; ++pitch) {
        const auto unit = static_cast<std::int16_t>(pitch);
        ASSERT_EQ(quantise_pitch(pitch_radians(unit)), unit);
    }
}

TEST(Command, HalfATurnEitherWayIsTheSameYaw) {
    EXPECT_EQ(quantise_yaw(kPi), -32768);
    EXPECT_EQ(quantise_yaw(-kPi), -32768);
    EXPECT_EQ(quantise_yaw(100.0f * kTwoPi), quantise_yaw(0.0f));
}

// Looking straight up would leave "left" undefined.
TEST(Command, PitchStopsAtEightyNineDegrees) {
    const float degree = kPi / 180.0f;
    EXPECT_EQ(quantise_pitch(2.0f), kMaxPitch);
    EXPECT_EQ(quantise_pitch(-2.0f), -kMaxPitch);
    EXPECT_NEAR(pitch_radians(kMaxPitch), 89.0f * degree, 1e-4f);
    EXPECT_LT(quantise_pitch(88.9f * degree), kMaxPitch);
}

TEST(Command, MovesAreHeldWithinFullSpeed) {
    EXPECT_EQ(quantise_move(0.0f), 0);
    EXPECT_EQ(quantise_move(1.0f), 127);
    EXPECT_EQ(quantise_move(-1.0f), -127);
    EXPECT_EQ(quantise_move(40.0f), 127);
    EXPECT_EQ(quantise_move(-std::numeric_limits<float>::infinity()), -127);
    EXPECT_EQ(quantise_move(std::numeric_limits<float>::quiet_NaN()), 0);
    EXPECT_EQ(quantise_move(-0.5f), -quantise_move(0.5f)) << "no way is favoured";
}

TEST(Command, LooksAlongMinusZAndTurnsLeftCounterClockwise) {
    const auto expect_near = [](const glm::vec3& got, const glm::vec3& want) {
        for (glm::length_t i = 0; i < 3; ++i) EXPECT_NEAR(got[i], want[i], 1e-6f);
    };
    expect_near(look_direction(0.0f, 0.0f), {0, 0, -1});
    expect_near(look_direction(kPi / 2, 0.0f), {-1, 0, 0});
    expect_near(look_direction(0.0f, kPi / 4), {0, std::sqrt(0.5f), -std::sqrt(0.5f)});
}

TEST(Command, KnowsWhichOfItsKindCanNotBeMeant) {
    EXPECT_TRUE(is_valid({}));
    EXPECT_TRUE(is_valid({.yaw = -32768, .pitch = kMaxPitch, .move_right = -127, .buttons = kAllButtons}));
    EXPECT_FALSE(is_valid({.pitch = kMaxPitch + 1}));
    EXPECT_FALSE(is_valid({.pitch = -32768}));
    EXPECT_FALSE(is_valid({.move_right = -128}));
    EXPECT_FALSE(is_valid({.move_forward = -128}));
    EXPECT_FALSE(is_valid({.buttons = 0x8000}));
    EXPECT_TRUE((Command{.buttons = Jump | Crouch}.is_held(Jump)));
    EXPECT_FALSE((Command{.buttons = Jump | Crouch}.is_held(Use)));
}

}  // namespace
}  // namespace gh::input
