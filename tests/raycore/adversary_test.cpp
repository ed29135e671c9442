// Rays and scenes chosen to break: each still gets the specification's answer, on every instruction set.
#include "support/brute_force.h"
#include "support/isas.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using test::Mesh;
using test::Random;
using test::TestScene;

class Adversary : public ::testing::TestWithParam<rc::Isa> {
  protected:
    test::IsaScope isa_{GetParam()};

    // The whole answer: nearest, whether any, and all in order.
    void expect_brute_force(const TestScene& scene, const rc::Ray& ray, const char* what) {
        const std::vector<rc::Hit> expected = scene.all_hits(ray);
        const auto closest = rc::closest_hit(scene.scene(), ray, rc::kAllLayers);
        ASSERT_EQ(closest.has_value(), !expected.empty()) << what;
        if (closest) {
            ASSERT_TRUE(test::same_bits(*closest, expected.front())) << what;
        }
        ASSERT_EQ(rc::any_hit(scene.scene(), ray, rc::kAllLayers), !expected.empty()) << what;
    }
};

Mesh one_triangle() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
}

TestScene scene_of(const Mesh& mesh, const glm::mat4x3& place = glm::mat4x3(1.0f)) {
    TestScene scene;
    scene.add(mesh, place);
    scene.commit();
    return scene;
}

TEST_P(Adversary, AnEmptySceneIsMetByNothing) {
    const auto scene = rc::SceneBuilder{}.commit();
    EXPECT_FALSE(rc::closest_hit(*scene, {}, rc::kAllLayers));
    EXPECT_FALSE(rc::any_hit(*scene, {}, rc::kAllLayers));
    rc::Hit out[2];
    EXPECT_EQ(rc::crossings(*scene, glm::vec3(-1), glm::vec3(1), rc::kAllLayers, out), 0u);
    EXPECT_GT(scene->bounds().min.x, scene->bounds().max.x);
}

TEST_P(Adversary, ATriangleExactlyAtTMinOrTMaxIsMet) {
    const TestScene scene = scene_of(one_triangle());
    rc::Ray ray{.origin = {0.25f, 0.25f, -3.0f}, .direction = {0, 0, 2}};  // t = 1.5
    for (const auto& [low, high, met] : {std::tuple{1.5f, 1.5f, true},
                                         {1.5f, 9.0f, true},
                                         {0.0f, 1.5f, true},
                                         {std::nextafter(1.5f, 2.0f), 9.0f, false},
                                         {0.0f, std::nextafter(1.5f, 0.0f), false},
                                         {-5.0f, -1.0f, false}}) {
        ray.t_min = low;
        ray.t_max = high;
        EXPECT_EQ(rc::any_hit(scene.scene(), ray, rc::kAllLayers), met) << low << " " << high;
        EXPECT_EQ(rc::closest_hit(scene.scene(), ray, rc::kAllLayers).has_value(), met) << low << " " << high;
    }
}

TEST_P(Adversary, BothSidesOfATriangleCount) {
    const TestScene scene = scene_of(one_triangle());
    for (const float side : {-1.0f, 1.0f}) {
        const auto hit =
            rc::closest_hit(scene.scene(), {.origin = {0.25f, 0.5f, side}, .direction = {0, 0, -side}}, 1);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->t, 1.0f);
        EXPECT_EQ(hit->u, 0.25f);
        EXPECT_EQ(hit->v, 0.5f);
    }
}

TEST_P(Adversary, OfIdenticalTrianglesTheLowestInstanceAndPrimitiveWins) {
    Mesh pile;
    pile.positions = one_triangle().positions;
    pile.triangles.assign(100'000, {0, 1, 2});
    const auto blas = rc::build_blas(pile.view());
    rc::SceneBuilder builder;
    for (int i = 0; i < 3; ++i) builder.add({blas});
    const auto scene = builder.commit();
    const rc::Ray ray{.origin = {0.25f, 0.25f, 1.0f}, .direction = {0, 0, -1}};
    const auto hit = rc::closest_hit(*scene, ray, rc::kAllLayers);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->instance, 0u);
    EXPECT_EQ(hit->primitive, 0u);

    rc::Ray second = ray;
    second.skip_instance = 0;
    second.skip_primitive = 0;
    EXPECT_EQ(rc::closest_hit(*scene, second, rc::kAllLayers)->primitive, 1u);

    rc::Hit out[5];
    ASSERT_EQ(rc::crossings(*scene, {0.25f, 0.25f, 1}, {0.25f, 0.25f, -1}, rc::kAllLayers, out), 5u);
    for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(out[i].primitive, i);
}

TEST_P(Adversary, DirectionsOfAnyLengthAreAnswered) {
    Random random(3);
    const TestScene scene = scene_of(test::make_soup(random, 60, 1.0f, 1.0f));
    for (const float length : {1e-44f, 1e-41f, 1e-38f, 1e-20f, 1.0f, 1e20f, 1e37f, 3e38f})
        for (int i = 0; i < 40; ++i) {
            rc::Ray ray{.origin = random.in_cube(2.0f), .direction = random.direction() * length};
            if (ray.direction == glm::vec3(0.0f)) continue;
            expect_brute_force(scene, ray, "direction of unusual length");
        }
}

