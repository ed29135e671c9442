// A cast's answer is the scene's and the body's alone: no tree hides a triangle, no batch changes a bit, and the bits are
// those that recordings were made with.
#include "support/brute_force.h"

#include <gtest/gtest.h>

#include <bit>
#include <vector>

namespace test {
namespace {

constexpr rc::LayerMask kAll = rc::kAllLayers;

glm::mat4x3 placed_at(const glm::vec3& at, const glm::vec3& scale) {
    return {glm::vec3(scale.x, 0, 0), glm::vec3(0, scale.y, 0), glm::vec3(0, 0, scale.z), at};
}

// The tree is pruned by what has been met so far; pruned too far, walls vanish.
TEST(Cast, TheTreeHidesNoTriangle) {
    Random random(13);
    const Mesh soup = make_soup(random, 120, 2.0f, 0.8f);
    TestScene scene;
    scene.add(soup);
    scene.commit();
    std::vector<TestScene> alone(soup.triangles.size());
    for (std::size_t i = 0; i < alone.size(); ++i) {
        const glm::uvec3 t = soup.triangles[i];
        alone[i].add({.positions = {soup.positions[t.x], soup.positions[t.y], soup.positions[t.z]},
                      .triangles = {{0, 1, 2}}});
        alone[i].commit();
    }
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 from = random.in_cube(3.0f), along = random.in_cube(i % 2 == 0 ? 0.0f : 0.8f);
        const glm::vec3 way = random.in_cube(3.0f);
        const float radius = random.between(0.0f, 0.2f);
        std::optional<rc::CastHit> first;
        for (std::uint32_t t = 0; t < alone.size(); ++t) {
            const auto hit = rc::capsule_cast(alone[t].scene(), {from, from + along}, radius, way, kAll);
            if (!hit || (first && hit->t >= first->t)) continue;
            first = hit;
            first->primitive = t;
        }
        const auto hit = rc::capsule_cast(scene.scene(), {from, from + along}, radius, way, kAll);
        ASSERT_EQ(hit.has_value(), first.has_value()) << i;
        if (!hit) continue;
        ++hits;
        ASSERT_EQ(hit->primitive, first->primitive) << i;
        ASSERT_EQ(hit->t, first->t) << i;
        ASSERT_EQ(hit->point, first->point) << i;
    }
    EXPECT_GT(hits, 100);
}

TEST(Cast, BatchesAnswerAsSingleCastsDo) {
    Random random(9);
    TestScene scene;
    scene.add(make_soup(random, 200, 2.0f, 0.8f));
    scene.commit();
    std::vector<rc::SphereCast> balls(500);
    std::vector<rc::CapsuleCast> capsules(500);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        balls[i] = {random.in_cube(3.0f), random.between(0.0f, 0.4f), random.in_cube(3.0f)};
        const glm::vec3 from = random.in_cube(3.0f);
        capsules[i] = {{from, from + random.in_cube(1.0f)}, random.between(0.0f, 0.4f), random.in_cube(3.0f)};
    }
    std::vector<rc::CastHit> ball_hits(500), capsule_hits(500);
    rc::sphere_casts(scene.scene(), balls, kAll, ball_hits);
    rc::capsule_casts(scene.scene(), capsules, kAll, capsule_hits);
    const auto same = [](const std::optional<rc::CastHit>& one, const rc::CastHit& many) {
        if (!one) return many.instance == rc::kNone && many.primitive == rc::kNone;
        return one->t == many.t && one->depth == many.depth && one->point == many.point &&
               one->normal == many.normal && one->primitive == many.primitive &&
               one->instance == many.instance;
    };
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const rc::SphereCast& b = balls[i];
        const rc::CapsuleCast& c = capsules[i];
        ASSERT_TRUE(
            same(rc::sphere_cast(scene.scene(), b.centre, b.radius, b.displacement, kAll), ball_hits[i]));
        ASSERT_TRUE(
            same(rc::capsule_cast(scene.scene(), c.axis, c.radius, c.displacement, kAll), capsule_hits[i]));
    }
}

// Recordings depend on these bits: the same for every compiler, optimisation level and processor.
TEST(Cast, BitsAreThoseOfTheFirstDay) {
    Random random(10);
    TestScene scene;
    scene.add(make_soup(random, 500, 2.0f, 0.5f));
    scene.add_instance_of_last(placed_at({1, 2, 3}, {1.5f, -0.7f, 1.1f}));
    scene.commit();
    std::uint64_t sum = 0xCBF29CE484222325u;
    const auto add = [&](std::uint32_t bits) { sum = (sum ^ bits) * 0x100000001B3u; };
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 from = random.in_cube(3.0f), along = random.in_cube(1.0f), way = random.in_cube(4.0f);
        const rc::Segment axis{from, i % 2 == 0 ? from : from + along};
        const auto hit = rc::capsule_cast(scene.scene(), axis, random.between(0.0f, 0.3f), way, kAll);
        const rc::CastHit h = hit.value_or(rc::CastHit{});
        for (const float f :
             {h.t, h.depth, h.point.x, h.point.y, h.point.z, h.normal.x, h.normal.y, h.normal.z})
            add(std::bit_cast<std::uint32_t>(f));
        add(h.primitive);
        add(h.instance);
    }
    EXPECT_EQ(sum, 3868874059482110618u);
}

}  // namespace
}  // namespace test
