// Where guards want to go: along their patrol, to what they noticed, from one hiding place to the next, after the
// player.
#include <span>

#include "base/det_math.h"
#include "base/random.h"
#include "sim/geometry.h"
#include "sim/guards.h"
#include "world/eye.h"

namespace gh::sim {

namespace {

using world::Alert;
using world::GuardState;

constexpr float kArrived = 0.35f;               // metres
constexpr float kNewGoal = 0.6f;                // metres a goal moves before the way to it is looked up again
constexpr std::uint16_t kLookAroundTicks = 150;  // at each place of a search
constexpr std::uint32_t kRepathTicks = 20;      // between two looks at the map

bool has_arrived(const GuardState& guard) { return flat_length(guard.target - guard.position) < kArrived; }

void go_to(const GuardWorld& world, const glm::vec3& goal, GuardState& guard) {
    guard.target = world.navigation.nearest(goal).value_or(guard.position);
    const Path path = world.navigation.find_path(guard.position, guard.target, guard.path);
    guard.path_count = static_cast<std::uint16_t>(path.corners);
    guard.path_next = 0;
    if (path.corners > 0 && !path.arrives) guard.target = guard.path[path.corners - 1];
}

void stand_still(GuardState& guard) {
    guard.path_count = 0;
    guard.path_next = 0;
}

bool has_no_way(const GuardState& guard) { return guard.path_next >= guard.path_count; }

void patrol(const GuardWorld& world, std::size_t g, GuardState& guard) {
    const std::vector<world::PatrolPoint>& points = world.level.guards[g].patrol;
    if (points.empty()) return stand_still(guard);
    if (guard.wait_ticks > 0) {
        guard.wait_ticks -= 1;
        if (guard.wait_ticks == 0) guard.patrol_next = static_cast<std::uint16_t>((guard.patrol_next + 1u) % points.size());
        return;
    }
    const world::PatrolPoint& point = points[guard.patrol_next];
    const glm::vec3 goal = world.navigation.nearest(point.position).value_or(guard.position);
    if (flat_length(goal - guard.position) < kArrived) {
        stand_still(guard);
        guard.wait_ticks = static_cast<std::uint16_t>(std::clamp(point.wait_ticks, 1.0f, 60000.0f));
        return;
    }
    if (has_no_way(guard) || flat_length(goal - guard.target) > kNewGoal) go_to(world, goal, guard);
}

// The next place to look into: of a few directions that only the seed knows, the one that leads furthest.
glm::vec3 hiding_place(const GuardWorld& world, const world::State& state, std::size_t g) {
    constexpr std::uint32_t kTries = 4;
    const glm::vec3 from = state.guards[g].position;
    glm::vec3 furthest = from;
    for (std::uint32_t i = 0; i < kTries; ++i) {
        const std::uint32_t bits = hash_u32(state.seed, state.tick, static_cast<std::uint32_t>(g) * kTries + i);
        const glm::vec3 way = world::forward_of_yaw(unit_from_bits(bits) * kTwoPi) * 7.0f;
        const glm::vec3 end = world.navigation.straight(from, from + way);
        if (flat_length(end - from) > flat_length(furthest - from)) furthest = end;
    }
    return furthest;
}

void search(const GuardWorld& world, const world::State& state, std::size_t g, GuardState& guard) {
    const bool has_news = guard.quiet_ticks <= 1 && flat_length(guard.last_known - guard.target) > 1.0f;
    if (has_news || guard.state_ticks <= 1) {
        guard.searched = 0;
        guard.wait_ticks = 0;
        return go_to(world, guard.last_known, guard);
    }
    if (guard.wait_ticks > 0) {
        guard.wait_ticks -= 1;
        if (guard.wait_ticks > 0) return;
        guard.searched += 1;
        return go_to(world, hiding_place(world, state, g), guard);
    }
    if (has_arrived(guard) || has_no_way(guard)) {
        stand_still(guard);
        guard.wait_ticks = kLookAroundTicks;
    }
}

void chase(const GuardWorld& world, const world::State& state, std::size_t g, GuardState& guard) {
    if (flat_length(guard.last_known - guard.target) < kNewGoal && !has_no_way(guard)) return;
    const bool is_due = state.tick % kRepathTicks == g % kRepathTicks || has_no_way(guard);
    if (is_due) go_to(world, guard.last_known, guard);
}

}  // namespace

void decide_guards(const GuardWorld& before, world::State& state) {
    for (std::size_t g = 0; g < before.level.guards.size(); ++g) {
        GuardState& guard = state.guards[g];
        if (state.rules.outcome == world::Outcome::Caught) {
            stand_still(guard);
            continue;
        }
        switch (guard.alert) {
            case Alert::Calm: patrol(before, g, guard); break;
            case Alert::Suspicious: stand_still(guard); break;
            case Alert::Searching: search(before, state, g, guard); break;
            case Alert::Chasing: chase(before, state, g, guard); break;
        }
    }
}

}  // namespace gh::sim