TEST_P(Adversary, OriginsFarAwayAreAnswered) {
    Random random(4);
    const TestScene scene = scene_of(test::make_ball(glm::vec3(0.0f), 3.0f, 6));
    for (const float distance : {1e3f, 1e6f, 1e9f, 1e20f, 1e30f, 3e38f}) {
        for (int i = 0; i < 60; ++i) {
            rc::Ray ray{.origin = random.direction() * distance};
            ray.direction = i % 3 == 0 ? -ray.origin : random.in_cube(3.0f) - ray.origin;
            expect_brute_force(scene, ray, "origin far away");
            const std::size_t axis = random.below(3);
            ray.origin = random.in_cube(3.0f);
            ray.direction = glm::vec3(0.0f);
            ray.origin[axis] = distance;
            ray.direction[axis] = -1.0f;
            expect_brute_force(scene, ray, "along an axis from far away");
        }
    }
}

TEST_P(Adversary, RaysInThePlaneOfATriangleAndAlongItsEdges) {
    Random random(5);
    Mesh mesh = test::make_sheet(2.0f, 0.0f, 4);
    test::append(mesh, test::make_box(glm::vec3(-1.0f), glm::vec3(1.0f)));
    const TestScene scene = scene_of(mesh);
    for (int i = 0; i < 300; ++i) {
        const auto grid = [&] { return static_cast<float>(random.below(9)) - 4.0f; };
        rc::Ray ray{.origin = {grid(), static_cast<float>(random.below(3)) - 1.0f, grid()},
                    .direction = {grid(), 0, grid()}};
        if (ray.direction == glm::vec3(0.0f)) ray.direction.x = -1;
        expect_brute_force(scene, ray, "coplanar");
        ray.direction.y = random.below(2) ? 1.0f : -0.0f;
        expect_brute_force(scene, ray, "along edges");
    }
}

TEST_P(Adversary, MirroredSqueezedShearedAndFarInstances) {
    Random random(6);
    const glm::mat4x3 places[] = {
        glm::mat4x3(-1, 0, 0, 0, 1, 0, 0, 0, 1, 3, 0, 0),
        glm::mat4x3(100, 0, 0, 0, 0.01f, 0, 0, 0, 1, 0, 0, 0),
        glm::mat4x3(1, 5, 0, 0, 1, 0, -7, 0, 1, 0, -2, 0),
        glm::mat4x3(1, 0, 0, 0, 1, 0, 0, 0, 1, 1e6f, -1e6f, 1e5f),
        glm::mat4x3(1e-6f, 0, 0, 0, 1e-6f, 0, 0, 0, 1e-6f, 1, 1, 1),
        glm::mat4x3(1e6f, 0, 0, 0, 1e6f, 0, 0, 0, 1e6f, 1, 1, 1),
    };
    const Mesh mesh = test::make_ball({0.5f, 0, 0}, 1.0f, 3);
    for (const glm::mat4x3& place : places) {
        const TestScene scene = scene_of(mesh, place);
        ASSERT_EQ(scene.scene().dropped_instances(), 0u);
        int met = 0;
        for (int i = 0; i < 150; ++i) {
            const auto world = [&](const glm::vec3& p) {
                return place[0] * p.x + place[1] * p.y + place[2] * p.z + place[3];
            };
            rc::Ray ray{.origin = world(random.in_cube(2.5f))};
            ray.direction =
                world(i % 2 ? random.in_cube(1.5f) : mesh.positions[random.below(20)]) - ray.origin;
            if (ray.direction == glm::vec3(0.0f)) continue;
            expect_brute_force(scene, ray, "instance");
            met += rc::any_hit(scene.scene(), ray, rc::kAllLayers);
        }
        EXPECT_GT(met, 50);
    }
}

TEST_P(Adversary, AnInstanceThatCanNotBeMetIsKeptAndCounted) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const auto blas = rc::build_blas(one_triangle().view());
    rc::SceneBuilder builder;
    builder.add({blas, glm::mat4x3(0.0f)});
    builder.add({blas, glm::mat4x3(1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0)});
    builder.add({blas, glm::mat4x3(1, 0, 0, 0, 1, 0, 0, 0, 1, nan, 0, 0)});
    builder.add({blas, glm::mat4x3(1, 0, 0, 0, 1, 0, 0, 0, 1, rc::kInfinity, 0, 0)});
    builder.add({rc::build_blas({})});
    builder.add({nullptr});
    builder.add({blas});
    const auto scene = builder.commit();
    EXPECT_EQ(scene->instance_count(), 7u);
    EXPECT_EQ(scene->dropped_instances(), 6u);
    const auto hit = rc::closest_hit(*scene, {.origin = {0.25f, 0.25f, -1}}, rc::kAllLayers);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->instance, 6u);
}

TEST_P(Adversary, ScenesFromATenthOfAMillimetreToAThousandKilometres) {
    Random random(11);
    TestScene scene;
    Mesh mesh = test::make_soup(random, 40, 1e6f, 4e5f);
    test::append(mesh, test::make_soup(random, 200, 1e-3f, 1e-4f));
    test::append(mesh, test::make_ball(glm::vec3(0.0f), 1.0f, 4));
    scene.add(mesh);
    scene.commit();
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 at = i % 2 ? random.in_cube(1e-3f) : random.in_cube(1e6f);
        rc::Ray ray{.origin = at, .direction = i % 3 ? random.direction() : random.in_cube(1e-3f) - at};
        expect_brute_force(scene, ray, "from 1e-4 m to 1e6 m");
    }
}

INSTANTIATE_TEST_SUITE_P(EveryIsa, Adversary, ::testing::ValuesIn(test::supported_isas()),
                         test::isa_test_name);

}  // namespace
