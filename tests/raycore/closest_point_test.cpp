// Where the world is nearest: a guard's hand to a wall, a stone to the floor it sleeps on. Every answer is compared with
// distances to all triangles in long double.
#include "support/brute_force.h"

#include "raycore/cast_oracle.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace test {
namespace {

constexpr rc::LayerMask kAll = rc::kAllLayers;

// Meshes and where they stand, kept for the oracle.
struct World {
    std::vector<Mesh> meshes;
    std::vector<glm::mat4x3> places;
    std::shared_ptr<const rc::Scene> scene;

    void add(Mesh mesh, const glm::mat4x3& place = glm::mat4x3(1.0f)) {
        meshes.push_back(std::move(mesh));
        places.push_back(place);
    }
    void commit(rc::BuildQuality quality = rc::BuildQuality::Default) {
        rc::SceneBuilder builder;
        for (std::size_t i = 0; i < meshes.size(); ++i)
            builder.add({rc::build_blas(meshes[i].view(), {quality}), places[i], 1u << (i % 32)});
        scene = builder.commit();
    }
    [[nodiscard]] Triangle triangle(std::uint32_t instance, std::uint32_t primitive) const {
        const glm::mat4x3& m = places[instance];
        const glm::uvec3& t = meshes[instance].triangles[primitive];
        Triangle out;
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::vec3& p = meshes[instance].positions[t[c]];
            out[c] = ((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3];
        }
        return out;
    }
    [[nodiscard]] long double distance_from(const glm::vec3& point) const {
        long double least = std::numeric_limits<long double>::infinity();
        for (std::uint32_t i = 0; i < meshes.size(); ++i)
            for (std::uint32_t t = 0; t < meshes[i].triangles.size(); ++t)
                least = std::min(least, distance_to_triangle(Point(point), triangle(i, t)));
        return least;
    }
};

// The distance is the truth to a rounding, and point and normal are those of the triangle named.
void expect_truth(const World& world, const glm::vec3& point, const rc::Nearest& nearest) {
    const long double truth = world.distance_from(point);
    const long double reach = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}) + truth;
    ASSERT_NEAR(static_cast<double>(nearest.distance), static_cast<double>(truth),
                0x1p-23 * static_cast<double>(truth));
    const Triangle t = world.triangle(nearest.instance, nearest.primitive);
    ASSERT_LE(static_cast<double>(distance_to_triangle(Point(nearest.point), t)),
              0x1p-22 * static_cast<double>(reach));
    ASSERT_NEAR(glm::length(nearest.normal), 1.0f, 1e-6f);
    const Point tip = Point(nearest.point) + truth * Point(nearest.normal);
    ASSERT_LE(static_cast<double>(glm::length(tip - Point(point))), 0x1p-21 * static_cast<double>(reach))
        << "the normal leads from the surface to the point";
}

World a_museum(rc::BuildQuality quality) {
    Random random(41);
    World world;
    world.add(make_soup(random, 200, 2.0f, 0.4f));
    world.add(make_ball({1, 0, 0}, 1.0f, 4), glm::mat4x3(-2, 0, 0, 0, 1, 0.5f, 0, 0, 0.3f, 1, 2, 3));
    world.add(make_sheet(2.0f, 0.0f, 3), glm::mat4x3(0.6f, 0.8f, 0, -0.8f, 0.6f, 0, 0, 0, 1, 0, -3, 1));
    world.add(make_box(glm::vec3(-1), glm::vec3(1)), glm::mat4x3(100, 0, 0, 0, 0.01f, 0, 0, 0, 1, 0, 4, 0));
    world.add(make_ball(glm::vec3(0), 1e-3f, 2), glm::mat4x3(1, 0, 0, 0, 1, 0, 0, 0, 1, -4, 0, 0));
    world.commit(quality);
    return world;
}

class ClosestPoint : public ::testing::TestWithParam<rc::BuildQuality> {};

TEST_P(ClosestPoint, IsTheNearestOfAllTrianglesThroughEveryTransform) {
    const World world = a_museum(GetParam());
    Random random(42);
    for (int i = 0; i < 250; ++i) {
        const glm::vec3 point = random.in_cube(i % 4 == 0 ? 40.0f : 5.0f);
        const auto nearest = rc::closest_point(*world.scene, point, rc::kInfinity, kAll);
        ASSERT_TRUE(nearest);
        SCOPED_TRACE(i);
        expect_truth(world, point, *nearest);
    }
}

TEST_P(ClosestPoint, IsFoundUpToTheGreatestDistanceAndNoFarther) {
    const World world = a_museum(GetParam());
    Random random(43);
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 point = random.in_cube(6.0f);
        const auto free = rc::closest_point(*world.scene, point, rc::kInfinity, kAll);
        ASSERT_TRUE(free);
        const float above = std::nextafter(free->distance, rc::kInfinity), below = 0.999f * free->distance;
        const auto limited = rc::closest_point(*world.scene, point, above, kAll);
        ASSERT_TRUE(limited);
        EXPECT_EQ(limited->primitive, free->primitive);
        EXPECT_EQ(limited->point, free->point);
        EXPECT_FALSE(rc::closest_point(*world.scene, point, below, kAll));
    }
}

