#include "sim/stone_flight.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "base/random.h"
#include "sim/level_kit.h"
#include "sim/motion.h"
#include "spatial/stage.h"
#include "world/initial_state.h"

namespace gh::sim {
namespace {

using test::LevelKit;

struct Place {
    std::shared_ptr<const world::Level> level;
    std::shared_ptr<const rc::Scene> scene;

    explicit Place(LevelKit& kit)
        : level(kit.finish()), scene(spatial::Stage(level).commit(world::initial_state(*level, 0)).scene) {}
};

world::StoneState stone_at(const glm::vec3& position, const glm::vec3& velocity) {
    world::StoneState stone;
    stone.position = position;
    stone.velocity = velocity;
    stone.is_present = 1;
    return stone;
}

double energy(const world::StoneState& stone) {
    const glm::dvec3 v(stone.velocity);
    return 0.5 * glm::dot(v, v) + 9.81 * static_cast<double>(stone.position.y);
}

// Dropped from 2 m on marble (e = 0.6) at 60 Hz: apex n is e^(2n) of the drop, as in the open-form solution.
TEST(StoneFlight, BouncesReachTheHeightsOfTheClosedFormAndEnd) {
    LevelKit kit;
    kit.room({-5, 0, -5}, {5, 4, 5});
    const Place place(kit);
    const float rest = place.level->stone_radius;
    world::StoneState stone = stone_at({0.3f, rest + 2.0f, 0.2f}, glm::vec3(0.0f));
    std::vector<double> apexes;
    int rest_tick = 0;
    for (int tick = 1; tick <= 1200 && stone.is_resting == 0; ++tick) {
        const world::StoneState before = stone;
        fly(*place.level, *place.scene, stone);
        if (before.velocity.y > 0.0f && stone.velocity.y <= 0.0f && stone.is_resting == 0) {
            // The exact apex of the arc this tick began on: sampling at ticks would lose up to 0.3 mm.
            const float left = before.velocity.y * before.velocity.y / (2.0f * kGravity);
            apexes.push_back(static_cast<double>(before.position.y + left - rest));
        }
        rest_tick = tick;
    }
    ASSERT_GE(apexes.size(), 4u);
    for (int n = 1; n <= 4; ++n) {
        const double expected = 2.0 * std::pow(0.36, n);
        EXPECT_NEAR(apexes[static_cast<std::size_t>(n - 1)], expected, 0.01 * expected) << "bounce " << n;
    }
    EXPECT_NEAR(rest_tick, 152, 3) << "the sum of all bounces is 2.55 s";
    EXPECT_NEAR(stone.position.y, rest, 1e-3f);
}

TEST(StoneFlight, AStoneAtRestKeepsItsBitsForTenSeconds) {
    LevelKit kit;
    kit.room({-5, 0, -5}, {5, 4, 5});
    const Place place(kit);
    world::StoneState stone = stone_at({0.0f, 1.5f, 0.0f}, {3.0f, 1.0f, -2.0f});
    int ticks = 0;
    while (stone.is_resting == 0 && ticks < 1200) {
        fly(*place.level, *place.scene, stone);
        ++ticks;
    }
    ASSERT_LT(ticks, 1200) << "rest within 20 s";
    const world::StoneState rested = stone;
    for (int i = 0; i < 600; ++i) fly(*place.level, *place.scene, stone);
    EXPECT_EQ(stone.position, rested.position);
    EXPECT_EQ(stone.velocity, glm::vec3(0.0f));
    EXPECT_EQ(stone.is_resting, 1);
}

TEST(StoneFlight, EnergyNeverGrows) {
    LevelKit kit;
    kit.room({-5, 0, -5}, {5, 4, 5}).box({-1, 0, -1}, {1, 0.8f, 1}).ramp(2, -5, 5, 35, 3);
    const Place place(kit);
    Random random(9);
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 velocity{random.in_range(-12, 12), random.in_range(-4, 8), random.in_range(-12, 12)};
        world::StoneState stone = stone_at({-3.0f, 1.5f, random.in_range(-3, 3)}, velocity);
        double most = energy(stone);
        for (int tick = 0; tick < 240; ++tick) {
            fly(*place.level, *place.scene, stone);
            const double now = energy(stone);
            EXPECT_LE(now, most * 1.0001 + 1e-3) << "throw " << i << " tick " << tick;
            most = std::min(most, now);
        }
    }
}

// Log-uniform speeds from a walk to a bullet, in a closed room with a box and a thin wall in it.
TEST(StoneFlight, NoStoneLeavesAClosedRoomIn100000Throws) {
    LevelKit kit;
    kit.room({-4, 0, -4}, {4, 3, 4}).box({-1, 0, -1}, {1, 1, 1}).box({2, 0, -4}, {2.01f, 3, 3});
    const Place place(kit);
    Random random(11);
    int escapes = 0;
    for (int i = 0; i < 100'000; ++i) {
        const float speed = std::exp(random.unit() * 6.9077553f);  // 1 .. 1000 m/s
        const float z = random.in_range(-1.0f, 1.0f), turn = random.unit() * 6.2831853f;
        const float r = std::sqrt(1.0f - z * z);
        const glm::vec3 direction{r * std::cos(turn), z, r * std::sin(turn)};
        world::StoneState stone = stone_at({-2.5f, random.in_range(0.2f, 2.8f), random.in_range(-3.5f, 3.5f)},
                                           direction * speed);
        for (int tick = 0; tick < 2; ++tick) fly(*place.level, *place.scene, stone);
        const glm::vec3& p = stone.position;
        const float keep = 0.9f * place.level->stone_radius;
        escapes += !(std::abs(p.x) < 4.0f - keep && std::abs(p.z) < 4.0f - keep && keep < p.y && p.y < 3.0f - keep);
    }
    EXPECT_EQ(escapes, 0);
}

TEST(StoneFlight, RollingOverTheSeamsOfAFloorOfManyTrianglesRaisesNoBump) {
    LevelKit kit;
    kit.room({-20, -1, -5}, {20, 4, 5});
    for (int i = -19; i < 19; ++i) {
        const float x = static_cast<float>(i);
        kit.box({x, -0.5f, -2}, {x + 1.0f, 0.0f, 2});
    }
    const Place place(kit);
    const float rest = place.level->stone_radius;
    world::StoneState stone = stone_at({-10.0f, rest + kStoneSkin, 0.13f}, {5.0f, 0.0f, 0.05f});
    float highest = 0.0f;
    for (int i = 0; i < 400; ++i) {
        fly(*place.level, *place.scene, stone);
        highest = std::max(highest, stone.position.y - rest);
    }
    EXPECT_LT(highest, 1e-3f);
    EXPECT_GT(stone.position.x, -8.0f) << "it did roll";
    EXPECT_EQ(stone.is_resting, 1);
}

TEST(StoneFlight, CarpetSwallowsWhatMarbleThrowsBack) {
    const auto first_rebound = [](world::Surface surface) {
        LevelKit kit;
        kit.surface(surface).room({-5, 0, -5}, {5, 4, 5});
        const Place place(kit);
        world::StoneState stone = stone_at({0, 1, 0}, glm::vec3(0.0f));
        for (int i = 0; i < 120; ++i) {
            const Impact impact = fly(*place.level, *place.scene, stone);
            if (impact.is_there) {
                EXPECT_EQ(impact.surface, surface);
                return stone.velocity.y / impact.speed;
            }
        }
        return -1.0f;
    };
    EXPECT_GT(first_rebound(world::Surface::Marble), 0.5f);
    EXPECT_LT(first_rebound(world::Surface::Carpet), 0.16f);
}

TEST(StoneFlight, AStoneWhoseShelfIsGoneFallsAgain) {
    LevelKit with_shelf;
    with_shelf.room({-5, 0, -5}, {5, 4, 5}).box({-1, 1, -1}, {1, 1.1f, 1});
    LevelKit without;
    without.room({-5, 0, -5}, {5, 4, 5});
    const Place before(with_shelf), after(without);
    world::StoneState stone = stone_at({0, 1.3f, 0}, glm::vec3(0.0f));
    for (int i = 0; i < 400; ++i) fly(*before.level, *before.scene, stone);
    ASSERT_EQ(stone.is_resting, 1);
    ASSERT_GT(stone.position.y, 1.0f);
    for (int i = 0; i < 400; ++i) fly(*after.level, *after.scene, stone);
    EXPECT_EQ(stone.is_resting, 1);
    EXPECT_NEAR(stone.position.y, after.level->stone_radius, 1e-3f);
}

}  // namespace
}  // namespace gh::sim
