// What a guard's joints do between keys: the game turns along chords, so the loader must leave none too long.
#include "level_bytes.h"
#include "load/guard_model.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace gh {
namespace {

const world::Clip& clip_named(const world::Level& level, std::string_view name) {
    const world::Clip* clip = test::named(level.models.at(0).clips, name);
    EXPECT_NE(clip, nullptr);
    return *clip;
}

// Value by the game's rule: linear, rotations made unit.
glm::vec4 sample(const world::Channel& channel, float time) {
    std::size_t i = 0;
    while (i + 2 < channel.times.size() && channel.times[i + 1] < time) ++i;
    const float s = (time - channel.times[i]) / (channel.times[i + 1] - channel.times[i]);
    const glm::vec4 value = channel.values[i] * (1.0f - s) + channel.values[i + 1] * s;
    return channel.path == world::ChannelPath::Rotation ? glm::normalize(value) : value;
}

TEST(Clips, FollowAnArcThatTheFileGivesByItsEndsOnly) {
    const Result<world::Level> level = test::load_quickly(test::tiny_level_glb());
    ASSERT_TRUE(level) << level.error().sentence;
    const world::Clip& stand = clip_named(*level, "stand");
    ASSERT_EQ(stand.channels.size(), 1u);
    const world::Channel& channel = stand.channels[0];
    EXPECT_GT(channel.times.size(), 8u) << "a quarter turn in one chord lags by 4 degrees";
    for (int i = 0; i <= 100; ++i) {
        const float time = 0.01f * static_cast<float>(i);
        const double half_angle =
            0.25 * 3.14159265358979 * static_cast<double>(time);  // slerp: a steady quarter turn
        const glm::vec4 expected(0.0f, std::sin(half_angle), 0.0f, std::cos(half_angle));
        EXPECT_LT(glm::length(sample(channel, time) - expected), 1e-4f) << "at " << time << " s";
    }
}

TEST(Clips, ResampleCubicSplinesSixtyTimesASecond) {
    const Result<world::Level> level = test::load_quickly(test::tiny_level_glb());
    ASSERT_TRUE(level);
    const world::Channel& channel = clip_named(*level, "walk").channels.at(0);
    EXPECT_EQ(channel.times.size(), 61u);
    for (std::size_t i = 0; i < channel.times.size(); ++i) {
        const float t = channel.times[i];  // tangents are zero: the spline is 0.9 + 0.1 (3 t^2 - 2 t^3)
        EXPECT_NEAR(channel.values[i].y, 0.9f + 0.1f * (3.0f * t * t - 2.0f * t * t * t), 1e-6f);
    }
}

TEST(Clips, KeepSteps) {
    const Result<world::Level> level = test::load_quickly(test::tiny_level_glb());
    ASSERT_TRUE(level);
    const world::Channel& channel = clip_named(*level, "look").channels.at(0);
    EXPECT_TRUE(channel.is_step);
    EXPECT_EQ(channel.times.size(), 2u);
    EXPECT_EQ(channel.joint, 1u);
}

TEST(Clips, AreRefusedWhenTheirKeysDoNotRise) {
    const float rising[] = {0.0f, 1.0f, 0.0f, 0.0f,
                            0.0f, 1.0f, 0.0f, 0.70710678f};  // its times, then its values
    const float resting[] = {1.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.70710678f};
    const std::string sentence =
        test::refusal(test::with(test::tiny_level_glb(), test::raw(rising), test::raw(resting)));
    EXPECT_EQ(
        sentence,
        "tiny.glb: node 'guard': animation 'stand': sampler 0: key 1 does not come after the one before");
}

}  // namespace
}  // namespace gh
