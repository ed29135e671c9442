#include "sim/rules.h"

#include "sim/player.h"
#include "world/initial_state.h"

namespace gh::sim {

namespace {

constexpr float kDeepest = 20.0f;  // metres below the level's bounds: nobody walks there

bool is_inside(const world::Aabb& box, const glm::vec3& p) {
    return box.min.x <= p.x && p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y && box.min.z <= p.z &&
           p.z <= box.max.z;
}

bool is_at_an_exit(const world::Level& level, const world::PlayerState& player) {
    const glm::vec3 hips = player.position + glm::vec3(0.0f, 0.5f * player.height, 0.0f);
    for (const world::Aabb& exit : level.exits) {
        if (is_inside(exit, player.position) || is_inside(exit, hips)) return true;
    }
    return false;
}

}  // namespace

bool wants_checkpoint(const world::State& state, const input::Command& command) {
    const world::RulesState& rules = state.rules;
    if (rules.outcome == world::Outcome::Won) return false;
    if (is_pressed(state.player, command, input::Button::Restart)) return true;
    const bool has_waited = state.tick >= rules.outcome_tick + kCaughtTicks;
    return rules.outcome == world::Outcome::Caught && has_waited &&
           is_pressed(state.player, command, input::Button::Use);
}

world::State checkpoint(const world::Level& level, const world::State& state) {
    world::State start = world::initial_state(level, state.seed);
    start.tick = state.tick;
    start.rules.times_caught = state.rules.times_caught;
    start.player.buttons_before = state.player.buttons_before;
    return start;
}

input::Command allowed(const world::State& state, const input::Command& command) {
    if (state.rules.outcome == world::Outcome::Playing) return command;
    return {.yaw = command.yaw, .pitch = command.pitch};
}

void catch_player(world::State& state) {
    if (state.rules.outcome != world::Outcome::Playing) return;
    state.rules.outcome = world::Outcome::Caught;
    state.rules.outcome_tick = state.tick;
    state.rules.times_caught += 1;
}

void judge_rules(const world::Level& level, world::State& state) {
    world::PlayerState& player = state.player;
    if (player.position.y < level.bounds.min.y - kDeepest) {
        player.position = level.spawn.position;
        player.velocity = glm::vec3(0.0f);
    }
    const bool has_all = !level.lenses.empty() && state.rules.lenses_taken_count == level.lenses.size();
    if (state.rules.outcome == world::Outcome::Playing && has_all && is_at_an_exit(level, player)) {
        state.rules.outcome = world::Outcome::Won;
        state.rules.outcome_tick = state.tick;
    }
}

}  // namespace gh::sim