TEST_P(ClosestPoint, ATieGoesToTheLowerInstanceThenTheLowerTriangle) {
    World world;
    world.add(make_ball(glm::vec3(0), 2.0f, 5));
    world.add(make_ball(glm::vec3(0), 2.0f, 5));
    world.commit(GetParam());
    Random random(44);
    const Mesh& ball = world.meshes[0];
    for (int i = 0; i < 200; ++i) {
        const std::uint32_t v = random.below(static_cast<std::uint32_t>(ball.positions.size()));
        const auto nearest = rc::closest_point(*world.scene, ball.positions[v] * 1.5f, rc::kInfinity, kAll);
        ASSERT_TRUE(nearest);
        EXPECT_EQ(nearest->instance, 0u);
        std::uint32_t lowest = 0;  // of the triangles round that vertex
        const auto has = [&](const glm::uvec3& t) { return t.x == v || t.y == v || t.z == v; };
        while (!has(ball.triangles[lowest])) ++lowest;
        EXPECT_EQ(nearest->primitive, lowest);
    }
}

TEST_P(ClosestPoint, OfIdenticalTrianglesTheFirstIsNamed) {
    Mesh pile{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    pile.triangles.assign(100'000, {0, 1, 2});
    World world;
    world.add(std::move(pile));
    world.commit(GetParam());
    const auto nearest = rc::closest_point(*world.scene, {0.2f, 0.3f, 7}, rc::kInfinity, kAll);
    ASSERT_TRUE(nearest);
    EXPECT_EQ(nearest->primitive, 0u);
    EXPECT_EQ(nearest->distance, 7.0f);
    EXPECT_EQ(nearest->point, glm::vec3(0.2f, 0.3f, 0));
    EXPECT_EQ(nearest->normal, glm::vec3(0, 0, 1));
}

std::string name_of(const ::testing::TestParamInfo<rc::BuildQuality>& info) {
    return info.param == rc::BuildQuality::Fast   ? "fast"
           : info.param == rc::BuildQuality::High ? "high"
                                                  : "default";
}
INSTANTIATE_TEST_SUITE_P(EveryQuality, ClosestPoint,
                         ::testing::Values(rc::BuildQuality::Fast, rc::BuildQuality::Default,
                                           rc::BuildQuality::High),
                         name_of);

TEST(ClosestPointAlone, LayersChooseWhoIsNear) {
    const World world = a_museum(rc::BuildQuality::Default);
    Random random(45);
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 point = random.in_cube(5.0f);
        for (std::uint32_t id = 0; id < 5; ++id) {
            const auto nearest = rc::closest_point(*world.scene, point, rc::kInfinity, 1u << id);
            ASSERT_TRUE(nearest);
            EXPECT_EQ(nearest->instance, id);
        }
        EXPECT_FALSE(rc::closest_point(*world.scene, point, rc::kInfinity, 1u << 20));
    }
}

TEST(ClosestPointAlone, OnASurfaceTheDistanceIsZeroAndTheNormalIsTheTriangles) {
    World world;
    world.add(make_sheet(4.0f, 0.0f, 4));
    world.commit();
    const auto on = rc::closest_point(*world.scene, {0.3f, 0, 0.4f}, rc::kInfinity, kAll);
    ASSERT_TRUE(on);
    EXPECT_EQ(on->distance, 0.0f);
    EXPECT_EQ(on->point, glm::vec3(0.3f, 0, 0.4f));
    EXPECT_EQ(std::abs(on->normal.y), 1.0f);
    EXPECT_TRUE(rc::closest_point(*world.scene, {0.3f, 0, 0.4f}, 0.0f, kAll))
        << "no distance at all is far enough";
    EXPECT_TRUE(rc::closest_point(*world.scene, {1.0f, 2.0f, 1.0f}, 2.0f, kAll)) << "the limit is included";
}

TEST(ClosestPointAlone, FarTinyAndHugeScenesAreMeasuredAsWell) {
    Random random(46);
    for (const auto& [at, size] : {std::pair(1e6f, 100.0f), {0.0f, 1e-20f}, {0.0f, 1e15f}, {1e4f, 1.0f}}) {
        World world;
        world.add(make_ball(glm::vec3(0), size, 3), glm::mat4x3(1, 0, 0, 0, 1, 0, 0, 0, 1, at, -at, at));
        world.commit();
        for (int i = 0; i < 60; ++i) {
            const glm::vec3 point = glm::vec3(at, -at, at) + random.in_cube(3.0f * size);
            const auto nearest = rc::closest_point(*world.scene, point, rc::kInfinity, kAll);
            ASSERT_TRUE(nearest);
            expect_truth(world, point, *nearest);
        }
    }
}

TEST(ClosestPointAlone, WhatCanNotBeMetIsNearNobody) {
    EXPECT_FALSE(rc::closest_point(*rc::SceneBuilder{}.commit(), glm::vec3(0), rc::kInfinity, kAll));
    Mesh ball = make_ball(glm::vec3(0), 1.0f, 2);
    const auto blas = rc::build_blas(ball.view());
    rc::SceneBuilder builder;
    builder.add({blas, glm::mat4x3(0.0f)});
    EXPECT_FALSE(rc::closest_point(*builder.commit(), glm::vec3(0), rc::kInfinity, kAll));
    // Refitting may lose triangles for a while: those are nowhere.
    builder.set_transform(0, glm::mat4x3(1.0f));
    for (glm::vec3& p : ball.positions)
        if (p.y > 0) p.x = std::numeric_limits<float>::quiet_NaN();
    rc::refit_blas(*blas, ball.positions);
    const auto nearest = rc::closest_point(*builder.commit(), {0, 5, 0}, rc::kInfinity, kAll);
    ASSERT_TRUE(nearest);
    // What is left begins at the equator, an octagon: the middle of a side is cos(pi / 8) from the axis.
    EXPECT_FLOAT_EQ(nearest->distance, std::sqrt(25.0f + 0.5f * (1.0f + std::sqrt(0.5f))));
}

// Found by fuzzing: a triangle 1e14 m long seemed 5 cm away at a foot 5e12 m off, and only some trees' boxes hid it.
TEST(ClosestPointAlone, TrianglesTooLongForDoublesAreAsNearInEveryTree) {
    World world;
    Mesh mesh{{{3.32421875f, -2.55363941e+14f, -0.0481784232f},
               {3.0f, -3.46944695e-17f, 1.0f},
               {-0.0f, 4.23603412e-23f, 1.28125f},
               {2.26171875f, 3.5f, 1.9921875f},
               {-2.20703125f, 2.5f, -0.71484375f}},
              {{0, 1, 2}, {1, 3, 4}}};
    append(mesh, make_ball({40, 0, 0}, 1.0f, 2));  // so that there is a tree at all
    world.add(std::move(mesh), glm::mat4x3(1, 0, 0, 0.5f, -3.5f, 0, 0, 0, 2.5f, -1.5f, 2.02734f, 0));
    const glm::vec3 point(0.0f, -3.9296875f, 3.0f);
    const long double truth = world.distance_from(point);
    for (const rc::BuildQuality quality :
         {rc::BuildQuality::Fast, rc::BuildQuality::Default, rc::BuildQuality::High}) {
        world.commit(quality);
        const auto nearest = rc::closest_point(*world.scene, point, rc::kInfinity, kAll);
        ASSERT_TRUE(nearest);
        // What a double loses on the way along that triangle, a few times over.
        EXPECT_NEAR(static_cast<double>(nearest->distance), static_cast<double>(truth), 8 * 0x1p-53 * 9e14);
        EXPECT_LT(glm::length(nearest->point - point), 3.0f) << "the point named is where the distance says";
    }
}

TEST(ClosestPointAlone, ABatchIsAnsweredAsEachAlone) {
    const World world = a_museum(rc::BuildQuality::High);
    Random random(47);
    std::vector<glm::vec3> points;
    for (int i = 0; i < 65; ++i) points.push_back(random.in_cube(5.0f));
    std::vector<rc::Nearest> nearest(points.size());
    rc::closest_points(*world.scene, points, 1.0f, kAll, nearest);
    int none = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const rc::Nearest alone =
            rc::closest_point(*world.scene, points[i], 1.0f, kAll).value_or(rc::Nearest{});
        EXPECT_EQ(nearest[i].distance, alone.distance);
        EXPECT_EQ(nearest[i].point, alone.point);
        EXPECT_EQ(nearest[i].normal, alone.normal);
        EXPECT_EQ(nearest[i].primitive, alone.primitive);
        EXPECT_EQ(nearest[i].instance, alone.instance);
        none += alone.is_none();
    }
    EXPECT_GT(none, 3);
    EXPECT_LT(none, 60);
}

#ifdef RC_CONTRACTS
TEST(ClosestPointAlone, NonsenseTrapsInDevelopment) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto scene = rc::SceneBuilder{}.commit();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_DEATH((void)rc::closest_point(*scene, glm::vec3(nan), 1.0f, kAll), "finite point");
    EXPECT_DEATH((void)rc::closest_point(*scene, glm::vec3(0), -1.0f, kAll), "not negative");
    EXPECT_DEATH((void)rc::closest_point(*scene, glm::vec3(0), nan, kAll), "not negative");
}
#else
TEST(ClosestPointAlone, NonsenseIsNearNothingInRelease) {
    const World world = a_museum(rc::BuildQuality::Default);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(rc::closest_point(*world.scene, glm::vec3(nan), 1.0f, kAll));
    EXPECT_FALSE(rc::closest_point(*world.scene, glm::vec3(rc::kInfinity), rc::kInfinity, kAll));
    EXPECT_FALSE(rc::closest_point(*world.scene, glm::vec3(0), -1.0f, kAll));
    EXPECT_FALSE(rc::closest_point(*world.scene, glm::vec3(0), nan, kAll));
}
#endif

}  // namespace
}  // namespace test
