// The hand mirror: it shows what is round the corner, and shows the player to whoever stands there.
#include "spatial/hand_mirror.h"

#include "base/det_math.h"
#include "sim/geometry.h"
#include "sim/level_kit.h"
#include "sim/sim_kit.h"
#include "sim/use_target.h"
#include "world/eye.h"
#include "world/state_hash.h"

#include "raycore/query.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gh {
namespace {

using input::Button;
using test::command;
using test::LevelKit;

constexpr std::uint16_t kUp = Button::HandMirror;
constexpr std::uint16_t kUpAndRight = Button::HandMirror | Button::LeanRight;

// Seen from above: a wall along z = 0 ends at x = 0. The player stands before its end, looking along -z; round the
// corner, to the right and behind the wall, there is room for a guard.
//
//         guard?  x
//      #########            <- wall, z in [-0.2, 0], x in [0.4, 6]
//      player ^  (0, 0, 0.45)
LevelKit corner() {
    LevelKit kit;
    kit.room({-6, 0, -8}, {6, 3, 8})
        .box({0.4f, 0, -0.2f}, {6, 3, 0.0f})
        .lamp({-2, 2.8f, 2}, 30)
        .lamp({2, 2.8f, -2}, 30)
        .spawn({0.05f, 0, 0.45f}, 0)
        .mirror({0.05f, 1.0f, -0.35f}, 0.08f, 0.1f, 0.0f, 0.0f);
    kit.level.hand_mirror = 0;
    kit.level.parts.back().layers = world::Light | world::Sight;
    return kit;
}

void take_it(sim::Simulation& simulation) {
    test::press(simulation, test::look_at(simulation.state(), {0.05f, 1.0f, -0.35f}), Button::Use);
    ASSERT_EQ(simulation.state().player.has_mirror, 1);
}

// Nobody holds up what still lies on the table, and it can be taken once.
TEST(HandMirror, IsTakenWhereItLiesAndOnlyThenHeldUp) {
    sim::Simulation simulation(corner().finish(), 1);
    test::run(simulation, command(0, 0, 0, kUp), 30);
    EXPECT_EQ(simulation.state().player.mirror_raise, 0.0f);
    const input::Command look = test::look_at(simulation.state(), {0.05f, 1.0f, -0.35f});
    simulation.step(look);
    EXPECT_EQ(sim::use_target(simulation.level(), *simulation.snapshot(), simulation.state().player).kind,
              sim::UseKind::HandMirror);
    take_it(simulation);
    simulation.step(look);
    EXPECT_EQ(sim::use_target(simulation.level(), *simulation.snapshot(), simulation.state().player).kind,
              sim::UseKind::Nothing);
    test::run(simulation, command(0, 0, 0, kUp), 30);
    EXPECT_EQ(simulation.state().player.mirror_raise, 1.0f);
}

// In the pocket it neither shows nor hides anything: no ray of any kind meets it.
TEST(HandMirror, IsNotThereWhilePutAway) {
    sim::Simulation simulation(corner().finish(), 1);
    take_it(simulation);
    test::run(simulation, command(0), 30);
    const auto& now = *simulation.snapshot();
    for (int i = 0; i < 64; ++i) {
        const float yaw = kTwoPi * static_cast<float>(i) / 64.0f;
        const rc::Ray ray{.origin = world::eye_of(now.state.player), .direction = world::forward_of_yaw(yaw)};
        const auto hit = rc::closest_hit(*now.scene, ray, rc::kAllLayers);
        ASSERT_TRUE(hit);
        EXPECT_NE(hit->instance, now.panes[0].part);
    }
}

// What the eye finds in the pane's middle lies where it is said to: the law of reflection at the pane that is drawn.
TEST(HandMirror, ShowsWhatLiesRoundTheCornerToWhicheverSideItIsHeld) {
    for (const int side : {-1, 0, 1}) {
        for (const float pitch : {-0.5f, 0.0f, 0.4f}) {
            LevelKit kit = corner();
            kit.spawn({-3, 0, 4}, 0);  // away from walls
            kit.level.mirrors[0].pivot = {-3, 1.0f, 3.2f};
            sim::Simulation simulation(kit.finish(), 1);
            test::press(simulation, test::look_at(simulation.state(), {-3, 1.0f, 3.2f}), Button::Use);
            const auto lean = static_cast<std::uint16_t>(side < 0   ? Button::LeanLeft
                                                         : side > 0 ? Button::LeanRight
                                                                    : 0);
            test::run(simulation, command(0, pitch, 0, static_cast<std::uint16_t>(kUp | lean)), 40);
            const auto& now = *simulation.snapshot();
            EXPECT_EQ(now.state.player.lean, 0.0f) << "the arm leans, not the head";
            const world::MirrorPane& pane = now.panes[0];
            const glm::vec3 eye = world::eye_of(now.state.player);
            const rc::Ray look{.origin = eye, .direction = pane.centre - eye, .t_max = 1.001f};
            const auto hit = rc::closest_hit(*now.scene, look, world::Light);
            ASSERT_TRUE(hit && hit->instance == pane.part) << "the pane is in plain view of its owner";
            const glm::vec3 in = sim::unit_or_zero(look.direction);
            const glm::vec3 out = in - pane.normal * (2.0f * glm::dot(in, pane.normal));
            const glm::vec3 expected = side == 0 ? glm::vec3(std::sin(0.3f), 0, std::cos(0.3f))
                                                 : glm::vec3(static_cast<float>(side), 0, 0);
            EXPECT_NEAR(sim::length_of(out - expected), 0.0f, 2e-4f)
                << "side " << side << ", pitch " << pitch;
            EXPECT_NEAR(
                pane.half_v.x * pane.half_v.x + pane.half_v.y * pane.half_v.y + pane.half_v.z * pane.half_v.z,
                0.01f, 1e-5f)
                << "it keeps its size";
        }
    }
}

// The same ray, the other way: who is seen in the mirror sees in it.
TEST(HandMirror, ShowsThePlayerToAGuardRoundTheCornerAndNothingWithoutIt) {
    LevelKit kit = corner();
    kit.guard({4, 0, -1.6f}, 1.5707963f);  // faces -x, towards the wall's end
    const auto level = kit.finish(true);
    float without = 0.0f, with = 0.0f;
    for (const bool holds : {false, true}) {
        sim::Simulation simulation(level, 1);
        take_it(simulation);
        float& most = holds ? with : without;
        for (int i = 0; i < 400; ++i) {
            // Sweeping the mirror a little, as one does to find somebody in it.
            const float yaw = 0.30f * std::sin(static_cast<float>(i) * 0.02f);
            simulation.step(command(yaw, -0.05f, 0, holds ? kUpAndRight : std::uint16_t{0}));
            const world::Percept& percept = simulation.state().guards[0].percept;
            EXPECT_EQ(percept.sight, 0.0f) << "the wall stands between them";
            most = std::max(most, percept.mirror_sight);
        }
    }
    EXPECT_EQ(without, 0.0f);
    EXPECT_GT(with, 0.0f);
}

// An arm does not reach through a wall: the pane stays on this side however one turns.
TEST(HandMirror, NeverPassesThroughAWall) {
    LevelKit kit = corner();
    kit.spawn({3, 0, 0.45f}, 0);  // before the wall, which is an arm's length off
    kit.level.mirrors[0].pivot = {3, 1.0f, 1.2f};
    sim::Simulation simulation(kit.finish(), 1);
    test::press(simulation, test::look_at(simulation.state(), {3, 1.0f, 1.2f}), Button::Use);
    ASSERT_EQ(simulation.state().player.has_mirror, 1);
    float nearest = 1e9f;
    for (int i = 0; i < 360; ++i) {
        const auto lean = static_cast<std::uint16_t>(i % 90 < 30   ? Button::LeanLeft
                                                     : i % 90 < 60 ? Button::LeanRight
                                                                   : 0);
        simulation.step(
            command(kTwoPi * static_cast<float>(i) / 360.0f, 0, 0, static_cast<std::uint16_t>(kUp | lean)));
        if (!spatial::is_mirror_held(simulation.state().player)) continue;
        nearest = std::min(nearest, simulation.snapshot()->panes[0].centre.z);
    }
    EXPECT_GT(nearest, 0.1f);
}

// A moving pane is part of what a rewind brings back.
TEST(HandMirror, IsRewoundWithTheRest) {
    sim::Simulation simulation(corner().finish(), 1);
    take_it(simulation);
    test::run(simulation, command(0.2f, 0, 0, kUpAndRight), 9);
    const world::State kept = simulation.state();
    simulation.step(command(0.3f, 0, 0, kUpAndRight));
    const std::uint64_t once = world::state_hash(simulation.state()).total;
    const glm::vec3 pane = simulation.snapshot()->panes[0].centre;
    test::run(simulation, command(1.0f), 40);
    simulation.restore(kept);
    simulation.step(command(0.3f, 0, 0, kUpAndRight));
    EXPECT_EQ(world::state_hash(simulation.state()).total, once);
    EXPECT_EQ(simulation.snapshot()->panes[0].centre, pane);
}

}  // namespace
}  // namespace gh
