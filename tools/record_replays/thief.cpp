#include "thief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/det_math.h"
#include "hands.h"
#include "raycore/query.h"
#include "sim/doors.h"
#include "sim/geometry.h"
#include "sim/use_target.h"
#include "spatial/transforms.h"
#include "world/eye.h"
#include "world/layers.h"

namespace gh::tools {

namespace {

using input::Button;
using input::Command;
using sim::flat;
using sim::flat_length;

constexpr float kThere = 0.16f;      // metres from a place to stand
constexpr float kArmsLength = 1.35f;   // metres from the eye at which a thing is comfortably reached
constexpr float kFarthestShelter = 12.0f;  // metres
constexpr float kErrandDetour = 14.0f;  // metres a thief goes out of the way to put out a lamp

// Whether a guard is near enough to hear a step.
bool is_in_earshot(const world::Level& level, const world::State& state) {
    constexpr float kEarshot = 12.0f;  // metres
    for (std::size_t g = 0; g < level.guards.size(); ++g) {
        if (sim::length_of(state.guards[g].position - state.player.position) < kEarshot) return true;
    }
    return false;
}

template <class Things, class Place>
std::uint32_t nearest_index(const sim::Navigation& navigation, const Things& things, const glm::vec3& to,
                            const Place& place_of) {
    std::uint32_t nearest = world::kNoIndex;
    float best = kErrandDetour;
    for (std::uint32_t i = 0; i < things.size(); ++i) {
        const std::optional<glm::vec3> place = place_of(things[i]);
        if (!place) continue;
        const float metres = navigation.distance(*place, to).value_or(best);
        if (metres < best) {
            best = metres;
            nearest = i;
        }
    }
    return nearest;
}

// Where a guard's eyes are on his round, every two metres.
void add_round(const sim::Navigation& navigation, const world::Guard& guard, std::vector<glm::vec3>& eyes) {
    glm::vec3 at = guard.patrol.empty() ? guard.position : guard.patrol.back().position;
    for (const world::PatrolPoint& point : guard.patrol) {
        std::array<glm::vec3, world::kMaxPathCorners> corners;
        const sim::Path path = navigation.find_path(at, point.position, corners);
        for (std::size_t i = 0; i < path.corners; ++i) {
            const glm::vec3 leg = corners[i] - at;
            const int steps = 1 + static_cast<int>(sim::length_of(leg) / 2.0f);
            for (int s = 1; s <= steps; ++s) {
                const float share = static_cast<float>(s) / static_cast<float>(steps);
                eyes.push_back(at + leg * share + glm::vec3(0.0f, 1.65f, 0.0f));
            }
            at = corners[i];
        }
    }
}

}  // namespace

Thief::Thief(const world::Level& level, const sim::Navigation& navigation) : level_(level), navigation_(navigation) {
    const glm::vec3 low = level.bounds.min, size = level.bounds.max - low;
    for (int row = 0; static_cast<float>(row) <= size.z; ++row) {
        for (int column = 0; static_cast<float>(column) <= size.x; ++column) {
            const float x = low.x + static_cast<float>(column), z = low.z + static_cast<float>(row);
            const std::optional<glm::vec3> place = navigation.nearest({x, level.spawn.position.y + 0.5f, z});
            if (place && flat_length(*place - glm::vec3(x, 0.0f, z)) < 0.5f) shelters_.push_back(*place);
        }
    }
    for (const world::Guard& guard : level.guards) add_round(navigation, guard, rounds_);
    if (level.lenses.empty()) return;
    const glm::vec3 lens = level.lenses.front().centre;
    switch_ = nearest_index(navigation, level.switches, lens,
                            [](const world::Switch& it) { return std::optional(it.position); });
    mirror_ = nearest_index(navigation, level.mirrors, lens, [](const world::Mirror& it) {
        return it.turn_step != 0.0f ? std::optional(it.pivot) : std::nullopt;
    });
}

Thief::Goal Thief::reach_for(const world::Snapshot& now, const glm::vec3& thing, std::uint32_t side) const {
    // Places all round the thing, on the floor one can get to; `side` picks among them, the nearest first.
    struct Stand {
        glm::vec3 place;
        float metres;
    };
    std::array<Stand, 12> stands;
    std::size_t count = 0;
    const glm::vec3 feet = now.state.player.position;
    for (std::size_t i = 0; i < stands.size(); ++i) {
        const float yaw = kTwoPi * static_cast<float>(i) / static_cast<float>(stands.size());
        const glm::vec3 wanted = thing + world::forward_of_yaw(yaw) * 0.75f;
        const std::optional<glm::vec3> place = navigation_.nearest({wanted.x, thing.y - 1.0f, wanted.z});
        if (!place || flat_length(*place - thing) > 1.1f || !is_seen_from(now, *place, thing)) continue;
        const std::optional<float> metres = navigation_.distance(feet, *place);
        if (metres) stands[count++] = {*place, *metres};
    }
    if (count == 0) return {.place = navigation_.nearest(thing).value_or(feet), .thing = thing, .is_thing = true};
    std::stable_sort(stands.begin(), stands.begin() + static_cast<std::ptrdiff_t>(count),
                     [](const Stand& a, const Stand& b) { return a.metres < b.metres; });
    return {.place = stands[side % count].place, .thing = thing, .is_thing = true};
}

Thief::Goal Thief::goal_of(const world::Snapshot& now, const Manner& manner) const {
    const world::State& state = now.state;
    for (std::uint32_t i = 0; i < level_.lenses.size(); ++i) {
        if (state.lens_taken[i] != 0) continue;
        if (manner.turns_mirror && mirror_ != world::kNoIndex && state.mirrors[mirror_].target == 0.0f) {
            return reach_for(now, level_.mirrors[mirror_].pivot + glm::vec3(0.0f, 0.6f, 0.0f), manner.side);
        }
        if (manner.puts_out_lamps && switch_ != world::kNoIndex &&
            state.group_on[level_.switches[switch_].group] != 0) {
            return reach_for(now, level_.switches[switch_].position, manner.side);
        }
        return reach_for(now, level_.lenses[i].centre, manner.side);
    }
    if (level_.exits.empty()) return {.place = state.player.position};
    const world::Aabb& exit = level_.exits.front();
    const glm::vec3 middle = (exit.min + exit.max) * 0.5f;
    return {.place = navigation_.nearest({middle.x, exit.min.y, middle.z}).value_or(middle)};
}

Command Thief::open_door(const world::Snapshot& now, std::uint32_t door) const {
    const world::PlayerState& player = now.state.player;
    const world::DoorState& it = now.state.doors[door];
    const glm::vec3 handle = level_.doors[door].handle;
    Command command = turned_towards(player, handle - world::eye_of(player));
    if (it.wants_open == 0 && it.angle != 0.0f) return command;  // it is closing: opened again, it would bar the way for ever
    if (it.wants_open == 0) {
        const sim::UseTarget target = sim::use_target(level_, now, player);
        if (target.kind == sim::UseKind::Door && target.index == door) {
            press(player, Button::Use, command);
        } else if (looks_at(player, handle)) {
            command.move_forward = 50;
        }
        return command;
    }
    // It swings; make room in case it swings this way: a leaf is wider than an arm is long.
    if (flat_length(handle - player.position) < 1.95f) command.move_forward = -90;
    return command;
}

bool Thief::is_overlooked(const world::Snapshot& now, const glm::vec3& place) const {
    constexpr std::array<glm::vec3, 5> kBody = {glm::vec3(0.0f, 0.6f, 0.0f), glm::vec3(0.35f, 1.05f, 0.0f),
                                                glm::vec3(-0.35f, 1.05f, 0.0f), glm::vec3(0.0f, 0.3f, 0.35f),
                                                glm::vec3(0.0f, 0.3f, -0.35f)};
    for (const glm::vec3& point : kBody) {
        for (const glm::vec3& eye : rounds_) {
            const rc::Ray ray{.origin = eye, .direction = place + point - eye, .t_max = 1.0f};
            const bool is_far = sim::length_of(ray.direction) > 25.0f;
            if (!is_far && !rc::any_hit(*now.scene, ray, world::Sight)) return true;
        }
    }
    return false;
}

bool Thief::is_behind_a_leaf(const world::Snapshot& now, const glm::vec3& place, const glm::vec3& goal) const {
    std::array<glm::vec3, world::kMaxPathCorners> corners;
    const sim::Path path = navigation_.find_path(place, goal, corners);
    glm::vec3 at = place + glm::vec3(0.0f, 1.0f, 0.0f);
    for (std::size_t i = 0; i < std::min<std::size_t>(path.corners, 2); ++i) {
        const glm::vec3 next = corners[i] + glm::vec3(0.0f, 1.0f, 0.0f);
        const auto hit = rc::sphere_cast(*now.scene, at, 0.25f, next - at, world::Solid);
        if (hit && level_.parts[hit->instance].mover == world::Mover::Door) return true;
        at = next;
    }
    return false;
}

Command Thief::hide(const world::Snapshot& now, const glm::vec3& goal) const {
    const world::PlayerState& player = now.state.player;
    glm::vec3 shelter = player.position;
    float best = kFarthestShelter;
    for (const glm::vec3& place : shelters_) {
        if (sim::length_of(place - player.position) >= best || is_overlooked(now, place)) continue;
        const float metres = navigation_.distance(player.position, place).value_or(best);
        if (metres >= best || is_behind_a_leaf(now, place, goal)) continue;
        best = metres;
        shelter = place;
    }
    if (flat_length(shelter - player.position) > 2.0f * kThere) return go(now, shelter);
    return {.yaw = player.yaw, .pitch = player.pitch, .buttons = Button::Crouch};
}

Command Thief::go(const world::Snapshot& now, const glm::vec3& place) const {
    const world::PlayerState& player = now.state.player;
    std::array<glm::vec3, world::kMaxPathCorners> corners;
    const sim::Path path = navigation_.find_path(player.position, place, corners);
    std::size_t next = 0;
    while (next + 1 < path.corners && flat_length(corners[next] - player.position) < 0.2f) ++next;
    const glm::vec3 way = flat((path.corners > 0 ? corners[next] : place) - player.position);

    // A closed door ahead is opened, whatever else is on.
    const glm::vec3 chest = player.position + glm::vec3(0.0f, 1.0f, 0.0f);
    const glm::vec3 ahead = sim::unit_or_zero(way) * 1.4f;
    if (ahead != glm::vec3(0.0f)) {
        const auto hit = rc::sphere_cast(*now.scene, chest, 0.2f, ahead, world::Solid);
        if (hit && level_.parts[hit->instance].mover == world::Mover::Door) {
            const std::uint32_t door = level_.parts[hit->instance].mover_index;
            if (sim::openness(level_, now.state, door) < 0.95f) return open_door(now, door);
            // A leaf that stands open in the way is walked round, by its free end.
            const glm::vec3 hinge = level_.doors[door].hinge;
            const glm::vec3 along = flat(spatial::door_handle(level_, now.state, door) - hinge);
            const glm::vec3 past_end = hinge + along * (1.0f + 0.75f / flat_length(along)) - player.position;
            const bool is_held_up = flat_length(player.velocity) < 0.6f && hit->t * 1.4f < 0.6f;
            if (is_held_up && flat_length(past_end) > 0.5f) {
                Command command = turned_towards(player, flat(past_end));
                if (alignment(player, past_end) > 0.5f) command.move_forward = 110;
                return command;
            }
        }
    }
    const glm::vec3 gaze = way + glm::vec3(0.0f, -0.06f * flat_length(way), 0.0f);
    Command command = turned_towards(player, gaze);
    const float pace = std::clamp((alignment(player, way) - 0.4f) / 0.5f, 0.0f, 1.0f);
    const float brake = std::clamp(flat_length(place - player.position) / 0.5f, 0.25f, 1.0f);
    command.move_forward = input::quantise_move(pace * brake);
    if (is_in_earshot(level_, now.state)) command.buttons |= Button::Crouch;
    return command;
}

Command Thief::handle_thing(const world::Snapshot& now, const glm::vec3& thing) const {
    const world::PlayerState& player = now.state.player;
    const glm::vec3 eye = world::eye_of(player);
    Command command = turned_towards(player, thing - eye);
    const sim::UseTarget target = sim::use_target(level_, now, player);
    const bool is_lid = target.kind == sim::UseKind::Door;
    const bool is_lid_moving = is_lid && now.state.doors[target.index].wants_open != 0;
    if (!looks_at(player, thing)) return command;
    if (target.kind != sim::UseKind::Nothing && !is_lid_moving) press(player, Button::Use, command);
    if (target.kind == sim::UseKind::Nothing && sim::length_of(thing - eye) > kArmsLength) command.move_forward = 40;
    return command;
}

Command Thief::steal(const world::Snapshot& now, const Manner& manner) const {
    const world::PlayerState& player = now.state.player;
    const Goal goal = goal_of(now, manner);
    if (manner.move == Move::Hide) return hide(now, goal.place);
    const bool is_there = flat_length(goal.place - player.position) < kThere;
    const bool is_in_reach = goal.is_thing && sim::length_of(goal.thing - world::eye_of(player)) < kArmsLength &&
                             is_seen_from(now, player.position, goal.thing);
    if (goal.is_thing && (is_there || is_in_reach)) return handle_thing(now, goal.thing);
    return go(now, goal.place);
}

Command Thief::get_caught(const world::Snapshot& now) const {
    const world::State& state = now.state;
    if (state.rules.outcome == world::Outcome::Caught || level_.guards.empty()) {
        Command command{.yaw = state.player.yaw, .pitch = state.player.pitch};
        if (state.tick > state.rules.outcome_tick + 150) press(state.player, Button::Use, command);
        return command;
    }
    std::size_t nearest = 0;
    for (std::size_t g = 1; g < level_.guards.size(); ++g) {
        const float distance = flat_length(state.guards[g].position - state.player.position);
        if (distance < flat_length(state.guards[nearest].position - state.player.position)) nearest = g;
    }
    const glm::vec3 guard = state.guards[nearest].position;
    if (flat_length(guard - state.player.position) > 3.0f) return go(now, guard);
    return turned_towards(state.player, guard + glm::vec3(0.0f, 1.6f, 0.0f) - world::eye_of(state.player));
}

}  // namespace gh::tools
