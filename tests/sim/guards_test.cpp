#include "sim/guards.h"

#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "sim/level_kit.h"
#include "sim/player.h"
#include "sim/rules.h"
#include "sim/sim_kit.h"
#include "sim/stones.h"

namespace gh::sim {
namespace {

using input::Button;
using test::command;
using test::LevelKit;
using world::Alert;

constexpr float kSouth = 3.1415927f;

float flat_distance(const glm::vec3& a, const glm::vec3& b) { return std::hypot(a.x - b.x, a.z - b.z); }

const world::GuardState& guard_of(const Simulation& simulation) { return simulation.state().guards[0]; }

bool has_barked(const Simulation& simulation, world::Bark bark) {
    for (std::uint32_t n = 0; n < simulation.state().noise_count; ++n) {
        if (simulation.state().noises[n].bark == bark) return true;
    }
    return false;
}

// Steps until the first guard barks; false after `limit` ticks.
bool wait_for_bark(Simulation& simulation, const input::Command& with, world::Bark bark, int limit) {
    for (int i = 0; i < limit; ++i) {
        simulation.step(with);
        if (has_barked(simulation, bark)) return true;
    }
    return false;
}

// Two rooms, a door between them, dark where the player is; the guard's round goes through the door.
LevelKit two_rooms_with_a_round() {
    LevelKit kit;
    kit.room({-6, 0, -6}, {6, 3, 6})
        .box({-6, 0, -0.05f}, {-0.6f, 3, 0.05f})
        .box({0.6f, 0, -0.05f}, {6, 3, 0.05f})
        .door({-0.58f, 0.01f, 0}, 1.16f, 2.1f, -1.6f)
        .spawn({5, 0, -5}, 0)
        .guard({-3, 0, -3}, 0, {{"a", {-4, 0, 4}, 0, 20, false}, {"b", {4, 0, 4}, 0, 20, true}, {"c", {-4, 0, -4}, 0, 20, false}});
    return kit;
}

TEST(Guards, APatrolReachesAllItsPointsThroughAClosedDoorAndShutsItBehind) {
    Simulation simulation(two_rooms_with_a_round().finish(true), 1);
    const std::vector<world::PatrolPoint>& patrol = simulation.level().guards[0].patrol;
    std::set<std::size_t> reached;
    float widest = 0.0f;
    bool looked_round = false, was_inside_the_door = false;
    for (int i = 0; i < 3600; ++i) {
        simulation.step(command(0));
        for (std::size_t p = 0; p < patrol.size(); ++p) {
            if (flat_distance(guard_of(simulation).position, patrol[p].position) < 0.5f) reached.insert(p);
        }
        widest = std::max(widest, openness(simulation.level(), simulation.state(), 0));
        looked_round |= guard_of(simulation).clip == world::ClipId::Look;
        const bool is_shut = simulation.state().doors[0].angle == 0.0f;
        was_inside_the_door |= is_shut && std::abs(guard_of(simulation).position.z) < 0.3f;
    }
    EXPECT_EQ(reached.size(), 3u);
    EXPECT_TRUE(looked_round);
    EXPECT_FLOAT_EQ(widest, 1.0f);
    EXPECT_FALSE(was_inside_the_door);
    EXPECT_EQ(guard_of(simulation).alert, Alert::Calm);
    int shut = 0;
    for (int i = 0; i < 1200; ++i) {
        simulation.step(command(0));
        shut += simulation.state().doors[0].angle == 0.0f;
    }
    EXPECT_GT(shut, 200) << "closed again behind the guard";
}

TEST(Guards, FeetDoNotSlide) {
    Simulation simulation(two_rooms_with_a_round().finish(true), 1);
    for (int i = 0; i < 600; ++i) {
        const glm::vec3 from = guard_of(simulation).position;
        const float time = guard_of(simulation).clip_time;
        simulation.step(command(0));
        const world::GuardState& guard = guard_of(simulation);
        if (guard.clip != world::ClipId::Walk || guard.clip_time < time) continue;
        EXPECT_NEAR((guard.clip_time - time) * kGuardWalkSpeed, flat_distance(guard.position, from), 1e-4f);
    }
}

// One bright room with a guard who faces the player across it.
LevelKit bright_room(float guard_z, float guard_yaw) {
    LevelKit kit;
    kit.room({-6, 0, -12}, {6, 4, 12}).lamp({0, 3.5f, 0}, 30, "hall").spawn({0, 0, 8}, 0).guard({0, 0, guard_z}, guard_yaw);
    return kit;
}

TEST(Guards, SeeAPlayerInPlainViewChaseAndCatchHimButNotWithinTheBlinkOfAnEye) {
    Simulation simulation(bright_room(2, kSouth).finish(true), 1);
    const int noticed = test::run_until(simulation, [](const world::State&) { return command(0); },
                                        [](const world::State& s) { return s.guards[0].alert == Alert::Chasing; }, 600);
    ASSERT_GE(noticed, kReactionTicks) << "at least 0.4 s";
    EXPECT_LT(noticed, 180) << "yet no longer than three seconds at 6 m in full light";
    EXPECT_EQ(guard_of(simulation).raised_by, world::Cue::Seen);
    EXPECT_TRUE(has_barked(simulation, world::Bark::Alarm));

    const int caught = test::run_until(simulation, [](const world::State&) { return command(0); },
                                       [](const world::State& s) { return s.rules.outcome == world::Outcome::Caught; }, 600);
    ASSERT_GE(caught, 0);
    EXPECT_LE(flat_distance(guard_of(simulation).position, simulation.state().player.position), kCatchReach);
    EXPECT_TRUE(has_barked(simulation, world::Bark::Caught));
    EXPECT_EQ(simulation.state().rules.times_caught, 1u);
}

TEST(Guards, WhoIsCaughtStandsUntilHeAsksForTheCheckpoint) {
    Simulation simulation(bright_room(7, kSouth).finish(true), 1);
    ASSERT_GE(test::run_until(simulation, [](const world::State&) { return command(0); },
                              [](const world::State& s) { return s.rules.outcome == world::Outcome::Caught; }, 600), 0);
    const glm::vec3 where = simulation.state().player.position;
    test::run(simulation, command(0, 0, 1), 90);
    EXPECT_LT(flat_distance(simulation.state().player.position, where), 0.3f);
    EXPECT_EQ(simulation.state().rules.outcome, world::Outcome::Caught);
    const std::uint32_t tick = simulation.state().tick;
    test::press(simulation, command(0), Button::Use);
    EXPECT_EQ(simulation.state().rules.outcome, world::Outcome::Playing);
    EXPECT_EQ(simulation.state().tick, tick + 2) << "time runs on";
    EXPECT_EQ(simulation.state().rules.times_caught, 1u);
    EXPECT_NEAR(simulation.state().guards[0].position.z, 7.0f, 0.2f) << "everybody is back where he was";
}

TEST(Guards, DoNotSeeBehindTheirBacksNorInTheDark) {
    Simulation behind(bright_room(2, 0).finish(true), 1);
    test::run(behind, command(0), 300);
    EXPECT_EQ(guard_of(behind).alert, Alert::Calm);

    LevelKit dark = bright_room(2, kSouth);
    dark.level.lamps[0].starts_on = false;
    Simulation in_the_dark(dark.finish(true), 1);
    test::run(in_the_dark, command(0), 300);
    EXPECT_EQ(guard_of(in_the_dark).alert, Alert::Calm);
    EXPECT_LT(in_the_dark.state().player.exposure, 0.01f);
}

TEST(Guards, AStoneDrawsThemToWhereItFellAndTheyGiveUpInTheEnd) {
    LevelKit kit = bright_room(-9, 0);
    kit.level.lamps[0].starts_on = false;
    Simulation simulation(kit.finish(true), 1);
    test::run(simulation, command(0.4f, 0.1f, 0, Button::Throw), 30);
    ASSERT_TRUE(wait_for_bark(simulation, command(0.4f, 0.1f), world::Bark::WhoIsThere, 120));
    EXPECT_EQ(guard_of(simulation).raised_by, world::Cue::Heard);
    const auto stands_where_it_sounded = [](const world::State& s) {
        return s.guards[0].wait_ticks > 0 && flat_distance(s.guards[0].position, s.stones[0].position) < 2.5f;
    };
    EXPECT_GE(test::run_until(simulation, [](const world::State&) { return command(0); }, stands_where_it_sounded, 1200), 0)
        << "the guard goes to where the stone was last heard";
    EXPECT_NE(guard_of(simulation).alert, Alert::Chasing) << "a noise alone starts no chase";
    EXPECT_TRUE(wait_for_bark(simulation, command(0), world::Bark::GaveUp, 3600));
    EXPECT_EQ(guard_of(simulation).alert, Alert::Calm);
}

// In the dark, from behind: who is hit searches at once, turns to where the stone came from, and says why.
TEST(Guards, AStoneThatHitsOneBouncesOffAndIsNoticedAtOnce) {
    LevelKit kit = bright_room(0, 0);  // looks away from the player, 8 m off
    kit.level.lamps[0].starts_on = false;
    Simulation simulation(kit.finish(true), 1);
    test::run(simulation, command(0, 0.12f, 0, Button::Throw), 60);
    ASSERT_EQ(guard_of(simulation).alert, Alert::Calm);
    const float start = guard_of(simulation).position.z;
    float furthest = 9.0f;
    int struck_at = -1;
    for (int i = 0; i < 90; ++i) {
        simulation.step(command(0, 0.12f));
        furthest = std::min(furthest, simulation.state().stones[0].position.z);
        if (struck_at >= 0 || guard_of(simulation).percept.is_struck == 0) continue;
        struck_at = i;
        EXPECT_EQ(guard_of(simulation).alert, Alert::Searching) << "in the very tick";
        EXPECT_EQ(guard_of(simulation).raised_by, world::Cue::Struck);
        EXPECT_TRUE(has_barked(simulation, world::Bark::WhoIsThere));
        EXPECT_GT(guard_of(simulation).last_known.z, start + 3.0f) << "it came from the player's side";
    }
    ASSERT_GE(struck_at, 0) << "the throw was well aimed";
    EXPECT_GT(furthest, 0.3f) << "the stone did not pass through him";
    EXPECT_NE(guard_of(simulation).alert, Alert::Chasing) << "a blow says where from, not who";
}

// The arc shown is the arc flown, also when somebody stands in it.
TEST(Guards, TheAimedArcEndsAtTheGuardItWouldHit) {
    LevelKit kit = bright_room(0, 0);
    Simulation simulation(kit.finish(true), 1);
    test::run(simulation, command(0, 0.12f, 0, Button::Throw), 60);
    std::array<glm::vec3, kMaxArcPoints> arc{};
    const std::size_t count = throw_arc(simulation.level(), *simulation.snapshot(), arc);
    ASSERT_GT(count, 2u);
    EXPECT_NEAR(arc[count - 1].z, guard_of(simulation).position.z + kGuardRadius, 0.08f);
}

TEST(Guards, SneakingPassesWhereRunningIsHeard) {
    for (const bool runs : {false, true}) {
        LevelKit kit = bright_room(-4, 0);
        kit.level.lamps[0].starts_on = false;
        kit.spawn({-5, 0, -1}, -1.5707964f);
        Simulation simulation(kit.finish(true), 1);
        test::run(simulation, command(-1.5707964f, 0, 1, runs ? Button::Run : Button::Crouch), runs ? 120 : 480);
        EXPECT_EQ(guard_of(simulation).alert != Alert::Calm, runs);
    }
}

// The player stands behind a screen that hides him; a mirror on the far wall shows him to the guard.
TEST(Guards, AMirrorShowsThePlayerRoundACornerAndRaisesNoMoreThanASearch) {
    for (const bool has_mirror : {false, true}) {
        LevelKit kit;
        kit.room({-6, 0, -6}, {6, 4, 6}).box({-0.1f, 0, -6}, {0.1f, 4, 3}).lamp({3, 3.5f, 0}, 30);
        kit.spawn({2.5f, 0, 0}, 0).guard({-2.5f, 0, 0}, kSouth);
        if (has_mirror) kit.mirror({0, 1.5f, 5.9f}, 3.0f, 1.4f, kSouth, 0.0f);
        Simulation simulation(kit.finish(true), 1);
        Alert highest = Alert::Calm;
        world::Cue cue = world::Cue::None;
        for (int i = 0; i < 300; ++i) {
            simulation.step(command(0));
            if (guard_of(simulation).percept.sight > 0.0f) break;  // came round the corner: another matter
            if (guard_of(simulation).alert > highest) cue = guard_of(simulation).raised_by;
            highest = std::max(highest, guard_of(simulation).alert);
        }
        EXPECT_EQ(highest, has_mirror ? Alert::Searching : Alert::Calm);
        EXPECT_EQ(cue, has_mirror ? world::Cue::Mirrored : world::Cue::None);
    }
}

TEST(Guards, LoseThePlayerBehindADoorAndSearchForHim) {
    LevelKit kit = bright_room(2, kSouth);
    kit.box({1.5f, 0, 9}, {6, 4, 9.1f}).box({1.5f, 0, 9}, {1.6f, 4, 12});
    Simulation simulation(kit.finish(true), 1);
    ASSERT_TRUE(wait_for_bark(simulation, command(0), world::Bark::Alarm, 300));
    world::State hidden = simulation.state();
    hidden.player.position = {4, 0, 10.5f};  // gone, as far as the guard can tell
    simulation.restore(hidden);
    EXPECT_TRUE(wait_for_bark(simulation, command(0), world::Bark::WhoIsThere, 400));
    EXPECT_EQ(guard_of(simulation).alert, Alert::Searching);
}

TEST(Guards, AnAlarmCallsTheOthers) {
    LevelKit kit = bright_room(2, kSouth);
    kit.guard({0, 0, -10}, 0);
    Simulation simulation(kit.finish(true), 1);
    ASSERT_TRUE(wait_for_bark(simulation, command(0), world::Bark::Alarm, 300));
    simulation.step(command(0));
    simulation.step(command(0));
    EXPECT_EQ(simulation.state().guards[1].alert, Alert::Searching);
}

TEST(Guards, DoNotWalkThroughThePlayer) {
    LevelKit kit;
    kit.room({-1, 0, -8}, {1, 3, 8}).spawn({0, 0, 0}, 0);
    kit.guard({0, 0, -6}, kSouth, {{"a", {0, 0, 6}, 0, 10, false}, {"b", {0, 0, -6}, 0, 10, false}});
    Simulation simulation(kit.finish(true), 1);
    for (int i = 0; i < 900; ++i) {
        simulation.step(command(0));
        ASSERT_GT(flat_distance(guard_of(simulation).position, simulation.state().player.position), 0.55f) << i;
    }
}

TEST(Guards, StandWhereTheyAreInALevelWithoutANavmesh) {
    LevelKit kit = bright_room(2, 0);
    kit.level.guards[0].patrol = {{"a", {0, 0, -6}, 0, 10, false}};
    Simulation simulation(kit.finish(false), 1);
    test::run(simulation, command(0), 120);
    EXPECT_EQ(guard_of(simulation).position, glm::vec3(0, 0, 2));
}

}  // namespace
}  // namespace gh::sim
