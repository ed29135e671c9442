#include "actor.h"

#include "base/det_math.h"
#include "hands.h"
#include "sim/geometry.h"
#include "sim/stones.h"
#include "world/eye.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace gh::tools {

namespace {

using input::Button;
using input::Command;

constexpr float kArrived = 0.22f;        // metres from a place
constexpr float kCornerReached = 0.45f;  // metres: corners are cut, as people cut them
constexpr float kLooksAhead = 3.5f;      // metres along the way
constexpr float kLooksUpAt = 1.8f;       // metres before a place: what is to be done there takes the eyes
constexpr float kHeadPull = 0.0075f;     // of what is left to turn, a tick a tick
constexpr float kHeadDrag = 0.155f;      // of the turning speed, a tick: just short of swinging over
constexpr float kMostTurn = 0.085f;      // radians a tick
constexpr float kNearEnough = 0.7f;      // metres a stone may miss by
constexpr int kFlattest = 36;            // degrees: a flatter stone comes bouncing back
constexpr int kStuckTicks = 90;

float towards_angle(float left, float& speed) {
    speed += left * kHeadPull - speed * kHeadDrag;
    speed = std::clamp(speed, -kMostTurn, kMostTurn);
    return speed;
}

}  // namespace

Actor::Actor(std::shared_ptr<const world::Level> level, std::uint32_t seed)
    : level_(std::move(level)), simulation_(level_, seed), navigation_(*level_) {}

void Actor::fail(std::string_view what) {
    if (trouble_) return;
    const glm::vec3 at = state().player.position;
    trouble_ = fmt::format("{:.1f} s, at {:.1f} {:.1f} {:.1f}: {}", static_cast<float>(run_.size()) / 60.0f,
                           at.x, at.y, at.z, what);
}

void Actor::note(std::string_view what) const {
    constexpr std::array kAlerts = {"calm", "suspicious", "searching", "chasing"};
    if (trouble_) return;
    if (level_->guards.empty()) return;
    const glm::vec3 p = state().player.position;
    const glm::vec3 g = guard().position;
    const glm::vec3 k = guard().last_known;
    fmt::print(
        "{:6.1f} s ({:4.1f} still)  {:<28} at {:5.1f} {:5.1f}, lit {:.2f}; guard {} ({:.0f}) at {:5.1f} "
        "{:5.1f}, {:.1f} m, "
        "thinks of {:.1f} {:.1f}\n",
        static_cast<float>(run_.size()) / 60.0f, static_cast<float>(still_ticks_) / 60.0f, what, p.x, p.z,
        state().player.exposure, kAlerts[static_cast<std::size_t>(guard().alert)], guard().suspicion, g.x,
        g.z, sim::length_of(g - p), k.x, k.z);
}

bool Actor::guard_is_in(std::string_view room) const {
    const auto index = named(level_->rooms, room);
    if (!index || level_->guards.empty()) return false;
    const world::Aabb& box = level_->rooms[*index].box;
    const glm::vec3 g = guard().position;
    return box.min.x <= g.x && g.x <= box.max.x && box.min.z <= g.z && g.z <= box.max.z;
}

void Actor::step(Command command, const Pose& pose) {
    if (trouble_) return;
    if (pose.is_low) command.buttons |= Button::Crouch;
    if (pose.lean < 0.0f) command.buttons |= Button::LeanLeft;
    if (pose.lean > 0.0f) command.buttons |= Button::LeanRight;
    if (pose.holds_mirror) command.buttons |= Button::HandMirror;
    run_.push_back(command);
    simulation_.step(command);
    still_ticks_ += sim::flat_length(state().player.velocity) < 0.05f ? 1 : 0;
    if (state().rules.outcome == world::Outcome::Caught) fail("caught");
}

