#include "app/hints.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::app {

namespace {

using world::Alert;
using world::State;

constexpr float kStands = 7.0f;                 // seconds a line stands
constexpr float kFades = 0.6f;                  // of them, at either end
constexpr float kQuiet = 1.2f;                  // between two lines
constexpr float kArm = 2.5f;                    // metres: what is done there the player has done
constexpr std::uint32_t kSettles = 90;          // ticks before anything is said
constexpr std::uint32_t kBoldness = 20u * 60u;  // ticks before anybody is told to throw things

std::size_t index_of(Lesson lesson) {
    return static_cast<std::size_t>(lesson);
}

bool is_urgent(Lesson lesson) {
    return lesson <= Lesson::Exit;
}

float metres_to_nearest_guard(const world::Level& level, const State& state) {
    float nearest = 1e9f;
    for (std::size_t g = 0; g < level.guards.size(); ++g)
        nearest = std::min(nearest, glm::distance(state.guards[g].position, state.player.position));
    return nearest;
}

Alert highest_alert(const world::Level& level, const State& state) {
    Alert highest = Alert::Calm;
    for (std::size_t g = 0; g < level.guards.size(); ++g) highest = std::max(highest, state.guards[g].alert);
    return highest;
}

bool has_every_lens(const world::Level& level, const State& state) {
    return !level.lenses.empty() && state.rules.lenses_taken_count >= level.lenses.size();
}

// Whether a lamp that could be put out is a few steps away.
bool is_near_a_switch(const world::Level& level, const State& state) {
    constexpr float kSteps = 7.0f;  // metres
    return std::any_of(level.switches.begin(), level.switches.end(), [&](const world::Switch& lamp_switch) {
        return lamp_switch.group != world::kNoIndex && state.group_on[lamp_switch.group] != 0 &&
               glm::distance(lamp_switch.position, state.player.position) < kSteps;
    });
}

bool stands_in_an_open_door(const world::Level& level, const State& state) {
    for (std::size_t d = 0; d < level.doors.size(); ++d) {
        if (state.doors[d].wants_open != 0 &&
            glm::distance(level.doors[d].handle, state.player.position) < kArm)
            return true;
    }
    return false;
}

bool made_a_noise(const State& state, world::NoiseKind kind) {
    const auto end = state.noises.begin() + state.noise_count;
    return std::any_of(state.noises.begin(), end, [&](const world::Noise& noise) {
        return noise.kind == kind && glm::distance(noise.position, state.player.position) < kArm;
    });
}

bool is_done(Lesson lesson, const State& state) {
    const world::PlayerState& player = state.player;
    switch (lesson) {
        case Lesson::HandMirror:
            return player.mirror_raise > 0.5f;
        case Lesson::Light:
            return made_a_noise(state, world::NoiseKind::Switch);
        case Lesson::Crouch:
            return player.stance == world::Stance::Crouch;
        case Lesson::Lean:
            return std::abs(player.lean) > 0.5f;
        case Lesson::Stone:
            return player.aim_ticks > 0;
        default:
            return false;  // not a thing to do with a key
    }
}

bool is_due(Lesson lesson, const world::Level& level, const State& state) {
    const world::PlayerState& player = state.player;
    const float guard = metres_to_nearest_guard(level, state);
    const Alert alert = highest_alert(level, state);
    switch (lesson) {
        case Lesson::Chase:
            return alert == Alert::Chasing;
        case Lesson::Search:
            return alert == Alert::Searching;
        case Lesson::Doubt:
            return alert == Alert::Suspicious;
        case Lesson::Exit:
            return has_every_lens(level, state);
        case Lesson::Goal:
            return !level.lenses.empty() && !has_every_lens(level, state);
        case Lesson::HandMirror:
            return player.has_mirror != 0;
        case Lesson::Light:
            return player.exposure > 0.5f && guard < 18.0f && is_near_a_switch(level, state);
        case Lesson::Crouch:
            return guard < 11.0f && glm::length(player.velocity) > 1.0f;
        case Lesson::Lean:
            return stands_in_an_open_door(level, state);
        case Lesson::Stone:
            return state.tick > kBoldness && alert == Alert::Calm && guard < 16.0f && player.stones_left > 0;
    }
    return false;
}

}  // namespace

float Hints::strength() const {
    if (!shown_) return 0.0f;
    return std::clamp(std::min(age_, left_) / kFades, 0.0f, 1.0f);
}

void Hints::learn(const world::Level& level, const State& state) {
    for (std::size_t i = 0; i < kLessons; ++i) {
        const auto lesson = static_cast<Lesson>(i);
        if (!is_done(lesson, state)) continue;
        is_known_[i] = 1;
        if (shown_ == lesson) left_ = std::min(left_, kFades);
    }
    // Who has been chased need not be told what doubt is.
    const Alert alert = highest_alert(level, state);
    if (alert >= Alert::Searching) is_known_[index_of(Lesson::Doubt)] = 1;
    if (has_every_lens(level, state)) is_known_[index_of(Lesson::Goal)] = 1;
}

void Hints::show(Lesson lesson) {
    shown_ = lesson;
    is_known_[index_of(lesson)] = 1;
    age_ = 0.0f;
    left_ = kStands;
}

void Hints::note_tick(const world::Level& level, const world::Snapshot& now) {
    const State& state = now.state;
    if (state.tick < kSettles) return;
    learn(level, state);
    age_ += world::kTickSeconds;
    left_ -= world::kTickSeconds;
    rest_ -= world::kTickSeconds;
    if (shown_ && left_ <= 0.0f) {
        shown_.reset();
        rest_ = kQuiet;
    }
    if (state.rules.outcome != world::Outcome::Playing) {
        shown_.reset();
        return;
    }
    for (std::size_t i = 0; i < kLessons; ++i) {
        const auto lesson = static_cast<Lesson>(i);
        const bool has_room = is_urgent(lesson) ? !shown_ || *shown_ > lesson : !shown_ && rest_ <= 0.0f;
        if (!has_room || is_known_[i] != 0 || !is_due(lesson, level, state)) continue;
        return show(lesson);
    }
}

}  // namespace gh::app
