#include "sim/simulation.h"

#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "base/jobs.h"
#include "base/random.h"
#include "sim/level_kit.h"
#include "sim/sim_kit.h"
#include "sim/stones.h"
#include "world/state_hash.h"

namespace gh::sim {
namespace {

using input::Button;
using test::LevelKit;

constexpr float kSouth = 3.1415927f;

// A little of everything: a door, a mirror, lamps, a switch, two guards on patrol, stones.
std::shared_ptr<const world::Level> busy_level() {
    LevelKit kit;
    kit.room({-8, 0, -8}, {8, 3.5f, 8})
        .box({-8, 0, 1.95f}, {-0.52f, 3, 2.05f})
        .box({0.52f, 0, 1.95f}, {8, 3, 2.05f})
        .door({-0.5f, 0.01f, 2}, 1.0f, 2.0f, -1.6f)
        .mirror({3, 1.5f, -7.5f}, 1.0f, 1.0f, 0.0f, 0.3f)
        .lamp({0, 3, -3}, 4, "front")
        .lamp({0, 3, 5}, 3)
        .light_switch({2, 1.3f, 1.94f}, "front")
        .lens({6, 0.9f, 6})
        .box({5.6f, 0, 5.6f}, {6.4f, 0.8f, 6.4f})
        .spawn({0, 0, -6}, kSouth)
        .guard({-5, 0, 5}, 0.0f, {{"a", {-5, 0, 5}, 0, 30, true}, {"b", {5, 0, -5}, 1, 60, false}})
        .guard({5, 0, -5}, 0.0f, {{"c", {5, 0, -3}, 0, 20, false}, {"d", {-5, 0, -5}, 1, 20, true}});
    return kit.finish(true);
}

// Keys pressed by somebody in a hurry; a function of the tick, so that any run can be done again.
input::Command hurried(std::uint32_t tick) {
    Random random(tick / 10);
    const std::uint32_t keys = random.next_u32();
    auto buttons = static_cast<std::uint16_t>(keys & (Button::Run | Button::Use | Button::LeanLeft | Button::Throw));
    if ((keys & 0xF000) == 0) buttons |= Button::Jump;
    if ((keys & 0x70000) == 0) buttons |= Button::Crouch;
    return test::command(random.in_range(-3.1f, 3.1f), random.in_range(-0.5f, 0.5f), random.in_range(-0.3f, 1), buttons);
}

bool same_bytes(const world::State& a, const world::State& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST(Simulation, StepsRewindsAndStepsAgainToTheSameBytesInEveryTick) {
    Simulation simulation(busy_level(), 7);
    for (std::uint32_t tick = 0; tick < 600; ++tick) {
        const world::State before = simulation.state();
        simulation.step(hurried(tick));
        const world::State first = simulation.state();
        simulation.restore(before);
        simulation.step(hurried(tick));
        ASSERT_TRUE(same_bytes(first, simulation.state())) << "tick " << tick;
    }
}

std::vector<std::uint64_t> hash_chain(Simulation& simulation, std::uint32_t from, std::uint32_t ticks) {
    std::vector<std::uint64_t> chain;
    for (std::uint32_t i = 0; i < ticks; ++i) {
        simulation.step(hurried(from + i));
        chain.push_back(world::state_hash(simulation.state()).total);
    }
    return chain;
}

TEST(Simulation, RestoredFarBackTakesTheSameWayAgain) {
    Simulation simulation(busy_level(), 7);
    hash_chain(simulation, 0, 200);
    const world::State middle = simulation.state();
    const auto first = hash_chain(simulation, 200, 300);
    simulation.restore(middle);
    EXPECT_EQ(hash_chain(simulation, 200, 300), first);
    Simulation other(busy_level(), 7);
    other.restore(middle);
    EXPECT_EQ(hash_chain(other, 200, 300), first) << "nothing outlives a State";
}

TEST(Simulation, ThreadsChangeNothing) {
    std::vector<std::uint64_t> expected;
    for (const int threads : {1, 2, 8}) {
        const Jobs jobs(threads);
        Simulation simulation(busy_level(), 7, &jobs);
        const auto chain = hash_chain(simulation, 0, 240);
        if (expected.empty()) expected = chain;
        EXPECT_EQ(chain, expected) << threads << " threads";
    }
    Simulation without_jobs(busy_level(), 7);
    EXPECT_EQ(hash_chain(without_jobs, 0, 240), expected);
}

TEST(Simulation, TheSnapshotIsOfTheStateItIsHandedOutWith) {
    Simulation simulation(busy_level(), 7);
    for (std::uint32_t tick = 0; tick < 50; ++tick) {
        const auto earlier = simulation.snapshot();
        const world::State then = earlier->state;
        simulation.step(hurried(tick));
        EXPECT_TRUE(same_bytes(simulation.snapshot()->state, simulation.state()));
        EXPECT_TRUE(same_bytes(earlier->state, then)) << "a Snapshot somebody holds is never written";
    }
}

class Recorder final : public PhaseObserver {
  public:
    void begin(Phase phase) override { phases.push_back(phase); }
    void end() override { ++ticks; }
    std::vector<Phase> phases;
    int ticks = 0;
};

TEST(Simulation, TellsAnObserverEachPhaseInOrderAndIsNotChangedByIt) {
    Simulation watched(busy_level(), 7), alone(busy_level(), 7);
    Recorder recorder;
    watched.step(hurried(0), &recorder);
    alone.step(hurried(0));
    EXPECT_EQ(recorder.phases, (std::vector{Phase::Decide, Phase::Doors, Phase::Motion, Phase::Stones, Phase::Noise,
                                            Phase::Commit, Phase::Perceive, Phase::Judge}));
    EXPECT_EQ(recorder.ticks, 1);
    EXPECT_TRUE(same_bytes(watched.state(), alone.state()));
}

TEST(Stones, TheArcShownIsTheArcFlown) {
    LevelKit kit;
    kit.room({-8, 0, -8}, {8, 5, 8}).spawn({0, 0, 5}, 0);
    Simulation simulation(kit.finish(), 1);
    test::run(simulation, test::command(0, 0.3f, 0, Button::Throw), 40);
    std::array<glm::vec3, kMaxArcPoints> arc;
    const std::size_t count = throw_arc(simulation.level(), *simulation.snapshot(), arc);
    ASSERT_GT(count, 20u);
    simulation.step(test::command(0, 0.3f));
    ASSERT_EQ(simulation.state().stones[0].is_present, 1);
    for (std::size_t i = 1; i + 1 < count; ++i) {
        EXPECT_EQ(simulation.state().stones[0].position, arc[i]) << "tick " << i << " of " << count;
        simulation.step(test::command(0, 0.3f));
    }
    ASSERT_EQ(simulation.state().noise_count, 1u) << "where the arc ends the stone is heard";
    EXPECT_EQ(simulation.state().noises[0].position, arc[count - 1]);
}

TEST(Stones, AreEightCanBePutBackAndPickedUpAgain) {
    LevelKit kit;
    kit.room({-8, 0, -8}, {8, 5, 8}).spawn({0, 0, 5}, 0);
    Simulation simulation(kit.finish(), 1);
    test::run(simulation, test::command(0, 0, 0, Button::Throw), 5);
    test::run(simulation, test::command(0, 0, 0, Button::Throw | Button::Cancel), 2);
    test::run(simulation, test::command(0, 0, 0, Button::Throw), 5);
    test::run(simulation, test::command(0), 2);
    EXPECT_EQ(simulation.state().player.stones_left, 8) << "cancelled: still in hand until the key is pressed anew";
    for (int i = 0; i < 12; ++i) {
        test::run(simulation, test::command(0, -1.2f, 0, Button::Throw), 2);
        test::run(simulation, test::command(0, -1.2f), 2);
    }
    EXPECT_EQ(simulation.state().player.stones_left, 0);
    test::run(simulation, test::command(0, -1.2f), 900);
    for (int i = 0; i < 8; ++i) {
        const world::State& state = simulation.state();
        ASSERT_EQ(state.stones[static_cast<std::size_t>(i)].is_resting, 1) << i;
    }
    const glm::vec3 stone = simulation.state().stones[0].position;
    const int walked = test::run_until(
        simulation, [&](const world::State& s) { return test::look_at(s, stone, 1.0f); },
        [&](const world::State& s) {
            const glm::vec3 way = stone - s.player.position;
            return way.x * way.x + way.z * way.z < 0.3f;
        }, 600);
    ASSERT_GE(walked, 0);
    test::run(simulation, test::look_at(simulation.state(), stone), 20);
    test::press(simulation, test::look_at(simulation.state(), stone), Button::Use);
    EXPECT_EQ(simulation.state().player.stones_left, 1);
}

}  // namespace
}  // namespace gh::sim
