#include "app/hud_model.h"

#include "app/hint_words.h"
#include "app/noise_words.h"
#include "sim/guards.h"
#include "sim/stones.h"
#include "sim/use_target.h"
#include "world/eye.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace gh::app {

namespace {

constexpr float kQuietestNeedleDb = 25.0f;  // where the noise bars begin and end, dB at 1 m
constexpr float kLoudestNeedleDb = 80.0f;
constexpr float kCaptionHearing =
    20.0f;  // metres; the mixer decides what is heard, this what is worth reading

struct Frame {
    glm::vec3 right, up, forward;
};

Frame frame_of(const render::Camera& camera) {
    const float cy = std::cos(camera.yaw), sy = std::sin(camera.yaw);
    const float cp = std::cos(camera.pitch), sp = std::sin(camera.pitch);
    const glm::vec3 forward(-sy * cp, sp, -cy * cp);
    const glm::vec3 right(cy, 0.0f, -sy);
    return {right, glm::cross(right, forward), forward};
}

// Radians from straight ahead to a place, positive to the right.
float bearing_to(const world::PlayerState& player, const glm::vec3& place) {
    const float yaw = world::radians_from_turn(player.yaw);
    const glm::vec3 to = place - player.position;
    return std::atan2(glm::dot(to, world::right_of_yaw(yaw)), glm::dot(to, world::forward_of_yaw(yaw)));
}

present::Mood mood_of(world::Alert alert) {
    switch (alert) {
        case world::Alert::Calm:
            return present::Mood::Calm;
        case world::Alert::Suspicious:
            return present::Mood::Suspicious;
        case world::Alert::Searching:
            return present::Mood::Searching;
        case world::Alert::Chasing:
            return present::Mood::Chasing;
    }
    return present::Mood::Calm;
}

// Share of the way from this mood to the next.
float way_to_next_mood(const world::GuardState& guard) {
    switch (guard.alert) {
        case world::Alert::Calm:
            return guard.suspicion / sim::kSuspiciousAt;
        case world::Alert::Suspicious:
            return (guard.suspicion - sim::kSuspiciousAt) / (sim::kSearchingAt - sim::kSuspiciousAt);
        case world::Alert::Searching:
            return (guard.suspicion - sim::kSearchingAt) / (sim::kChasingAt - sim::kSearchingAt);
        case world::Alert::Chasing:
            return 1.0f;
    }
    return 0.0f;
}

std::string cue_words(world::Cue cue) {
    switch (cue) {
        case world::Cue::None:
            return "";
        case world::Cue::Seen:
            return "saw you";
        case world::Cue::Mirrored:
            return "saw you in a mirror";
        case world::Cue::Heard:
            return "heard something";
        case world::Cue::Struck:
            return "was hit by a stone";
    }
    return "";
}

std::string title_of_room(const world::Level& level, const glm::vec3& position) {
    for (const world::Room& room : level.rooms) {
        const glm::vec3 p = position + glm::vec3(0.0f, 0.5f, 0.0f);
        const bool is_inside =
            glm::all(glm::lessThanEqual(room.box.min, p)) && glm::all(glm::lessThanEqual(p, room.box.max));
        if (is_inside) return room.title.empty() ? room.name : room.title;
    }
    return "";
}

// "open: door": what `use` would do now, by the simulation's own account.
std::string offer_of(const world::Level& level, const world::Snapshot& now) {
    const sim::UseTarget target = sim::use_target(level, now, now.state.player);
    const auto named = [](const std::string& title, const char* otherwise) {
        return title.empty() ? std::string(otherwise) : title;
    };
    switch (target.kind) {
        case sim::UseKind::Nothing:
            return "";
        case sim::UseKind::Door:
            return (now.state.doors[target.index].wants_open != 0 ? "close: " : "open: ") +
                   named(level.doors[target.index].title, "door");
        case sim::UseKind::Mirror:
            return "turn: " + named(level.mirrors[target.index].title, "mirror");
        case sim::UseKind::Switch: {
            const std::uint32_t group = level.switches[target.index].group;
            const bool is_on = group != world::kNoIndex && now.state.group_on[group] != 0;
            return (is_on ? "lights off: " : "lights on: ") +
                   named(level.switches[target.index].title, "lamps");
        }
        case sim::UseKind::Lens:
            return "take: " + named(level.lenses[target.index].title, "the lens");
        case sim::UseKind::HandMirror:
            return "take: " + named(level.mirrors[target.index].title, "the hand mirror");
        case sim::UseKind::Stone:
            return "pick up the stone";
    }
    return "";
}

// The flight of the aimed stone in picture coordinates, thinned so that its dots can be told apart.
std::vector<glm::vec2> arc_in_picture(const world::Level& level, const world::Snapshot& now,
                                      const render::Camera& camera, float aspect) {
    std::array<glm::vec3, sim::kMaxArcPoints> points{};
    const std::size_t count = sim::throw_arc(level, now, points);
    constexpr std::size_t kEvery = 3;  // ticks between dots
    std::vector<glm::vec2> arc;
    for (std::size_t i = kEvery; i < count; i += kEvery) {
        if (const auto at = picture_point(camera, aspect, points[i])) arc.push_back(*at);
    }
    if (count > 0) {
        if (const auto landing = picture_point(camera, aspect, points[count - 1])) arc.push_back(*landing);
    }
    return arc;
}

void write_outcome(const world::State& state, const KeyWords& keys, present::HudModel& hud) {
    if (state.rules.outcome == world::Outcome::Caught) {
        hud.headline = "Caught";
        hud.subline = "press " + keys.one(input::Action::Use) + " to go back to the last checkpoint";
    } else if (state.rules.outcome == world::Outcome::Won) {
        hud.headline = "Into the night";
        hud.subline = "the lens is yours; Esc for the menu";
    }
}

}  // namespace

