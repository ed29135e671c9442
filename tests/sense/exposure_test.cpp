// The light gem is honest: it shows what the lamps that shine give, and nothing else.
#include "sense/exposure.h"

#include "sense/lamp_light.h"
#include "support/rest_scene.h"
#include "support/small_level.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gh::sense {
namespace {

// Three lamps over a floor, each on its own switch, and a column that throws shadows.
test::SmallLevel lit_room() {
    test::SmallLevel small;
    const std::uint32_t plaster = small.add_material(world::Surface::Plaster);
    small.add_box({-5.0f, -0.1f, -5.0f}, {5.0f, 0.0f, 5.0f}, plaster);
    small.add_box({0.6f, 0.0f, -0.2f}, {1.0f, 3.0f, 0.2f}, plaster);
    world::Lamp lamp;
    lamp.shape = world::LampShape::Sphere;
    lamp.radius = 0.05f;
    lamp.position = {2.0f, 2.5f, 0.3f};
    lamp.intensity = {60.0f, 50.0f, 40.0f};
    lamp.group = 0;
    small.add_lamp(lamp);
    lamp.shape = world::LampShape::Point;
    lamp.position = {-1.0f, 2.5f, -1.0f};
    lamp.intensity = {0.5f, 0.6f, 0.7f};
    lamp.group = 1;
    small.add_lamp(lamp);
    lamp.shape = world::LampShape::Rect;
    lamp.position = {0.0f, 3.0f, 2.0f};
    lamp.half_u = {0.3f, 0.0f, 0.0f};
    lamp.half_v = {0.0f, 0.0f, 0.2f};
    lamp.intensity = glm::vec3(3.0f);
    lamp.group = 2;
    small.add_lamp(lamp);
    small.level.lamp_groups = {"a", "b", "c"};
    return small;
}

world::Snapshot snapshot_of(const world::Level& level) {
    world::Snapshot now;
    now.scene = test::rest_scene(level);
    for (std::size_t g = 0; g < level.lamp_groups.size(); ++g) now.state.group_on[g] = 1;
    return now;
}

TEST(Exposure, ALampSwitchedOffLeavesWhatTheOthersGive) {
    const test::SmallLevel small = lit_room();
    world::Snapshot now = snapshot_of(small.level);
    world::PlayerState player;
    player.position = {-0.4f, 0.0f, 0.6f};
    const BodyPoints body = body_points(player);
    const Exposure all = exposure(small.level, now, body);
    for (std::size_t off = 0; off < 3; ++off) {
        now.state.group_on[off] = 0;
        const Exposure left = exposure(small.level, now, body);
        now.state.group_on[off] = 1;
        bool is_darker = false;
        for (std::size_t p = 0; p < kBodyPoints; ++p) {
            const Probe probe{.position = body[p]};
            glm::vec3 remaining(0.0f);
            for (std::size_t lamp = 0; lamp < 3; ++lamp) {
                glm::vec3 light;
                irradiance_from_lamp(small.level, *now.scene, lamp, {&probe, 1}, {&light, 1});
                if (lamp != off) remaining += light;
            }
            for (glm::length_t c = 0; c < 3; ++c) EXPECT_NEAR(left.irradiance[p][c], remaining[c], 1e-4f);
            EXPECT_LE(left.lit[p], all.lit[p]);
            is_darker |= left.lit[p] < all.lit[p];
        }
        EXPECT_TRUE(is_darker) << "lamp " << off << " lights no point, so nothing was tested";
        EXPECT_LT(left.level, all.level);
    }
}

TEST(Exposure, InTheDarkItIsNothing) {
    const test::SmallLevel small = lit_room();
    world::Snapshot now = snapshot_of(small.level);
    now.state.group_on = {};
    const Exposure dark = exposure(small.level, now, body_points(world::PlayerState{}));
    EXPECT_EQ(dark.level, 0.0f);
}

TEST(Exposure, BehindAColumnIsDarkerThanBesideIt) {
    const test::SmallLevel small = lit_room();
    world::Snapshot now = snapshot_of(small.level);
    now.state.group_on = {1, 0, 0};
    world::PlayerState player;
    player.position = {0.0f, 0.0f, -0.15f};  // the column stands between here and the lamp
    const float behind = exposure(small.level, now, body_points(player)).level;
    player.position = {0.0f, 0.0f, 1.5f};
    const float beside = exposure(small.level, now, body_points(player)).level;
    EXPECT_LT(behind, 0.5f * beside);
}

TEST(Exposure, EveryDoublingOfLightIsTheSameStep) {
    EXPECT_EQ(lightness_of(glm::vec3(kDarkIrradiance)), 0.0f);
    EXPECT_EQ(lightness_of(glm::vec3(0.0f)), 0.0f);
    EXPECT_NEAR(lightness_of(glm::vec3(kBrightIrradiance)), 1.0f, 1e-6f);
    EXPECT_EQ(lightness_of(glm::vec3(100.0f * kBrightIrradiance)), 1.0f);
    const float step =
        lightness_of(glm::vec3(4.0f * kDarkIrradiance)) - lightness_of(glm::vec3(2.0f * kDarkIrradiance));
    EXPECT_NEAR(lightness_of(glm::vec3(32.0f * kDarkIrradiance)), 5.0f * step, 1e-5f);
    EXPECT_EQ(lightness_of(glm::vec3(std::nanf(""))), 0.0f);
}

TEST(Body, EveryPointStaysWithinTheCapsule) {
    world::PlayerState player;
    player.position = {3.0f, 0.5f, -2.0f};
    for (const float height : {1.75f, 1.1f}) {
        for (const std::int16_t yaw : {std::int16_t{0}, std::int16_t{8192}, std::int16_t{-20000}}) {
            player.height = height;
            player.yaw = yaw;
            for (const glm::vec3& point : body_points(player)) {
                EXPECT_GT(point.y, player.position.y);
                EXPECT_LT(point.y, player.position.y + height);
                EXPECT_LE(glm::length(glm::vec3(point.x - 3.0f, 0.0f, point.z + 2.0f)), 0.25f);
            }
        }
    }
}

TEST(Body, LeaningCarriesTheHeadAsideAndLeavesTheFeet) {
    world::PlayerState player;
    const BodyPoints upright = body_points(player);
    player.lean = 1.0f;
    const BodyPoints leaning = body_points(player);
    const auto at = [](BodyPart part) { return static_cast<std::size_t>(part); };
    EXPECT_GT(leaning[at(BodyPart::Head)].x, upright[at(BodyPart::Head)].x + 0.3f);  // yaw 0: right is +x
    EXPECT_EQ(leaning[at(BodyPart::LeftFoot)], upright[at(BodyPart::LeftFoot)]);
    EXPECT_EQ(leaning[at(BodyPart::Knees)], upright[at(BodyPart::Knees)]);
}

}  // namespace
}  // namespace gh::sense
