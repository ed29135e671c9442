#include "sim/doors.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/level_kit.h"
#include "sim/motion.h"
#include "sim/player.h"
#include "sim/sim_kit.h"
#include "sim/use_target.h"
#include "world/initial_state.h"

namespace gh::sim {
namespace {

using input::Button;
using test::command;
using test::LevelKit;

constexpr float kSouth = 3.1415927f;

// Two rooms with a wall between them at z = 3 and a door 1 m wide in it, hung at x = -0.5, opening towards -z
// (that is, to the player's side) or, with a negative angle, away.
LevelKit two_rooms(float open_angle) {
    LevelKit kit;
    kit.room({-5, 0, -5}, {5, 3, 11})
        .box({-5, 0, 2.95f}, {-0.52f, 3, 3.05f})
        .box({0.52f, 0, 2.95f}, {5, 3, 3.05f})
        .box({-0.52f, 2.02f, 2.95f}, {0.52f, 3, 3.05f})
        .door({-0.5f, 0.01f, 3}, 1.0f, 2.0f, open_angle)
        .spawn({0, 0, 1.6f}, kSouth);
    return kit;
}

TEST(Doors, AClosedDoorStopsAndAnOpenOneLetsPass) {
    Simulation simulation(two_rooms(-1.6f).finish(), 1);
    test::run(simulation, command(kSouth, 0, 1), 120);
    EXPECT_LT(simulation.state().player.position.z, 2.7f);

    test::press(simulation, command(kSouth), Button::Use);
    EXPECT_EQ(simulation.state().doors[0].wants_open, 1);
    EXPECT_EQ(simulation.state().noises[0].kind, world::NoiseKind::Footstep) << "the sound was in the tick of the press";
    test::run(simulation, command(kSouth), 50);
    EXPECT_NEAR(openness(simulation.level(), simulation.state(), 0), 1.0f, 1e-5f);
    test::run(simulation, command(kSouth, 0, 1), 120);
    EXPECT_GT(simulation.state().player.position.z, 3.5f);
}

TEST(Doors, ADoorThatOpensTowardsThePlayerStopsAtHimAndGoesOnWhenHeMakesWay) {
    LevelKit kit = two_rooms(1.6f);
    kit.spawn({0, 0, 2.3f}, kSouth);
    Simulation simulation(kit.finish(), 1);
    test::press(simulation, command(kSouth), Button::Use);
    test::run(simulation, command(kSouth), 90);
    const world::State& state = simulation.state();
    EXPECT_GT(state.doors[0].angle, 0.0f);
    EXPECT_LT(state.doors[0].angle, 1.5f) << "he stands in its way";
    EXPECT_NEAR(state.player.position.z, 2.3f, 0.05f) << "and is not pushed";
    EXPECT_TRUE(has_room(*simulation.snapshot()->scene, body_of(state.player)));
    test::run(simulation, command(0.0f, 0, 1), 90);  // away from it
    EXPECT_NEAR(simulation.state().doors[0].angle, 1.6f, 1e-5f);
}

TEST(Doors, NobodyIsEverInsideADoorHoweverItIsSlammed) {
    LevelKit kit = two_rooms(1.6f);
    kit.spawn({0, 0, 2.0f}, kSouth);
    Simulation simulation(kit.finish(), 1);
    for (int i = 0; i < 600; ++i) {
        const float yaw = kSouth + 0.4f * std::sin(0.05f * static_cast<float>(i));
        const auto use = static_cast<std::uint16_t>(i % 20 == 0 ? Button::Use : 0);
        simulation.step(command(yaw, 0, i % 100 < 60 ? 1.0f : -1.0f, use));
        ASSERT_TRUE(has_room(*simulation.snapshot()->scene, body_of(simulation.state().player))) << "tick " << i;
    }
}

// Oak, iron and a lid of glass: what most of a leaf is made of is what it sounds like, and how loudly.
TEST(Doors, SoundAsWhatTheyAreMadeOf) {
    const auto noise_of = [](world::Surface surface) {
        LevelKit kit;
        kit.surface(surface);
        kit.room({-5, 0, -5}, {5, 3, 5}).door({-0.5f, 0.01f, 1.0f}, 1.0f, 2.0f, -1.6f).spawn({0, 0, 0}, kSouth);
        Simulation simulation(kit.finish(), 1);
        simulation.step(command(kSouth));
        simulation.step(command(kSouth, 0, 0, Button::Use));
        for (std::uint32_t n = 0; n < simulation.state().noise_count; ++n) {
            const world::Noise& noise = simulation.state().noises[n];
            if (noise.kind != world::NoiseKind::DoorOpen) continue;
            EXPECT_EQ(noise.surface, static_cast<std::uint8_t>(surface));
            return noise.loudness_db;
        }
        ADD_FAILURE() << "no door sounded";
        return 0.0f;
    };
    const float oak = noise_of(world::Surface::Oak);
    EXPECT_GT(noise_of(world::Surface::Metal), oak);
    EXPECT_LT(noise_of(world::Surface::Glass), oak);

    // A thin rim of brass about a pane does not make it a metal door.
    LevelKit kit;
    kit.surface(world::Surface::Glass).room({-5, 0, -5}, {5, 3, 5}).door({-0.5f, 0.01f, 1.0f}, 1.0f, 2.0f);
    kit.surface(world::Surface::Metal).door({-0.5f, 0.01f, 1.0f}, 0.05f, 2.0f);
    kit.level.parts.back().mover_index = 0;
    kit.level.doors.pop_back();
    EXPECT_EQ(door_surface(*kit.finish(), 0), world::Surface::Glass);
}

TEST(Doors, TheHudSaysWhatUseWouldDo) {
    Simulation simulation(two_rooms(-1.6f).finish(), 1);
    simulation.step(command(kSouth));
    const auto target = [&] {
        return use_target(simulation.level(), *simulation.snapshot(), simulation.state().player);
    };
    EXPECT_EQ(target().kind, UseKind::Door);
    test::run(simulation, command(0.0f), 1);
    EXPECT_EQ(target().kind, UseKind::Nothing) << "looking away";
    test::run(simulation, command(0.0f, 0, 1), 60);
    test::run(simulation, command(kSouth), 1);
    EXPECT_EQ(target().kind, UseKind::Nothing) << "further off than an arm reaches";
}

TEST(Mirrors, AUseTurnsATurnableMirrorByOneStepInHalfASecond) {
    LevelKit kit;
    kit.room({-5, 0, -5}, {5, 3, 5}).mirror({0, 1.6f, 1.5f}, 0.4f, 0.6f, kSouth, 0.5f).spawn({0, 0, 0}, kSouth);
    Simulation simulation(kit.finish(), 1);
    test::press(simulation, command(kSouth), Button::Use);
    test::run(simulation, command(kSouth), 13);
    EXPECT_NEAR(simulation.state().mirrors[0].angle, 0.25f, 0.02f);
    test::run(simulation, command(kSouth), 20);
    EXPECT_EQ(simulation.state().mirrors[0].angle, 0.5f);
    const glm::vec3 normal = simulation.snapshot()->panes[0].normal;
    EXPECT_NEAR(std::atan2(normal.x, normal.z) - kSouth, 0.5f - 2.0f * kSouth, 1e-3f) << "the pane the guards see in";
}

TEST(Switches, AUseDarkensTheWholeGroupAtOnce) {
    LevelKit kit;
    kit.room({-5, 0, -5}, {5, 3, 5})
        .lamp({0, 2.5f, 0}, 5, "hall")
        .lamp({2, 2.5f, 0}, 5, "hall")
        .lamp({-2, 2.5f, 0}, 0.02f)
        .light_switch({0.1f, 1.3f, 1.4f}, "hall")
        .box({-1, 0, 1.4f}, {1, 3, 1.6f})
        .spawn({0, 0, 0}, kSouth);
    Simulation simulation(kit.finish(), 1);
    test::run(simulation, command(kSouth), 8);
    const float lit = simulation.state().player.exposure;
    test::press(simulation, test::look_at(simulation.state(), {0.1f, 1.3f, 1.4f}), Button::Use);
    EXPECT_EQ(simulation.state().group_on[0], 0);
    EXPECT_FALSE(world::is_lamp_on(simulation.level(), simulation.state(), 1));
    test::run(simulation, command(kSouth), 8);
    EXPECT_LT(simulation.state().player.exposure, 0.5f * lit);
    EXPECT_GT(lit, 0.3f);
}

// A lens in a vitrine: the glass keeps the hand off until the lid is up.
TEST(Lenses, GlassKeepsHandsOffUntilTheLidIsOpen) {
    LevelKit kit;
    kit.room({-5, 0, -5}, {5, 3, 5}).box({-0.3f, 0, 0.9f}, {0.3f, 0.9f, 1.5f}).lens({0, 0.97f, 1.2f});
    const rc::LayerMask glass = world::Light | world::Sound | world::Solid;
    kit.box({-0.3f, 0.9f, 0.9f}, {0.3f, 1.2f, 0.91f}, glass)
        .box({-0.3f, 0.9f, 1.49f}, {0.3f, 1.2f, 1.5f}, glass)
        .box({-0.3f, 0.9f, 0.9f}, {-0.29f, 1.2f, 1.5f}, glass)
        .box({0.29f, 0.9f, 0.9f}, {0.3f, 1.2f, 1.5f}, glass)
        .glass_lid({-0.3f, 1.21f, 1.5f}, 0.6f, 0.6f)
        .exit({-5, 0, -5}, {5, 3, -3})
        .spawn({0, 0, 0.55f}, kSouth);
    Simulation simulation(kit.finish(), 1);
    test::run(simulation, command(kSouth), 2);
    const glm::vec3 lens{0, 0.97f, 1.2f};
    simulation.step(test::look_at(simulation.state(), lens));
    EXPECT_EQ(use_target(simulation.level(), *simulation.snapshot(), simulation.state().player).kind, UseKind::Door);
    test::press(simulation, test::look_at(simulation.state(), lens), Button::Use);
    EXPECT_EQ(simulation.state().lens_taken[0], 0);
    test::run(simulation, test::look_at(simulation.state(), lens), 60);
    ASSERT_NEAR(openness(simulation.level(), simulation.state(), 0), 1.0f, 1e-4f);
    test::press(simulation, test::look_at(simulation.state(), lens), Button::Use);
    EXPECT_EQ(simulation.state().lens_taken[0], 1);
    EXPECT_EQ(simulation.state().rules.outcome, world::Outcome::Playing);
    test::run(simulation, command(0.0f, 0, 1), 150);
    EXPECT_EQ(simulation.state().rules.outcome, world::Outcome::Won);
    const glm::vec3 at = simulation.state().player.position;
    test::run(simulation, command(kSouth, 0, 1), 60);
    EXPECT_NEAR(simulation.state().player.position.z, at.z, 0.2f) << "who has won stands and looks about";
}

}  // namespace
}  // namespace gh::sim