Command Actor::looking_along(const glm::vec3& way) {
    const world::PlayerState& player = state().player;
    const float yaw = world::radians_from_turn(player.yaw);
    const float pitch = world::radians_from_turn(player.pitch);
    const float left = wrap_angle(world::yaw_towards(way) - yaw);
    const float up = det::atan2(way.y, sim::flat_length(way)) - pitch;
    return {.yaw = input::quantise_yaw(yaw + towards_angle(left, turn_speed_)),
            .pitch = input::quantise_pitch(pitch + towards_angle(up, tilt_speed_))};
}

Command Actor::looking_at(const glm::vec3& point) {
    return looking_along(point - world::eye_of(state().player));
}

// The point some metres ahead on the way, at the height of a level gaze.
glm::vec3 Actor::ahead_on(std::span<const glm::vec3> corners) const {
    const world::PlayerState& player = state().player;
    glm::vec3 ahead = player.position;
    float metres = kLooksAhead;
    for (const glm::vec3& corner : corners) {
        const glm::vec3 leg = corner - ahead;
        const float length = std::max(sim::length_of(leg), 1e-3f);
        ahead += leg * std::clamp(metres / length, 0.0f, 1.0f);
        metres -= length;
    }
    return ahead + glm::vec3(0.0f, player.height - world::kEyeBelowTop - 0.15f, 0.0f);
}

void Actor::walk_to(const glm::vec3& place, Pace pace, const Gaze& gaze, const Enough& enough) {
    const glm::vec3 goal = navigation_.nearest(place).value_or(place);
    glm::vec3 was_at = state().player.position;
    int still = 0;
    while (!trouble_ && state().rules.outcome == world::Outcome::Playing) {
        const world::PlayerState& player = state().player;
        const float left = sim::flat_length(goal - player.position);
        if (left < kArrived || (enough && enough())) return;
        std::array<glm::vec3, world::kMaxPathCorners> corners;
        const sim::Path path = navigation_.find_path(player.position, goal, corners);
        if (path.corners == 0) return fail("no way from here");
        std::size_t next = 0;
        while (next + 1 < path.corners && sim::flat_length(corners[next] - player.position) < kCornerReached)
            ++next;
        const glm::vec3 way = sim::unit_or_zero(sim::flat(corners[next] - player.position));

        const glm::vec3 ahead = ahead_on(std::span(corners).subspan(next, path.corners - next));
        const bool is_near =
            sim::flat_length(ahead - player.position) < 0.8f;  // keep the eyes where they are
        const std::optional<glm::vec3> wanted = gaze(left);
        const glm::vec3 look = wanted    ? *wanted - world::eye_of(player)
                               : is_near ? world::look_of(player)
                                         : ahead - world::eye_of(player);
        Command command = looking_along(look);
        const float brake = pace == Pace::Run ? 1.0f : std::clamp(left / 0.45f, 0.35f, 1.0f);
        walk_along(way, brake, command);
        if (pace == Pace::Run) command.buttons |= Button::Run;
        step(command, {.is_low = pace == Pace::Creep});
        still = sim::flat_length(state().player.position - was_at) < 0.004f ? still + 1 : 0;
        was_at = state().player.position;
        if (still > kStuckTicks) return fail("something is in the way");
    }
}

void Actor::go(const glm::vec3& place, Pace pace, std::optional<glm::vec3> gaze) {
    walk_to(place, pace, [&](float) { return gaze; });
}

void Actor::go_for(const glm::vec3& place, Pace pace, const glm::vec3& thing) {
    const float soon = pace == Pace::Run ? kLooksUpAt * 2.0f : kLooksUpAt;
    walk_to(place, pace, [&](float left) { return left < soon ? std::optional(thing) : std::nullopt; });
}

void Actor::go_watching_guard(const glm::vec3& place, Pace pace, const Enough& enough) {
    walk_to(
        place, pace, [&](float) { return std::optional(guard().position + glm::vec3(0.0f, 1.4f, 0.0f)); },
        enough);
}

