#include "sim/player.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"
#include "sim/hand_mirror.h"
#include "sim/geometry.h"
#include "sim/noises.h"
#include "world/eye.h"
#include "world/initial_state.h"
#include "world/layers.h"

namespace gh::sim {

namespace {

using input::Button;
using world::kTickSeconds;
using world::PlayerState;

constexpr float kCrouchRate = (world::kStandingHeight - world::kCrouchingHeight) / (0.2f * 60.0f);  // metres a tick
constexpr float kLeanRate = 1.0f / 12.0f;     // of a full lean, a tick
constexpr float kHeadRadius = 0.15f;          // metres a leaning head keeps from walls
constexpr float kGroundAcceleration = 30.0f;  // m/s2
constexpr float kAirAcceleration = 3.0f;
constexpr float kTerminalSpeed = 50.0f;       // m/s
constexpr float kLandingSpeed = 2.0f;         // m/s: softer landings are silent

bool is_running(const PlayerState& player, const input::Command& command) {
    return command.is_held(Button::Run) && player.stance == world::Stance::Stand && command.move_forward > 0;
}

Gait gait_of(const PlayerState& player, const input::Command& command) {
    if (player.stance == world::Stance::Crouch) return Gait::Crouch;
    return is_running(player, command) ? Gait::Run : Gait::Walk;
}

float speed_of(Gait gait) {
    return gait == Gait::Run ? kRunSpeed : gait == Gait::Crouch ? kCrouchSpeed : kWalkSpeed;
}

float stride_of(Gait gait) { return gait == Gait::Run ? 1.15f : gait == Gait::Crouch ? 0.6f : 0.75f; }  // metres

// Horizontal velocity the command asks for; diagonals are no faster.
glm::vec3 wish_velocity(const PlayerState& player, const input::Command& command) {
    const float yaw = world::radians_from_turn(player.yaw);
    const glm::vec3 wish = world::forward_of_yaw(yaw) * (static_cast<float>(command.move_forward) / 127.0f) +
                           world::right_of_yaw(yaw) * (static_cast<float>(command.move_right) / 127.0f);
    const float length = length_of(wish);
    return wish * (speed_of(gait_of(player, command)) / std::max(length, 1.0f));
}

void change_height(const rc::Scene& scene, PlayerState& player) {
    const bool is_low = player.stance == world::Stance::Crouch;
    const float wanted = is_low ? world::kCrouchingHeight : world::kStandingHeight;
    const float height = towards(player.height, wanted, kCrouchRate);
    if (height == player.height) return;
    const Body grown{.feet = player.position, .radius = kPlayerRadius, .height = height};
    if (height < player.height || has_room(scene, grown)) player.height = height;
}

// As far as the wish goes and walls allow.
void change_lean(const rc::Scene& scene, const input::Command& command, PlayerState& player) {
    float wish = 0.0f;
    const bool leans = !steers_mirror(command, player);
    if (leans && command.is_held(Button::LeanLeft)) wish -= 1.0f;
    if (leans && command.is_held(Button::LeanRight)) wish += 1.0f;
    player.lean = towards(player.lean, wish, kLeanRate);
    if (player.lean == 0.0f) return;
    PlayerState upright = player;
    upright.lean = 0.0f;
    const glm::vec3 eye = world::eye_of(upright);
    const glm::vec3 way = world::eye_of(player) - eye;
    const auto hit = rc::sphere_cast(scene, eye, kHeadRadius, way, world::Solid);
    if (hit) player.lean *= hit->t;
}

void accelerate(const glm::vec3& wish, PlayerState& player) {
    const float step = (player.is_grounded != 0 ? kGroundAcceleration : kAirAcceleration) * kTickSeconds;
    if (player.is_grounded == 0 && wish == glm::vec3(0.0f)) return;  // nothing to push against
    const glm::vec3 change = flat(wish - player.velocity);
    const float size = length_of(change);
    const glm::vec3 taken = size > step ? change * (step / size) : change;
    player.velocity += taken;
}

void land(const world::Level& level, const Ground& ground, PlayerState& player) {
    player.is_grounded = 1;
    player.ground_surface = static_cast<std::uint8_t>(surface_at(level, ground.instance, ground.primitive));
    player.velocity.y = 0.0f;
}

void move_on_ground(const world::Level& level, const rc::Scene& scene, Body& body, PlayerState& player) {
    const glm::vec3 displacement = player.velocity * kTickSeconds;
    if (displacement != glm::vec3(0.0f)) walk(scene, body, displacement, player.velocity);
    player.velocity.y = 0.0f;
    const Ground ground = stand(scene, body, kStepHeight);
    if (ground.is_there) {
        land(level, ground, player);
    } else {
        player.is_grounded = 0;
    }
}

void move_in_air(const world::Level& level, const rc::Scene& scene, Body& body, PlayerState& player) {
    const glm::vec3 fall{0.0f, -kGravity, 0.0f};
    const glm::vec3 displacement = player.velocity * kTickSeconds + fall * (0.5f * kTickSeconds * kTickSeconds);
    player.velocity += fall * kTickSeconds;
    player.velocity.y = std::max(player.velocity.y, -kTerminalSpeed);
    const glm::vec3 falling = player.velocity;
    slide(scene, body, displacement, false, player.velocity);
    if (falling.y > 0.0f) return;
    const Ground ground = stand(scene, body, kPadding);
    if (ground.is_there) land(level, ground, player);
}

// Characters are round to one another: the player stops at a guard's side.
void keep_off_guards(const world::Level& level, const rc::Scene& scene, const world::State& state, Body& body) {
    for (std::size_t g = 0; g < level.guards.size(); ++g) {
        const glm::vec3 away = body.feet - state.guards[g].position;
        const float distance = flat_length(away);
        const float wanted = kPlayerRadius + kGuardRadius;
        if (!(distance < wanted) || distance < 1e-3f || std::abs(away.y) > world::kStandingHeight) continue;
        glm::vec3 unused{0.0f};
        slide(scene, body, flat(away) * ((wanted - distance) / distance), true, unused);
    }
}

bool is_in_a_moved_door(const world::Level& level, const world::Snapshot& before, const DoorBodies& doors,
                        const world::State& state, const Body& body) {
    for (std::size_t d = 0; d < level.doors.size(); ++d) {
        const bool has_moved = state.doors[d].angle != before.state.doors[d].angle;
        if (has_moved && doors.overlaps(level, state, d, body)) return true;
    }
    return false;
}

}  // namespace

Body body_of(const PlayerState& player) {
    return {.feet = player.position, .radius = kPlayerRadius, .height = player.height};
}

bool is_pressed(const PlayerState& player, const input::Command& command, Button button) {
    return command.is_held(button) && (player.buttons_before & button) == 0;
}

void decide_player(const world::Snapshot& before, const input::Command& command, world::State& state) {
    EXPECTS(input::is_valid(command));
    PlayerState& player = state.player;
    player.yaw = command.yaw;
    player.pitch = command.pitch;
    const bool must_stay_low = player.stance == world::Stance::Crouch && player.height < world::kStandingHeight &&
                               !has_room(*before.scene, {.feet = player.position,
                                                         .radius = kPlayerRadius,
                                                         .height = world::kStandingHeight});
    const bool is_low = command.is_held(Button::Crouch) || must_stay_low;
    player.stance = is_low ? world::Stance::Crouch : world::Stance::Stand;
    change_height(*before.scene, player);
    change_lean(*before.scene, command, player);
    move_hand_mirror(before, command, player);
}

void move_player(const world::Level& level, const world::Snapshot& before, const DoorBodies& doors,
                 const input::Command& command, world::State& state) {
    PlayerState& player = state.player;
    const rc::Scene& scene = *before.scene;
    Body body = body_of(player);
    push_out(scene, body);
    accelerate(wish_velocity(player, command), player);
    const bool jumps = is_pressed(player, command, Button::Jump) && player.is_grounded != 0 &&
                       player.stance == world::Stance::Stand;
    if (jumps) {
        player.velocity.y = std::sqrt(2.0f * kGravity * kJumpHeight);
        player.is_grounded = 0;
    }
    if (player.is_grounded != 0) {
        move_on_ground(level, scene, body, player);
    } else {
        move_in_air(level, scene, body, player);
    }
    keep_off_guards(level, scene, state, body);
    if (is_in_a_moved_door(level, before, doors, state, body)) {
        body.feet = player.position;  // where the door has just made sure that it passes
        player.velocity = glm::vec3(0.0f);
    }
    const glm::vec3 moved = body.feet - player.position;
    player.position = body.feet;
    if (player.is_grounded != 0) player.stride += flat_length(moved);
}

void sound_player(const world::State& before, const input::Command& command, world::State& state) {
    PlayerState& player = state.player;
    const auto surface = static_cast<world::Surface>(player.ground_surface);
    world::Noise noise{.position = player.position, .surface = player.ground_surface};
    const bool has_landed = player.is_grounded != 0 && before.player.is_grounded == 0;
    if (has_landed && before.player.velocity.y < -kLandingSpeed) {
        noise.kind = world::NoiseKind::Land;
        noise.loudness_db = landing_db(surface, -before.player.velocity.y);
        emit_by_player(state, noise);
        player.stride = 0.0f;
        return;
    }
    const Gait gait = gait_of(player, command);
    if (player.stride < stride_of(gait)) return;
    player.stride = 0.0f;
    noise.loudness_db = footstep_db(surface, gait);
    emit_by_player(state, noise);
}

}  // namespace gh::sim
