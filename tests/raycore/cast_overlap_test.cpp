// What pushes a character out of a door that has closed on it.
#include "support/brute_force.h"

#include "raycore/cast_oracle.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace test {
namespace {

constexpr rc::LayerMask kAll = rc::kAllLayers;

struct Body {
    rc::Segment axis;
    float radius;
};

Body a_body(Random& random) {
    const glm::vec3 from = random.in_cube(1.5f);
    return {{from, from + random.in_cube(0.8f)}, random.between(0.05f, 0.4f)};
}

TEST(CastOverlap, EveryTriangleWithinReachIsFoundDeepestFirst) {
    Random random(21);
    const Mesh soup = make_soup(random, 60, 1.2f, 1.5f);
    TestScene scene;
    scene.add(soup);
    scene.commit();
    int contacts = 0;
    for (int i = 0; i < 60; ++i) {
        const Body body = a_body(random);
        std::vector<rc::CastHit> out(60);
        out.resize(rc::capsule_overlaps(scene.scene(), body.axis, body.radius, kAll, out));
        std::vector<bool> is_found(60, false);
        for (std::size_t k = 0; k < out.size(); ++k) {
            ASSERT_TRUE(k == 0 || out[k - 1].depth >= out[k].depth);
            ASSERT_FALSE(is_found[out[k].primitive]) << "one contact a triangle";
            is_found[out[k].primitive] = true;
        }
        contacts += static_cast<int>(out.size());
        for (std::uint32_t t = 0; t < 60; ++t) {
            const glm::uvec3 v = soup.triangles[t];
            const Triangle triangle = {soup.positions[v.x], soup.positions[v.y], soup.positions[v.z]};
            const long double distance = distance_at(body.axis, glm::vec3(0), 0, triangle);
            const auto spare = distance - static_cast<long double>(body.radius);
            if (std::abs(spare) < 2e-6L) continue;  // touching
            ASSERT_EQ(is_found[t], spare < 0) << "triangle " << t << " at " << static_cast<double>(distance);
        }
    }
    EXPECT_GT(contacts, 200);
}

TEST(CastOverlap, ASmallListKeepsTheDeepest) {
    Random random(22);
    TestScene scene;
    scene.add(make_soup(random, 300, 1.0f, 0.5f));
    scene.commit();
    for (int i = 0; i < 100; ++i) {
        const Body body = a_body(random);
        std::vector<rc::CastHit> all(300), few(3);
        all.resize(rc::capsule_overlaps(scene.scene(), body.axis, body.radius, kAll, all));
        few.resize(rc::capsule_overlaps(scene.scene(), body.axis, body.radius, kAll, few));
        ASSERT_EQ(few.size(), std::min<std::size_t>(all.size(), 3));
        for (std::size_t k = 0; k < few.size(); ++k) ASSERT_EQ(few[k].primitive, all[k].primitive);
        EXPECT_EQ(rc::capsule_overlaps(scene.scene(), body.axis, body.radius, kAll, {}), 0u);
    }
}

// Pushed by depth along the normal, one triangle is left behind.
TEST(CastOverlap, TheNormalAndTheDepthAreTheWayOut) {
    Random random(23);
    int pushed = 0;
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 a = random.in_cube(1.0f), b = random.in_cube(1.0f), c = random.in_cube(1.0f);
        TestScene scene;
        scene.add({.positions = {a, b, c}, .triangles = {{0, 1, 2}}});
        scene.commit();
        Body body = a_body(random);
        rc::CastHit hit;
        if (rc::capsule_overlaps(scene.scene(), body.axis, body.radius, kAll, {&hit, 1}) == 0) continue;
        ++pushed;
        ASSERT_NEAR(glm::length(hit.normal), 1.0f, 1e-6f);
        const glm::vec3 out = hit.normal * (hit.depth + 1e-5f);
        body.axis = {body.axis.from + out, body.axis.to + out};
        ASSERT_EQ(rc::capsule_overlaps(scene.scene(), body.axis, body.radius, kAll, {&hit, 1}), 0u) << i;
    }
    EXPECT_GT(pushed, 50);
}

TEST(CastOverlap, TouchingIsNotOverlapping) {
    TestScene scene;
    scene.add(make_sheet(2.0f, 0.0f, 2));
    scene.commit();
    std::vector<rc::CastHit> out(8);
    EXPECT_EQ(rc::capsule_overlaps(scene.scene(), {{0.1f, 0.25f, 0}, {0.1f, 1.25f, 0}}, 0.25f, kAll, out),
              0u);
    EXPECT_GT(rc::capsule_overlaps(scene.scene(), {{0.1f, 0.249f, 0}, {0.1f, 1.25f, 0}}, 0.25f, kAll, out),
              0u);
}

}  // namespace
}  // namespace test
