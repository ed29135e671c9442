// The promises of casts, each in a scene small enough to know the answer.
#include "support/brute_force.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace test {
namespace {

constexpr rc::LayerMask kAll = rc::kAllLayers;

glm::mat4x3 placed_at(const glm::vec3& at, const glm::vec3& scale = glm::vec3(1.0f)) {
    return {glm::vec3(scale.x, 0, 0), glm::vec3(0, scale.y, 0), glm::vec3(0, 0, scale.z), at};
}

TestScene a_floor(float half = 5.0f, std::uint32_t cells = 1) {
    TestScene scene;
    scene.add(make_sheet(half, 0.0f, cells));
    scene.commit();
    return scene;
}

void expect_near(const glm::vec3& got, const glm::vec3& want, float tolerance = 1e-6f) {
    for (glm::length_t a = 0; a < 3; ++a) EXPECT_NEAR(got[a], want[a], tolerance) << "axis " << a;
}

TEST(Cast, ABallFallsOnAFloorFromEitherSide) {
    const TestScene scene = a_floor();
    const auto down = rc::sphere_cast(scene.scene(), {1, 2, 0.5f}, 0.5f, {0, -3, 0}, kAll);
    ASSERT_TRUE(down);
    EXPECT_FLOAT_EQ(down->t, 0.5f);
    EXPECT_EQ(down->depth, 0.0f);
    expect_near(down->point, {1, 0, 0.5f});
    expect_near(down->normal, {0, 1, 0});
    const auto up = rc::sphere_cast(scene.scene(), {1, -2, 0.5f}, 0.5f, {0, 3, 0}, kAll);
    ASSERT_TRUE(up);
    EXPECT_FLOAT_EQ(up->t, 0.5f);
    expect_near(up->normal, {0, -1, 0});
    EXPECT_FALSE(rc::sphere_cast(scene.scene(), {1, 2, 0.5f}, 0.5f, {0, -1.4999f, 0}, kAll)) << "stops short";
    EXPECT_TRUE(rc::sphere_cast(scene.scene(), {1, 2, 0.5f}, 0.5f, {0, -1.5f, 0}, kAll))
        << "the end is included";
}

TEST(Cast, AnEdgeAndACornerAreRound) {
    const TestScene scene = a_floor(1.0f);
    // Past the edge x = 1 by 0.3 with radius 0.5: the centre stops 0.4 above.
    const auto edge = rc::sphere_cast(scene.scene(), {1.3f, 2, 0.2f}, 0.5f, {0, -4, 0}, kAll);
    ASSERT_TRUE(edge);
    EXPECT_NEAR(edge->t, 0.4f, 1e-6f);
    expect_near(edge->normal, {0.6f, 0.8f, 0});
    expect_near(edge->point, {1, 0, 0.2f});
    // Past the corner by (0.3, 0.3) with radius 0.5: sqrt(0.25 - 0.18) above.
    const auto corner = rc::sphere_cast(scene.scene(), {1.3f, 2, 1.3f}, 0.5f, {0, -4, 0}, kAll);
    ASSERT_TRUE(corner);
    EXPECT_NEAR(corner->t, (2.0f - std::sqrt(0.07f)) / 4.0f, 1e-6f);
    expect_near(corner->point, {1, 0, 1});
    EXPECT_FALSE(rc::sphere_cast(scene.scene(), {1.4f, 2, 1.4f}, 0.5f, {0, -4, 0}, kAll))
        << "a cube would hit";
}

TEST(Cast, ACapsuleMeetsWithItsEndItsSideAndItsLength) {
    const TestScene scene = a_floor(1.0f);
    const auto standing = rc::capsule_cast(scene.scene(), {{0, 2, 0}, {0, 3, 0}}, 0.25f, {0, -4, 0}, kAll);
    ASSERT_TRUE(standing);
    EXPECT_FLOAT_EQ(standing->t, 1.75f / 4.0f);
    const auto lying =
        rc::capsule_cast(scene.scene(), {{-0.5f, 2, 0}, {0.5f, 2, 0}}, 0.25f, {0, -4, 0}, kAll);
    ASSERT_TRUE(lying);
    EXPECT_FLOAT_EQ(lying->t, 1.75f / 4.0f);
    expect_near(lying->normal, {0, 1, 0});
    // Sideways into the edge of the floor: the middle of the axis touches.
    const auto side = rc::capsule_cast(scene.scene(), {{3, -1, 0}, {3, 1, 0}}, 0.25f, {-4, 0, 0}, kAll);
    ASSERT_TRUE(side);
    EXPECT_FLOAT_EQ(side->t, 1.75f / 4.0f);
    expect_near(side->point, {1, 0, 0});
    expect_near(side->normal, {1, 0, 0});
    // Longer than the floor is wide: it lands across both edges.
    const auto across = rc::capsule_cast(scene.scene(), {{-3, 2, 0}, {3, 2, 0}}, 0.25f, {0, -4, 0}, kAll);
    ASSERT_TRUE(across);
    EXPECT_FLOAT_EQ(across->t, 1.75f / 4.0f);
    EXPECT_LE(std::abs(across->point.x), 1.0f + 1e-6f);
}

TEST(Cast, ACapsuleWithoutLengthIsABallInEveryBit) {
    Random random(5);
    TestScene scene;
    scene.add(make_soup(random, 300, 2.0f, 0.6f));
    scene.commit();
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 at = random.in_cube(3.0f), way = random.in_cube(4.0f);
        const float radius = random.between(0.0f, 0.3f);
        const auto ball = rc::sphere_cast(scene.scene(), at, radius, way, kAll);
        const auto capsule = rc::capsule_cast(scene.scene(), {at, at}, radius, way, kAll);
        ASSERT_EQ(ball.has_value(), capsule.has_value());
        if (!ball) continue;
        ++hits;
        ASSERT_EQ(ball->t, capsule->t);
        ASSERT_EQ(ball->point, capsule->point);
        ASSERT_EQ(ball->normal, capsule->normal);
        ASSERT_EQ(ball->primitive, capsule->primitive);
    }
    EXPECT_GT(hits, 1000);
}

