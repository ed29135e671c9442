#include "sim/motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"
#include "sim/level_kit.h"
#include "spatial/stage.h"
#include "world/initial_state.h"

namespace gh::sim {
namespace {

using test::LevelKit;

std::shared_ptr<const rc::Scene> scene_of(LevelKit& kit) {
    const auto level = kit.finish();
    return spatial::Stage(level).commit(world::initial_state(*level, 0)).scene;
}

// Walks `ticks` ticks at 2 m/s along +x, as a player does.
Body walk_along_x(const rc::Scene& scene, Body body, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        glm::vec3 velocity{2.0f, 0.0f, 0.0f};
        walk(scene, body, velocity / 60.0f, velocity);
        stand(scene, body, kStepHeight);
    }
    return body;
}

TEST(Motion, AWallStopsTheBodyATouchBeforeIt) {
    LevelKit kit;
    kit.room({-5, 0, -5}, {5, 3, 5});
    const auto scene = scene_of(kit);
    const Body body = walk_along_x(*scene, {.feet = {0, 0, 0}}, 240);
    EXPECT_NEAR(body.feet.x, 5.0f - body.radius - kPadding, 1e-3f);
    EXPECT_NEAR(body.feet.y, 0.0f, 1e-3f);
}

TEST(Motion, AWallAtASlantIsSlidAlongAtTheSpeedThatIsLeft) {
    LevelKit kit;
    kit.room({-50, 0, -5}, {50, 3, 5});
    const auto scene = scene_of(kit);
    Body body{.feet = {0, 0, 4.5f}};
    for (int i = 0; i < 120; ++i) {  // at 45 degrees into the wall z = 5, two seconds
        glm::vec3 velocity{1.4142136f, 0.0f, 1.4142136f};
        walk(*scene, body, velocity / 60.0f, velocity);
    }
    EXPECT_NEAR(body.feet.x, 2.0f * 1.4142136f, 0.02f);
    EXPECT_NEAR(body.feet.z, 5.0f - body.radius - kPadding, 0.01f);
}

TEST(Motion, StepsUpTo35CentimetresAreWalkedUpAndHigherOnesAreNot) {
    for (const float height : {0.05f, 0.1f, 0.17f, 0.25f, 0.34f}) {
        LevelKit kit;
        kit.room({-5, 0, -5}, {9, 4, 5}).box({1, 0, -5}, {9, height, 5});
        const Body body = walk_along_x(*scene_of(kit), {.feet = {0, 0, 0}}, 120);
        EXPECT_NEAR(body.feet.y, height, 2e-3f) << "step of " << height;
        EXPECT_GT(body.feet.x, 3.5f) << "step of " << height;
    }
    LevelKit kit;
    kit.room({-5, 0, -5}, {9, 4, 5}).box({1, 0, -5}, {9, 0.38f, 5});
    const Body body = walk_along_x(*scene_of(kit), {.feet = {0, 0, 0}}, 120);
    EXPECT_LT(body.feet.x, 1.0f);
    EXPECT_NEAR(body.feet.y, 0.0f, 2e-3f);
}

TEST(Motion, AFlightOfStairsIsClimbedAndDescendedWithoutLeavingTheGround) {
    LevelKit kit;
    kit.room({-5, 0, -5}, {20, 6, 5});
    for (int i = 0; i < 8; ++i) {
        const float x = 1.0f + 0.3f * static_cast<float>(i);
        kit.box({x, 0, -2}, {8.0f - 0.3f * static_cast<float>(i), 0.17f * static_cast<float>(i + 1), 2});
    }
    const auto scene = scene_of(kit);
    Body body{.feet = {0, 0, 0}};
    float highest = 0.0f;
    for (int i = 0; i < 330; ++i) {
        glm::vec3 velocity{2.0f, 0.0f, 0.0f};
        walk(*scene, body, velocity / 60.0f, velocity);
        EXPECT_TRUE(stand(*scene, body, kStepHeight).is_there) << "tick " << i << " x " << body.feet.x;
        highest = std::max(highest, body.feet.y);
    }
    EXPECT_NEAR(highest, 8 * 0.17f, 2e-3f);
    EXPECT_NEAR(body.feet.y, 0.0f, 2e-3f);
    EXPECT_GT(body.feet.x, 9.0f);
}

TEST(Motion, SlopesUpToFiftyDegreesAreFloorsAndSteeperOnesAreWalls) {
    for (const float angle : {10.0f, 30.0f, 48.0f}) {
        LevelKit kit;
        kit.room({-5, 0, -5}, {20, 20, 5}).ramp(1, -5, 5, angle, 10);
        const Body body = walk_along_x(*scene_of(kit), {.feet = {0, 0, 0}}, 150);
        const float expected = (body.feet.x - 1.0f) * std::tan(angle * 0.017453292f);
        // A round foot touches a slope beside its lowest point and stands that much higher.
        const float lift = 0.32f * (1.0f / std::cos(angle * 0.017453292f) - 1.0f) + 0.02f;
        EXPECT_NEAR(body.feet.y, expected, lift + 0.02f) << angle << " degrees";
        EXPECT_NEAR(body.feet.x, 5.0f, 0.1f) << "a slope of " << angle << " degrees costs no horizontal speed";
    }
    LevelKit kit;
    kit.room({-5, 0, -5}, {20, 20, 5}).ramp(1, -5, 5, 53, 10);
    const Body body = walk_along_x(*scene_of(kit), {.feet = {0, 0, 0}}, 150);
    EXPECT_LT(body.feet.y, 0.1f);
    EXPECT_LT(body.feet.x, 1.1f);
}

TEST(Motion, NothingIsWalkedThroughAtAnySpeedFromAnywhereInAnyDirection) {
    LevelKit kit;
    kit.room({-4, 0, -4}, {4, 3, 4}).box({-1, 0, -1}, {1, 1.2f, 1}).box({2, 0, -4}, {2.05f, 3, 3});
    const auto scene = scene_of(kit);
    Random random(5);
    int escapes = 0;
    for (int i = 0; i < 2000; ++i) {
        Body body{.feet = {random.in_range(-3.5f, -1.5f), 0.0f, random.in_range(-3.5f, 3.5f)}};
        const float speed = 1.0f + 1000.0f * random.unit() * random.unit();
        glm::vec3 velocity{speed * random.in_range(-1, 1), speed * random.in_range(-1, 1), speed * random.in_range(-1, 1)};
        slide(*scene, body, velocity / 60.0f, i % 2 == 0, velocity);
        const glm::vec3& p = body.feet;
        const bool is_inside = -4.0f < p.x && p.x < 4.0f && -0.03f < p.y && p.y < 3.0f && -4.0f < p.z && p.z < 4.0f;
        escapes += !is_inside || !has_room(*scene, body);
    }
    EXPECT_EQ(escapes, 0);
}

TEST(Motion, ABodyAtRestKeepsItsBits) {
    LevelKit kit;
    kit.room({-5, 0, -5}, {5, 3, 5}).ramp(1, -5, 5, 20, 3);
    const auto scene = scene_of(kit);
    for (const float x : {0.0f, 2.0f}) {
        Body body{.feet = {x, 1.0f, 0.3f}};
        stand(*scene, body, 2.0f);
        const glm::vec3 settled = body.feet;
        for (int i = 0; i < 600; ++i) {
            push_out(*scene, body);
            EXPECT_TRUE(stand(*scene, body, kStepHeight).is_there);
        }
        EXPECT_EQ(body.feet, settled);
    }
}

TEST(Motion, SomebodyInsideASurfaceThatMovedIsPushedOutOnce) {
    LevelKit kit;
    kit.room({-5, 0, -5}, {5, 3, 5}).box({0.25f, 0, -1}, {0.3f, 2, 1});
    const auto scene = scene_of(kit);
    Body body{.feet = {0, 0, 0}};
    ASSERT_FALSE(has_room(*scene, body));
    push_out(*scene, body);
    EXPECT_TRUE(has_room(*scene, body));
    EXPECT_LT(body.feet.x, 0.0f) << "out on the side it was on";
}

TEST(Motion, ABodyThatFitsNowhereStaysAndOverlapsRatherThanLeavingTheLevel) {
    LevelKit kit;
    kit.room({-0.2f, 0, -5}, {0.2f, 3, 5});  // a crack narrower than the body
    const auto scene = scene_of(kit);
    Body body{.feet = {0, 0, 0}};
    for (int i = 0; i < 50; ++i) push_out(*scene, body);
    EXPECT_LT(std::abs(body.feet.x), 0.2f);
}

}  // namespace
}  // namespace gh::sim
