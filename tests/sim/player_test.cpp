#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "base/random.h"
#include "sim/level_kit.h"
#include "sim/noises.h"
#include "sim/player.h"
#include "sim/sim_kit.h"
#include "sim/simulation.h"
#include "world/initial_state.h"
#include "world/state_hash.h"

namespace gh::sim {
namespace {

using input::Button;
using test::command;
using test::LevelKit;

constexpr float kSouth = 3.1415927f;  // +z

LevelKit hall() {
    LevelKit kit;
    kit.room({-10, 0, -10}, {10, 4, 10}).spawn({0, 0, 0}, 0);
    return kit;
}

float distance_walked(Simulation& simulation, const input::Command& with, int ticks) {
    const glm::vec3 from = simulation.state().player.position;
    test::run(simulation, with, ticks);
    const glm::vec3 to = simulation.state().player.position;
    return std::hypot(to.x - from.x, to.z - from.z);
}

TEST(Player, WalksRunsAndSneaksAtTheSpeedsTheGuardsAreMadeFor) {
    for (const auto& [buttons, speed] : {std::pair<std::uint16_t, float>{0, kWalkSpeed},
                                         {Button::Run, kRunSpeed},
                                         {Button::Crouch, kCrouchSpeed}}) {
        Simulation simulation(hall().finish(), 1);
        test::run(simulation, command(kSouth, 0, 1, buttons), 30);
        EXPECT_NEAR(distance_walked(simulation, command(kSouth, 0, 1, buttons), 60), speed, 0.01f);
    }
}

TEST(Player, WalksWhereTheYawLooks) {
    Simulation simulation(hall().finish(), 1);
    test::run(simulation, command(1.5707964f, 0, 1), 60);
    EXPECT_LT(simulation.state().player.position.x, -1.5f) << "a quarter turn to the left of -z is -x";
    EXPECT_NEAR(simulation.state().player.position.z, 0.0f, 0.01f);
}

TEST(Player, JumpsOneMetreHighAndLandsWhereItLeft) {
    Simulation simulation(hall().finish(), 1);
    test::run(simulation, command(0), 5);
    ASSERT_EQ(simulation.state().player.is_grounded, 1);
    float highest = 0.0f;
    bool landed_loudly = false;
    for (int i = 0; i < 90; ++i) {
        simulation.step(command(0, 0, 0, Button::Jump));
        highest = std::max(highest, simulation.state().player.position.y);
        for (std::uint32_t n = 0; n < simulation.state().noise_count; ++n) {
            landed_loudly |= simulation.state().noises[n].kind == world::NoiseKind::Land;
        }
    }
    EXPECT_NEAR(highest, 1.0f, 0.01f);
    EXPECT_EQ(simulation.state().player.is_grounded, 1) << "holding the key jumps once";
    EXPECT_NEAR(simulation.state().player.position.y, 0.0f, 1e-3f);
    EXPECT_TRUE(landed_loudly);
}

TEST(Player, CrouchesUnderALowBeamAndCanNotStandUpBeneathIt) {
    LevelKit kit = hall();
    kit.box({-10, 1.2f, 2}, {10, 4, 4});
    Simulation simulation(kit.finish(), 1);
    test::run(simulation, command(kSouth, 0, 1), 120);
    EXPECT_LT(simulation.state().player.position.z, 2.0f) << "upright one does not fit";

    test::run(simulation, command(kSouth, 0, 0, Button::Crouch), 12);
    EXPECT_NEAR(simulation.state().player.height, world::kCrouchingHeight, 1e-4f) << "down within 0.2 s";
    test::run(simulation, command(kSouth, 0, 1, Button::Crouch), 90);
    ASSERT_GT(simulation.state().player.position.z, 2.5f);
    ASSERT_LT(simulation.state().player.position.z, 4.0f);

    test::run(simulation, command(kSouth), 60);
    EXPECT_NEAR(simulation.state().player.height, world::kCrouchingHeight, 0.1f) << "head room is 1.2 m";
    EXPECT_EQ(simulation.state().player.stance, world::Stance::Crouch);
    test::run(simulation, command(kSouth, 0, 1), 150);
    test::run(simulation, command(kSouth), 30);
    EXPECT_GT(simulation.state().player.position.z, 4.3f);
    EXPECT_NEAR(simulation.state().player.height, world::kStandingHeight, 1e-4f) << "up again behind it";
}

TEST(Player, LeansAsFarAsTheArmAndNeverThroughAWall) {
    LevelKit kit = hall();
    kit.box({0.5f, 0, -10}, {0.6f, 4, 10});
    Simulation simulation(kit.finish(), 1);
    test::run(simulation, command(0, 0, 0, Button::LeanLeft), 30);
    EXPECT_NEAR(world::eye_of(simulation.state().player).x, -world::kLeanReach, 1e-3f);
    test::run(simulation, command(0, 0, 0, Button::LeanRight), 60);
    EXPECT_LT(world::eye_of(simulation.state().player).x, 0.5f - 0.14f);
    EXPECT_GT(world::eye_of(simulation.state().player).x, 0.2f);
    test::run(simulation, command(0), 30);
    EXPECT_EQ(simulation.state().player.lean, 0.0f);
}

int footsteps(Simulation& simulation, const input::Command& with, int ticks, float* loudest = nullptr) {
    int steps = 0;
    for (int i = 0; i < ticks; ++i) {
        simulation.step(with);
        for (std::uint32_t n = 0; n < simulation.state().noise_count; ++n) {
            const world::Noise& noise = simulation.state().noises[n];
            if (noise.kind != world::NoiseKind::Footstep) continue;
            ++steps;
            if (loudest != nullptr) *loudest = std::max(*loudest, noise.loudness_db);
        }
    }
    return steps;
}

TEST(Player, IsHeardByStrideSurfaceAndStance) {
    float on_marble = 0, on_carpet = 0, running = 0, sneaking = 0;
    Simulation marble(hall().finish(), 1);
    EXPECT_NEAR(footsteps(marble, command(kSouth, 0, 1), 180, &on_marble), 8, 1) << "6 m in steps of 0.75 m";
    LevelKit soft;
    soft.surface(world::Surface::Carpet).room({-10, 0, -10}, {10, 4, 10});
    Simulation carpet(soft.finish(), 1);
    footsteps(carpet, command(kSouth, 0, 1), 120, &on_carpet);
    Simulation runner(hall().finish(), 1);
    footsteps(runner, command(kSouth, 0, 1, Button::Run), 90, &running);
    Simulation sneak(hall().finish(), 1);
    footsteps(sneak, command(kSouth, 0, 1, Button::Crouch), 120, &sneaking);
    EXPECT_EQ(on_marble, footstep_db(world::Surface::Marble, Gait::Walk));
    EXPECT_EQ(on_carpet, footstep_db(world::Surface::Carpet, Gait::Walk));
    EXPECT_GT(running, on_marble);
    EXPECT_LT(sneaking, on_carpet);
    EXPECT_EQ(footsteps(marble, command(kSouth), 120), 0) << "who stands is silent";
}

TEST(Player, IsCarriedBackWhenHeFallsOutOfTheWorld) {
    LevelKit kit;
    kit.box({-1, -1, -1}, {1, 0, 1}).spawn({0, 0, 0}, 0);  // an island in nothing
    Simulation simulation(kit.finish(), 1);
    test::run(simulation, command(kSouth, 0, 1), 60);
    EXPECT_LT(simulation.state().player.position.y, 0.0f);
    test::run(simulation, command(kSouth), 300);
    EXPECT_NEAR(simulation.state().player.position.y, 0.0f, 1e-3f);
}

// Whatever anybody does with the keys, the room keeps him.
TEST(Player, StaysInTheRoomUnderRandomKeysForAMinute) {
    LevelKit kit;
    kit.room({-3, 0, -3}, {3, 3, 3}).box({-1, 0, -1}, {1, 0.3f, 1}).box({1, 0, 1}, {2, 1.2f, 2}).spawn({-2, 0, -2}, 0);
    Simulation simulation(kit.finish(), 1);
    Random random(3);
    input::Command next;
    for (int i = 0; i < 3600; ++i) {
        if (i % 12 == 0) {
            next = command(random.in_range(-3, 3), random.in_range(-1, 1), 1.0f,
                           static_cast<std::uint16_t>(random.next_u32() & (Button::Run | Button::Crouch | Button::Jump)));
        }
        simulation.step(next);
        const glm::vec3& p = simulation.state().player.position;
        ASSERT_TRUE(std::abs(p.x) < 2.71f && std::abs(p.z) < 2.71f && -1e-3f < p.y && p.y < 2.0f)
            << "tick " << i << ": " << p.x << " " << p.y << " " << p.z;
    }
}

}  // namespace
}  // namespace gh::sim