void Actor::go_until(const glm::vec3& place, Pace pace, const Enough& enough) {
    walk_to(
        place, pace, [](float) { return std::nullopt; }, enough);
}

void Actor::watch(const glm::vec3& at, float seconds, Pose pose, const Enough& enough) {
    const int most = static_cast<int>(seconds * 60.0f);
    for (int i = 0; i < most && !trouble_; ++i) {
        if (enough && enough()) return;
        step(looking_at(at), pose);
    }
}

void Actor::watch_guard(float seconds, Pose pose, const Enough& enough) {
    const int most = static_cast<int>(seconds * 60.0f);
    for (int i = 0; i < most && !trouble_; ++i) {
        if (enough && enough()) return;
        step(looking_at(guard().position + glm::vec3(0.0f, 1.4f, 0.0f)), pose);
    }
}

void Actor::watch_guard_in_mirror(float seconds, float side, const Enough& enough) {
    const int most = static_cast<int>(seconds * 60.0f);
    for (int i = 0; i < most && !trouble_; ++i) {
        if (enough && enough()) return;
        const glm::vec3 pane = simulation_.snapshot()->panes[level_->hand_mirror].centre;
        const glm::vec3 to_guard = guard().position - pane;
        // The mirror shows what lies square to the look, on its side.
        const glm::vec3 ahead = glm::vec3(to_guard.z, 0.0f, -to_guard.x) * side;
        const glm::vec3 gaze = ahead - glm::vec3(0.0f, 0.04f * sim::flat_length(ahead), 0.0f);
        step(looking_along(gaze), {.is_low = true, .lean = side, .holds_mirror = true});
    }
}

float Actor::arc_error(const glm::vec3& at, float pitch, std::uint16_t aim_ticks) const {
    world::Snapshot aimed = *simulation_.snapshot();
    aimed.state.player.yaw = input::quantise_yaw(world::yaw_towards(at - world::eye_of(state().player)));
    aimed.state.player.pitch = input::quantise_pitch(pitch);
    aimed.state.player.aim_ticks = aim_ticks;
    aimed.state.player.velocity = glm::vec3(0.0f);
    std::array<glm::vec3, sim::kMaxArcPoints> arc;
    const std::size_t points = sim::throw_arc(*level_, aimed, arc);
    return points == 0 ? 1e9f : sim::length_of(arc[points - 1] - at);
}

void Actor::throw_stone(const glm::vec3& at, Pose pose) {
    if (trouble_) return;
    // As flat as gets there and stays: who throws high sees nothing but the ceiling.
    float best_pitch = 0.0f, best_error = 1e9f;
    std::uint16_t best_aim = 30;
    for (int degrees = kFlattest; degrees <= 50 && best_error > kNearEnough; degrees += 2) {
        for (std::uint16_t aim = 60; aim >= 20; aim = static_cast<std::uint16_t>(aim - 5)) {
            const float pitch = static_cast<float>(degrees) * (kPi / 180.0f);
            const float error = arc_error(at, pitch, aim);
            if (error < best_error)
                std::tie(best_pitch, best_error, best_aim) = std::tuple(pitch, error, aim);
        }
    }
    if (best_error > 1.0f) return fail(fmt::format("no throw gets nearer than {:.1f} m", best_error));
    const glm::vec3 way = sim::unit_or_zero(sim::flat(at - world::eye_of(state().player)));
    const auto [sine, cosine] = det::sin_cos(best_pitch);
    const glm::vec3 aim = way * cosine + glm::vec3(0.0f, sine, 0.0f);
    for (int i = 0; i < 40; ++i) step(looking_along(aim), pose);
    for (int i = 0; i < best_aim; ++i) {
        Command command = looking_along(aim);
        command.buttons |= Button::Throw;
        step(command, pose);
    }
    for (int i = 0; i < 20; ++i) step(looking_along(aim), pose);
}

}  // namespace gh::tools