TEST(Cast, ABallOfNoSizeIsARay) {
    TestScene scene;
    scene.add(make_ball(glm::vec3(0), 2.0f, 6));
    scene.commit();
    Random random(6);
    for (int i = 0; i < 5000; ++i) {
        const glm::vec3 at = random.in_cube(1.0f);
        const glm::vec3 way = random.direction() * 6.0f;
        const auto ball = rc::sphere_cast(scene.scene(), at, 0.0f, way, kAll);
        const auto ray =
            rc::closest_hit(scene.scene(), {.origin = at, .direction = way, .t_max = 1.0f}, kAll);
        ASSERT_TRUE(ball && ray);
        ASSERT_EQ(ball->primitive, ray->primitive);
        ASSERT_NEAR(ball->t, ray->t, 1e-6f);
        ASSERT_LT(glm::dot(ball->normal, way), 0.0f) << "the way out is back";
        ASSERT_NEAR(glm::length(ball->normal), 1.0f, 1e-6f);
    }
}

TEST(Cast, ABallOfNoSizeLeavesNoClosedMeshThroughAnEdgeOrACorner) {
    const Mesh ball = make_ball(glm::vec3(0), 2.0f, 6);
    TestScene scene;
    scene.add(ball);
    scene.commit();
    Random random(7);
    int leaks = 0;
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 at = random.in_cube(1.0f);
        const glm::uvec3 t = ball.triangles[random.below(static_cast<std::uint32_t>(ball.triangles.size()))];
        const glm::vec3 a = ball.positions[t.x], b = ball.positions[t.y];
        const glm::vec3 aim = i % 2 == 0 ? a : a + (b - a) * random.unit();
        const float radius = i % 4 < 2 ? 0.0f : 1e-7f;
        leaks += !rc::sphere_cast(scene.scene(), at, radius, (aim - at) * 2.0f, kAll);
    }
    EXPECT_EQ(leaks, 0);
}

TEST(Cast, AnOverlapAtTheStartIsMetAtOnceWithItsDepthAndTheWayOut) {
    const TestScene scene = a_floor();
    for (const glm::vec3 way : {glm::vec3(0, -1, 0), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::vec3(0)}) {
        const auto hit = rc::sphere_cast(scene.scene(), {1, 0.3f, 0.5f}, 0.5f, way, kAll);
        ASSERT_TRUE(hit) << "also when it moves out, or not at all";
        EXPECT_EQ(hit->t, 0.0f);
        EXPECT_NEAR(hit->depth, 0.2f, 1e-6f);
        expect_near(hit->normal, {0, 1, 0});
        expect_near(hit->point, {1, 0, 0.5f});
    }
    // An axis that goes through: out by its shorter end.
    const auto through =
        rc::capsule_cast(scene.scene(), {{1, -0.1f, 0}, {1, 0.9f, 0}}, 0.25f, {0, -1, 0}, kAll);
    ASSERT_TRUE(through);
    EXPECT_EQ(through->t, 0.0f);
    EXPECT_NEAR(through->depth, 0.35f, 1e-6f);
    expect_near(through->normal, {0, 1, 0});
    // A centre exactly on the surface goes back where it came from.
    const auto on_it = rc::sphere_cast(scene.scene(), {1, 0, 0.5f}, 0.25f, {0, -1, 0}, kAll);
    ASSERT_TRUE(on_it);
    expect_near(on_it->normal, {0, 1, 0});
    EXPECT_FLOAT_EQ(on_it->depth, 0.25f);
}

