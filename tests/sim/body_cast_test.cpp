#include "sim/body_cast.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"
#include "sim/level_kit.h"
#include "sim/stone_flight.h"
#include "spatial/stage.h"
#include "world/initial_state.h"

namespace gh::sim {
namespace {

constexpr Body kMan{.feet = {2.0f, 0.0f, -1.0f}, .radius = 0.3f, .height = 1.8f};
constexpr float kBall = 0.035f;

// The distance from a body's axis, in doubles: what the closed form is held against.
double metres_from_axis(const glm::vec3& p) {
    const glm::dvec3 m = glm::dvec3(p) - glm::dvec3(kMan.feet);
    const double y = std::clamp(m.y, 0.0, 1.5);
    return std::sqrt(m.x * m.x + (m.y - y) * (m.y - y) + m.z * m.z);
}

// A hundred thousand balls from all round: the place of a hit lies on the skin, and nothing on the way to it lies
// inside; a miss never comes near.
TEST(BodyCast, MeetsTheSkinWhereAFineWalkAlongTheWayMeetsIt) {
    Random random(5);
    const double reach = 0.335;
    int hits = 0;
    for (int i = 0; i < 100'000; ++i) {
        const glm::vec3 from = kMan.feet + glm::vec3(random.in_range(-2, 2), random.in_range(-1, 3), random.in_range(-2, 2));
        const glm::vec3 along{random.in_range(-3, 3), random.in_range(-3, 3), random.in_range(-3, 3)};
        if (metres_from_axis(from) < reach + 1e-4) continue;
        const auto hit = cast_at_body(kMan, from, kBall, along);
        double nearest = 9.0;
        const float end = hit ? hit->t : 1.0f;
        for (int k = 0; k <= 40; ++k) {
            nearest = std::min(nearest, metres_from_axis(from + along * (end * static_cast<float>(k) / 40.0f)));
        }
        EXPECT_GT(nearest, reach - 2e-5) << i;
        if (!hit) continue;
        ++hits;
        EXPECT_NEAR(metres_from_axis(from + along * hit->t), reach, 2e-5) << i;
        EXPECT_NEAR(metres_from_axis(hit->point), 0.3, 2e-5) << i;
        EXPECT_LT(glm::dot(hit->normal, along), 0.0f) << i;
        EXPECT_NEAR(glm::length(hit->normal), 1.0f, 1e-5f) << i;
    }
    EXPECT_GT(hits, 3'000);
}

TEST(BodyCast, LetsOutWhoeverStartsInside) {
    const glm::vec3 inside = kMan.feet + glm::vec3(0.2f, 1.0f, 0.0f);
    EXPECT_FALSE(cast_at_body(kMan, inside, kBall, {1.0f, 0.0f, 0.0f}));
    EXPECT_FALSE(cast_at_body(kMan, inside, kBall, glm::vec3(0.0f)));
    const auto deeper = cast_at_body(kMan, inside, kBall, {-1.0f, 0.0f, 0.0f});
    ASSERT_TRUE(deeper);
    EXPECT_EQ(deeper->t, 0.0f);
    EXPECT_EQ(deeper->normal, glm::vec3(1.0f, 0.0f, 0.0f));
}

// What rolls along the floor against a boot is turned away level, never pressed down.
TEST(BodyCast, AFootIsAsWideAsTheHips) {
    const auto hit = cast_at_body(kMan, kMan.feet + glm::vec3(1.0f, kBall, 0.0f), kBall, {-2.0f, 0.0f, 0.0f});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->normal.y, 0.0f);
    EXPECT_NEAR(hit->t, (1.0f - 0.335f) / 2.0f, 1e-6f);
}

struct Place {
    std::shared_ptr<const world::Level> level;
    std::shared_ptr<const rc::Scene> scene;

    explicit Place(test::LevelKit& kit)
        : level(kit.finish()), scene(spatial::Stage(level).commit(world::initial_state(*level, 0)).scene) {}
};

// Thrown at a man from every side at 1 to 1000 m/s: the stone is never inside him, leaves the room nowhere, and has
// less energy afterwards.
TEST(BodyCast, NoStonePassesThroughAManNorTheWallBehindHim) {
    test::LevelKit kit;
    kit.room({-4, 0, -4}, {4, 3, 4});
    const Place place(kit);
    const Body men[] = {{.feet = {3.6f, 0, 0}, .radius = 0.3f, .height = 1.8f}, {.feet = {0, 0, 0}, .radius = 0.3f, .height = 1.8f}};
    Random random(12);
    int struck = 0;
    for (int i = 0; i < 20'000; ++i) {
        const float speed = std::exp(random.unit() * 6.9077553f);
        const glm::vec3 from{random.in_range(-3.5f, -1.0f), random.in_range(0.2f, 2.5f), random.in_range(-3.0f, 3.0f)};
        const glm::vec3 at{random.in_range(-0.3f, 0.3f), random.in_range(0.1f, 1.7f), random.in_range(-0.3f, 0.3f)};
        world::StoneState stone;
        stone.position = from;
        stone.velocity = glm::normalize(at - from) * speed;
        stone.is_present = 1;
        for (int tick = 0; tick < 30; ++tick) {
            const Impact impact = fly(*place.level, *place.scene, stone, men);
            struck += impact.guard != world::kNoIndex;
            const glm::vec3& p = stone.position;
            ASSERT_TRUE(std::abs(p.x) < 3.97f && std::abs(p.z) < 3.97f && 0.03f < p.y && p.y < 2.97f) << i;
            for (const Body& man : men) {
                const glm::vec3 m = p - man.feet;
                ASSERT_FALSE(std::hypot(m.x, m.z) < 0.334f && m.y < 1.5f) << "throw " << i << " tick " << tick;
            }
            ASSERT_LT(glm::length(stone.velocity), speed + 9.0f) << i;
        }
    }
    EXPECT_GT(struck, 5'000);
}

}  // namespace
}  // namespace gh::sim
