// Bodies that are none, and scenes that hold nothing: a contract violation in development, a miss in release.
#include "support/brute_force.h"

#include "raycore/bodies.h"

#include <gtest/gtest.h>

#include <limits>

namespace test {
namespace {

constexpr rc::LayerMask kAll = rc::kAllLayers;

TestScene a_floor() {
    TestScene scene;
    scene.add(make_sheet(5.0f, 0.0f, 1));
    scene.commit();
    return scene;
}

TEST(CastDeathTest, ABadBodyIsAContractViolationOrAMiss) {
    const TestScene scene = a_floor();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto try_all = [&](float bad) {
        (void)rc::sphere_cast(scene.scene(), {0, bad, 0}, 0.5f, {0, -3, 0}, kAll);
        return rc::sphere_cast(scene.scene(), {0, 1, 0}, bad, {0, -3, 0}, kAll).has_value() ||
               rc::sphere_cast(scene.scene(), {0, 1, 0}, 0.5f, {0, bad, 0}, kAll).has_value() ||
               rc::capsule_cast(scene.scene(), {{0, 1, 0}, {bad, 1, 0}}, 0.5f, {0, -3, 0}, kAll).has_value();
    };
#ifdef RC_CONTRACTS
    EXPECT_DEATH((void)try_all(nan), "raycore expects a body of finite place");
    EXPECT_DEATH((void)rc::sphere_cast(scene.scene(), {0, 1, 0}, -1.0f, {0, -3, 0}, kAll), "raycore expects");
#else
    EXPECT_FALSE(try_all(nan));
    EXPECT_FALSE(try_all(rc::kInfinity));
    EXPECT_FALSE(rc::sphere_cast(scene.scene(), {0, 1, 0}, -1.0f, {0, -3, 0}, kAll).has_value());
#endif
}

TEST(Cast, AnEmptySceneHoldsNothingUp) {
    TestScene scene;
    scene.commit();
    EXPECT_FALSE(rc::sphere_cast(scene.scene(), {0, 1, 0}, 0.5f, {0, -3, 0}, kAll));
}

#ifdef RC_CONTRACTS
TEST(BoxOverlap, NonsenseTrapsInDevelopment) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto scene = rc::SceneBuilder{}.commit();
    rc::CastHit hit;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto ask = [&](const rc::OrientedBox& box) {
        (void)rc::box_overlaps(*scene, box, kAll, {&hit, 1});
    };
    EXPECT_DEATH(ask({.centre = glm::vec3(nan)}), "a box of finite place and size");
    EXPECT_DEATH(ask({.half = glm::vec3(-1)}), "a box of finite place and size");
    EXPECT_DEATH(ask({.half = glm::vec3(1), .axes = glm::mat3(0.0f)}), "axes span space");
}
#else
TEST(BoxOverlap, NonsenseOverlapsNothingInRelease) {
    const TestScene scene = a_floor();
    rc::CastHit hit;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto count = [&](const rc::OrientedBox& box) {
        return rc::box_overlaps(scene.scene(), box, kAll, {&hit, 1});
    };
    EXPECT_EQ(count({.centre = glm::vec3(nan), .half = glm::vec3(1)}), 0u);
    EXPECT_EQ(count({.half = {1, rc::kInfinity, 1}}), 0u);
    EXPECT_EQ(count({.half = glm::vec3(-1)}), 0u);
    EXPECT_EQ(count({.half = glm::vec3(1), .axes = glm::mat3(0.0f)}), 0u);
    EXPECT_EQ(rc::sphere_overlaps(scene.scene(), glm::vec3(0), -1.0f, kAll, {&hit, 1}), 0u);
}
#endif

}  // namespace
}  // namespace test