// A character slides along the floor it stands on and jumps off it, but does not sink into it.
TEST(Cast, TouchingStopsOnlyWhatMovesCloser) {
    const TestScene scene = a_floor(5.0f, 8);
    const rc::Segment axis{{0.3f, 0.25f, 0.2f}, {0.3f, 1.25f, 0.2f}};
    const auto cast = [&](const glm::vec3& way) {
        return rc::capsule_cast(scene.scene(), axis, 0.25f, way, kAll);
    };
    EXPECT_FALSE(cast({3, 0, 1})) << "along, over the seams of the floor";
    EXPECT_FALSE(cast({3, -1e-9f, 0})) << "along, but for the rounding of whoever computed the way";
    EXPECT_FALSE(cast({0, 2, 0})) << "away";
    EXPECT_FALSE(cast({0, 0, 0})) << "not at all";
    const auto into = cast({1, -0.01f, 0});
    ASSERT_TRUE(into) << "closer, if only a little";
    EXPECT_EQ(into->t, 0.0f);
    EXPECT_EQ(into->depth, 0.0f);
    // Half a float's step too low is rounding; a tenth of a millimetre is not.
    EXPECT_FALSE(rc::sphere_cast(scene.scene(), {0, 0.25f - 1e-8f, 0}, 0.25f, {1, 0, 0}, kAll));
    EXPECT_TRUE(rc::sphere_cast(scene.scene(), {0, 0.25f - 1e-4f, 0}, 0.25f, {1, 0, 0}, kAll));
}

TEST(Cast, ATieGoesToTheLowerInstanceThenTheLowerTriangle) {
    TestScene scene;
    const Mesh sheet = make_sheet(2.0f, 0.0f, 2);
    scene.add(sheet);
    scene.add(sheet);
    scene.commit();
    // Straight down on the middle, where six or eight triangles of each sheet share a corner.
    const auto middle = rc::sphere_cast(scene.scene(), {0, 1.7f, 0}, 0.3f, {0, -3.1f, 0}, kAll);
    ASSERT_TRUE(middle);
    std::uint32_t lowest = rc::kNone;
    for (std::uint32_t i = 0; i < sheet.triangles.size(); ++i)
        for (glm::length_t c = 0; c < 3; ++c)
            if (sheet.positions[sheet.triangles[i][c]] == glm::vec3(0)) lowest = std::min(lowest, i);
    EXPECT_EQ(middle->instance, 0u);
    EXPECT_EQ(middle->primitive, lowest);
}

TEST(Cast, AScaledInstanceStretchesTheWorldAndNotTheBall) {
    TestScene scene;
    scene.add(make_box(glm::vec3(-1), glm::vec3(1)), placed_at({10, 0, 0}, {3.0f, 0.5f, -2.0f}));
    scene.commit();
    const auto side = rc::sphere_cast(scene.scene(), {0, 0, 0}, 0.5f, {10, 0, 0}, kAll);
    ASSERT_TRUE(side);
    EXPECT_NEAR(side->t, 0.65f, 1e-6f);
    const auto top = rc::sphere_cast(scene.scene(), {10, 5, 1.5f}, 0.5f, {0, -10, 0}, kAll);
    ASSERT_TRUE(top);
    EXPECT_NEAR(top->t, 0.4f, 1e-6f);
    expect_near(top->normal, {0, 1, 0});
}

TEST(Cast, OnlyTheAskedLayersAreMet) {
    TestScene scene;
    scene.add(make_sheet(2.0f, 1.0f, 1), placed_at({}), 1u);
    scene.add(make_sheet(2.0f, 0.0f, 1), placed_at({}), 2u);
    scene.commit();
    const auto hit = rc::sphere_cast(scene.scene(), {0.3f, 2, 0.1f}, 0.25f, {0, -4, 0}, 2u);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->instance, 1u);
    EXPECT_FALSE(rc::sphere_cast(scene.scene(), {0.3f, 2, 0.1f}, 0.25f, {0, -4, 0}, 4u));
}

TEST(Cast, FarFromTheOriginNothingIsLostThatFloatsStillKnow) {
    // Coordinates that are exact at both places: the answers may differ by the rounding of t alone.
    const glm::vec3 far(8192.0f, -4096.0f, 8192.0f);
    TestScene near_scene, far_scene;
    const Mesh ball = make_ball(glm::vec3(0), 2.0f, 3);
    Mesh snapped = ball;
    for (glm::vec3& p : snapped.positions) p = glm::floor(p * 256.0f) / 256.0f;
    near_scene.add(snapped);
    near_scene.commit();
    far_scene.add(snapped, placed_at(far));
    far_scene.commit();
    Random random(8);
    int hits = 0;
    for (int i = 0; i < 5000; ++i) {
        const glm::vec3 at = glm::floor(random.in_cube(4.0f) * 256.0f) / 256.0f;
        const glm::vec3 way = random.in_cube(4.0f);
        const auto a = rc::sphere_cast(near_scene.scene(), at, 0.25f, way, kAll);
        const auto b = rc::sphere_cast(far_scene.scene(), at + far, 0.25f, way, kAll);
        // What is no deeper than a few of the float's steps over there is only touched over there.
        if (a && a->t == 0.0f && a->depth < 4e-3f) continue;
        const auto deeper = rc::sphere_cast(near_scene.scene(), at, 0.246f, way, kAll);
        if (a && !deeper) continue;
        ASSERT_EQ(a.has_value(), b.has_value()) << i;
        if (!a) continue;
        ++hits;
        ASSERT_EQ(a->t, b->t) << i;
        ASSERT_EQ(a->normal, b->normal) << i;
    }
    EXPECT_GT(hits, 500);
}

}  // namespace
}  // namespace test