std::optional<glm::vec2> picture_point(const render::Camera& camera, float aspect, const glm::vec3& point) {
    const Frame frame = frame_of(camera);
    const glm::vec3 to = point - camera.position;
    const float depth = glm::dot(to, frame.forward);
    if (depth < 0.05f) return std::nullopt;
    const float half_height = std::tan(camera.fov_y * 0.5f);
    return glm::vec2(0.5f + 0.5f * glm::dot(to, frame.right) / (depth * half_height * aspect),
                     0.5f - 0.5f * glm::dot(to, frame.up) / (depth * half_height));
}

void HudReader::say(const std::string& words) {
    captions_.add({.text = words, .subject = {}});
}

void HudReader::note_tick(const world::Level& level, const world::Snapshot& now) {
    captions_.grow_older(world::kTickSeconds);
    const world::State& state = now.state;
    for (std::uint32_t i = 0; i < state.noise_count; ++i) {
        const world::Noise& noise = state.noises[i];
        const std::string words = caption_of(noise);
        if (words.empty() || glm::distance(noise.position, state.player.position) > kCaptionHearing) continue;
        captions_.add({.text = words,
                       .subject = subject_of(noise),
                       .bearing = bearing_to(state.player, noise.position),
                       .has_bearing = true});
    }
    hints_.note_tick(level, now);
    const std::string room = title_of_room(level, state.player.position);
    if (room != room_ && !room.empty()) {
        room_ = room;
        room_age_ = 0.0f;
    } else {
        room_age_ += world::kTickSeconds;
    }
}

present::HudModel HudReader::model(const world::Level& level, const world::Snapshot& now,
                                   const render::Camera& camera, float aspect,
                                   const HudChoices& choices) const {
    const world::State& state = now.state;
    const world::PlayerState& player = state.player;
    present::HudModel hud;
    hud.exposure = player.exposure;
    hud.noise = std::clamp((player.noise_db - kQuietestNeedleDb) / (kLoudestNeedleDb - kQuietestNeedleDb),
                           0.0f, 1.0f);
    hud.is_crouched = player.stance == world::Stance::Crouch;
    hud.is_running = !hud.is_crouched && glm::length(player.velocity) > 3.0f;
    hud.is_walking = glm::length(player.velocity) > 0.3f;
    hud.stones_left = player.stones_left;
    if (player.has_mirror != 0) hud.mirror = choices.keys.one(input::Action::HandMirror) + "  hand mirror";
    hud.lenses_total = static_cast<int>(level.lenses.size());
    hud.lenses_taken = state.rules.lenses_taken_count;
    hud.room = room_;
    hud.room_age = room_age_;
    for (const present::Caption& caption : captions_.list())
        if (choices.captions || !caption.has_bearing) hud.captions.push_back(caption);
    if (choices.hints && hints_.lesson()) {
        hud.hint = words_for(*hints_.lesson(), level, choices.keys);
        hud.hint_strength = hints_.strength();
    }
    for (std::size_t g = 0; g < level.guards.size(); ++g) {
        const world::GuardState& guard = state.guards[g];
        hud.guards.push_back({.bearing = bearing_to(player, guard.position),
                              .suspicion = std::clamp(way_to_next_mood(guard), 0.0f, 1.0f),
                              .distance = glm::distance(guard.position, player.position),
                              .mood = mood_of(guard.alert),
                              .cue = cue_words(guard.raised_by)});
    }
    if (player.aim_ticks > 0) {
        hud.aim = std::min(1.0f, static_cast<float>(player.aim_ticks) / world::kTicksPerSecond);
        hud.throw_arc = arc_in_picture(level, now, camera, aspect);
    }
    if (state.rules.outcome == world::Outcome::Playing) {
        hud.prompt = offer_of(level, now);
        hud.prompt_key = choices.keys.one(input::Action::Use);
    }
    write_outcome(state, choices.keys, hud);
    return hud;
}

}  // namespace gh::app
