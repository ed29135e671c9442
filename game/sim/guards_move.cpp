// How guards get there: steering along the path, turning, doors, footsteps, clips.
#include <algorithm>
#include <optional>

#include "base/det_math.h"
#include "raycore/query.h"
#include "sim/geometry.h"
#include "sim/guards.h"
#include "sim/guards_animate.h"
#include "sim/noises.h"
#include "sim/player.h"
#include "spatial/transforms.h"
#include "world/eye.h"
#include "world/layers.h"

namespace gh::sim {

namespace {

using world::Alert;
using world::GuardState;
using world::kTickSeconds;

constexpr float kCornerReached = 0.25f;   // metres
constexpr float kAcceleration = 7.0f;     // m/s2
constexpr float kTurnRate = 3.6f;         // rad/s
constexpr float kHastyTurnRate = 7.5f;
constexpr float kHeadRate = 3.0f;         // rad/s
constexpr float kMostHeadYaw = 1.1f;      // rad
constexpr float kKeepFromPlayer = kPlayerRadius + kGuardRadius + 0.05f;  // metres between feet
constexpr float kReachAhead = 0.75f;      // metres at which a guard puts the hand on a door
constexpr float kWideEnough = 0.85f;      // of a door's swing
constexpr std::uint32_t kHoldTicks = 60;  // a door stays open behind a guard
constexpr std::uint16_t kGiveWayTicks = 90;  // stuck for that long, a guard looks for another way

float speed_of(const GuardState& guard) {
    if (guard.alert == Alert::Chasing) return kGuardRunSpeed;
    return guard.alert == Alert::Searching ? kGuardSearchSpeed : kGuardWalkSpeed;
}

float turn_towards(float yaw, float wanted, float step) {
    return wrap_angle(yaw + std::clamp(wrap_angle(wanted - yaw), -step, step));
}

// The direction to the next corner that is not reached yet; zero at the end of the way.
glm::vec3 way_ahead(GuardState& guard) {
    while (guard.path_next < guard.path_count) {
        const glm::vec3 way = flat(guard.path[guard.path_next] - guard.position);
        const bool is_last = guard.path_next + 1 == guard.path_count;
        if (length_of(way) > (is_last ? 0.1f : kCornerReached)) return unit_or_zero(way);
        guard.path_next += 1;
    }
    return glm::vec3(0.0f);
}

// The yaw the guard's attention asks for when its feet do not.
std::optional<float> attention_yaw(const GuardWorld& world, const world::State& state, std::size_t g) {
    const GuardState& guard = state.guards[g];
    // Who is seen in a mirror is looked at in the mirror.
    if (guard.alert == Alert::Suspicious && guard.raised_by == world::Cue::Mirrored) return std::nullopt;
    const bool is_after_somebody = guard.alert == Alert::Suspicious || guard.alert == Alert::Chasing ||
                                   state.rules.outcome == world::Outcome::Caught;
    if (is_after_somebody) {
        const glm::vec3 way = guard.last_known - guard.position;
        if (flat_length(way) > 0.1f) return world::yaw_towards(way);
        return std::nullopt;
    }
    const std::vector<world::PatrolPoint>& patrol = world.level.guards[g].patrol;
    if (guard.alert == Alert::Calm && guard.wait_ticks > 0 && !patrol.empty()) return patrol[guard.patrol_next].yaw;
    return std::nullopt;
}

bool is_passage(const world::Level& level, std::size_t door) {
    const glm::mat4x3 frame = spatial::rigid(level.doors[door].world_from_rest, glm::vec3(0.0f));
    return std::abs(spatial::vector_through(frame, level.doors[door].axis).y) > 0.9f;  // lids are not walked through
}

// Whether a door bars the way; the guard opens it, and holds open what it passes through.
bool waits_for_a_door(const GuardWorld& world, const glm::vec3& direction, std::size_t g, world::State& state) {
    const GuardState& guard = state.guards[g];
    bool waits = false;
    for (std::size_t d = 0; d < world.level.doors.size(); ++d) {
        const float distance = flat_length(world.level.doors[d].handle - guard.position);
        if (distance > 2.5f || !is_passage(world.level, d)) continue;
        if (state.doors[d].held_until_tick != 0 && distance < 1.5f) {
            state.doors[d].held_until_tick = state.tick + kHoldTicks;
        }
        if (openness(world.level, state, d) >= kWideEnough) continue;
        Body ahead = body_of(guard);
        ahead.feet += direction * kReachAhead;
        if (!world.doors.overlaps(world.level, state, d, ahead)) continue;
        hold_door_open(world.level, state, d, state.tick + kHoldTicks);
        waits = true;
    }
    return waits;
}

// Guards are round to the player and to one another.
bool is_blocked_by_somebody(const GuardWorld& world, const world::State& state, std::size_t g, const glm::vec3& to) {
    const glm::vec3 from = state.guards[g].position;
    const auto comes_too_near = [&](const glm::vec3& other, float keep) {
        if (std::abs(other.y - to.y) > kGuardHeight) return false;
        const float after = flat_length(other - to);
        return after < keep && after < flat_length(other - from);
    };
    if (comes_too_near(state.player.position, kKeepFromPlayer)) return true;
    for (std::size_t other = 0; other < world.level.guards.size(); ++other) {
        if (other < g && comes_too_near(state.guards[other].position, 2.0f * kGuardRadius)) return true;
    }
    return false;
}

// Feet on the floor that is drawn, not on the navmesh's idea of it.
void set_on_floor(const GuardWorld& world, GuardState& guard, std::uint8_t& surface) {
    constexpr float kAbove = 0.6f, kBelow = 0.8f;  // metres
    const rc::Ray down{.origin = guard.position + glm::vec3(0.0f, kAbove, 0.0f),
                       .direction = {0.0f, -(kAbove + kBelow), 0.0f},
                       .t_max = 1.0f};
    const std::optional<rc::Hit> floor = rc::closest_hit(*world.snapshot.scene, down, world::Solid);
    if (!floor) return;
    guard.position.y = world.snapshot.scene->surface(*floor).position.y;
    surface = static_cast<std::uint8_t>(surface_at(world.level, floor->instance, floor->primitive));
}

void step_sound(std::size_t g, float moved, std::uint8_t surface, world::State& state) {
    GuardState& guard = state.guards[g];
    const bool runs = guard.alert == Alert::Chasing;
    guard.stride += moved;
    if (guard.stride < (runs ? 1.1f : 0.72f)) return;
    guard.stride = 0.0f;
    const Gait gait = runs ? Gait::Run : Gait::Walk;
    emit(state, {.position = guard.position,
                 .loudness_db = footstep_db(static_cast<world::Surface>(surface), gait),
                 .kind = world::NoiseKind::GuardStep,
                 .surface = surface,
                 .by_guard = static_cast<std::uint8_t>(g)});
}

void turn(const GuardWorld& world, const world::State& state, std::size_t g, const glm::vec3& direction,
          GuardState& guard) {
    const bool walks = direction != glm::vec3(0.0f);
    const float rate = (guard.alert == Alert::Chasing ? kHastyTurnRate : kTurnRate) * kTickSeconds;
    const std::optional<float> attention = attention_yaw(world, state, g);
    if (walks) {
        guard.yaw = turn_towards(guard.yaw, world::yaw_towards(direction), rate);
    } else if (attention) {
        guard.yaw = turn_towards(guard.yaw, *attention, rate);
    }
    // The head is quicker than the body, and stays on what is chased while the feet go round a corner.
    const float head = attention ? std::clamp(wrap_angle(*attention - guard.yaw), -kMostHeadYaw, kMostHeadYaw) : 0.0f;
    guard.head_yaw = towards(guard.head_yaw, head, kHeadRate * kTickSeconds);
}

void move_guard(const GuardWorld& world, std::size_t g, world::State& state) {
    GuardState& guard = state.guards[g];
    const glm::vec3 direction = way_ahead(guard);
    turn(world, state, g, direction, guard);

    const bool waits = direction != glm::vec3(0.0f) && waits_for_a_door(world, direction, g, state);
    const float facing = std::max(glm::dot(world::forward_of_yaw(guard.yaw), direction), 0.0f);
    const float wanted = waits ? 0.0f : speed_of(guard) * facing;
    const float speed = towards(flat_length(guard.velocity), wanted, kAcceleration * kTickSeconds);
    const glm::vec3 step = direction * (waits ? 0.0f : speed * kTickSeconds);

    const glm::vec3 from = guard.position;
    glm::vec3 to = from;
    if (step != glm::vec3(0.0f)) to = world.navigation.walk_along(from, from + step);
    const bool is_blocked = to != from && is_blocked_by_somebody(world, state, g, to);
    if (is_blocked) to = from;
    const bool is_stuck = is_blocked || waits;
    guard.stuck_ticks = is_stuck ? static_cast<std::uint16_t>(guard.stuck_ticks + 1) : std::uint16_t{0};
    if (guard.stuck_ticks > kGiveWayTicks) {
        guard.stuck_ticks = 0;
        guard.path_count = 0;  // decide looks for the way again
    }

    guard.position = to;
    auto surface = static_cast<std::uint8_t>(world::Surface::Marble);
    if (to != from) set_on_floor(world, guard, surface);
    const float moved = flat_length(guard.position - from);
    guard.velocity = flat(guard.position - from) / kTickSeconds;
    step_sound(g, moved, surface, state);
}

}  // namespace

Body body_of(const GuardState& guard) {
    return {.feet = guard.position, .radius = kGuardRadius, .height = kGuardHeight};
}

void move_guards(const GuardWorld& before, world::State& state) {
    for (std::size_t g = 0; g < before.level.guards.size(); ++g) {
        move_guard(before, g, state);
        animate_guard(before.level, g, state);
    }
}

}  // namespace gh::sim
