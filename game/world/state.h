// world/state.h - all that changes, as one plain struct: copy it and you have saved the game.
//
// Written   by sim alone; everybody else reads.
// Hashed    field by field in written order by state_hash; padding never.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include <glm/vec3.hpp>

#include "world/level.h"

namespace gh::world {

inline constexpr int kTicksPerSecond = 60;
inline constexpr float kTickSeconds = 1.0f / 60.0f;

enum class Stance : std::uint8_t { Stand, Crouch };
enum class Outcome : std::uint8_t { Playing, Caught, Won };

struct PlayerState {
    glm::vec3 position{0.0f};  // feet, metres
    glm::vec3 velocity{0.0f};  // m/s
    std::int16_t yaw = 0;      // as in the Command
    std::int16_t pitch = 0;
    float height = 1.75f;      // of the capsule now: crouching takes time
    float lean = 0.0f;         // -1 left .. 1 right, as far as walls allow
    float stride = 0.0f;       // metres since the last footstep
    float exposure = 0.0f;     // 0 dark .. 1 fully lit; the HUD's gem and the guards' number
    float noise_db = 0.0f;     // of the loudest thing just done, fading; for the HUD
    float mirror_raise = 0.0f;  // of the hand mirror: 0 put away .. 1 held up
    float mirror_side = 0.0f;   // -1 held out to the left, to look round that corner; 0 shows what is behind; 1 right
    float mirror_reach = 1.0f;  // share of the arm that walls leave it
    Stance stance = Stance::Stand;
    std::uint8_t is_grounded = 0;
    std::uint8_t ground_surface = 0;  // world::Surface
    std::uint8_t stones_left = 0;
    std::uint16_t buttons_before = 0;  // so that edges can be told from held keys
    std::uint16_t aim_ticks = 0;       // how long the throw is held
    std::uint8_t has_mirror = 0;
    std::uint8_t pad_[3] = {};
};
static_assert(sizeof(PlayerState) == 72);

struct DoorState {
    float angle = 0.0f;  // radians from closed, towards open_angle
    std::uint8_t wants_open = 0;
    std::uint8_t pad_[3] = {};
    std::uint32_t held_until_tick = 0;  // a guard keeps it open until then
};

struct MirrorState {
    float angle = 0.0f;  // radians from rest
    float target = 0.0f;
};

struct StoneState {
    glm::vec3 position{0.0f};
    glm::vec3 velocity{0.0f};
    std::uint32_t thrown_tick = 0;
    std::uint8_t is_present = 0;
    std::uint8_t is_resting = 0;
    std::uint8_t pad_[2] = {};
};

enum class Alert : std::uint8_t { Calm, Suspicious, Searching, Chasing };
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"  // GCC 12 takes scoped enumerators for hiders of layers.h's names
enum class Cue : std::uint8_t { None, Seen, Mirrored, Heard, Struck };  // what raised a suspicion last
#pragma GCC diagnostic pop

// What a guard knew at the end of the last tick: written by perceive, read by decide.
struct Percept {
    glm::vec3 seen_at{0.0f};      // where the player seemed to be (through a mirror: the true place)
    glm::vec3 heard_at{0.0f};     // where the loudest noise seemed to come from
    glm::vec3 struck_from{0.0f};  // where the last stone that hit seemed to come from
    float sight = 0.0f;         // lit share of the player's body in plain view, 0..1
    float mirror_sight = 0.0f;  // the same in mirrors
    float sight_metres = 0.0f;  // to the nearest point seen, along the light
    float mirror_metres = 0.0f;
    float heard_db = -120.0f;   // of the loudest noise at the ear, after walls
    std::uint8_t is_fresh = 0;  // whether the guard looked in this tick: it does on every fourth
    std::uint8_t is_struck = 0;  // whether a stone hit in this tick
    std::uint8_t pad_[2] = {};
};
static_assert(sizeof(Percept) == 60);

inline constexpr std::size_t kMaxPathCorners = 32;

struct GuardState {
    glm::vec3 position{0.0f};  // feet
    glm::vec3 velocity{0.0f};
    float yaw = 0.0f;          // of the body
    float head_yaw = 0.0f;     // relative to the body
    float suspicion = 0.0f;
    Percept percept;
    glm::vec3 target{0.0f};    // where the path leads
    glm::vec3 last_known{0.0f};
    std::array<glm::vec3, kMaxPathCorners> path{};
    std::uint16_t path_count = 0;
    std::uint16_t path_next = 0;
    std::uint16_t patrol_next = 0;
    std::uint16_t wait_ticks = 0;
    std::uint32_t state_ticks = 0;  // in this alert state
    float clip_time = 0.0f;         // seconds into the clip
    float clip_blend = 1.0f;        // weight of clip over clip_before
    float clip_before_time = 0.0f;
    float stride = 0.0f;            // metres since the last footstep
    std::uint16_t seen_ticks = 0;   // for how long the player is in plain view, without a gap
    std::uint16_t quiet_ticks = 0;  // since anything was last noticed
    std::uint16_t searched = 0;     // places looked at in this search
    std::uint16_t stuck_ticks = 0;  // something is in the way
    Alert alert = Alert::Calm;
    Cue raised_by = Cue::None;
    ClipId clip = ClipId::Stand;
    ClipId clip_before = ClipId::Stand;
};
static_assert(sizeof(GuardState) == 544);

enum class NoiseKind : std::uint8_t {
    Footstep, Land, StoneHit, DoorOpen, DoorClose, Switch, MirrorTurn, LensTaken, Bark, GuardStep, Throw, PickUp,
};
enum class Bark : std::uint8_t { None, Huh, WhoIsThere, Alarm, GaveUp, Caught };

// Something that sounded in this tick.
struct Noise {
    glm::vec3 position{0.0f};
    float loudness_db = 0.0f;  // at 1 m
    NoiseKind kind = NoiseKind::Footstep;
    std::uint8_t surface = 0;  // world::Surface
    Bark bark = Bark::None;
    std::uint8_t by_guard = 0xFF;  // which guard made it; 0xFE: one of them, at a door; 0xFF: player, stone or thing
};

inline constexpr std::size_t kMaxNoises = 32;

struct RulesState {
    Outcome outcome = Outcome::Playing;
    std::uint8_t lenses_taken_count = 0;
    std::uint8_t pad_[2] = {};
    std::uint32_t outcome_tick = 0;
    std::uint32_t times_caught = 0;
};

struct State {
    std::uint32_t tick = 0;
    std::uint32_t seed = 0;
    PlayerState player;
    RulesState rules;
    std::array<DoorState, kMaxDoors> doors{};
    std::array<MirrorState, kMaxMirrors> mirrors{};
    std::array<std::uint8_t, kMaxLampGroups> group_on{};
    std::array<std::uint8_t, kMaxLenses> lens_taken{};
    std::array<StoneState, kMaxStones> stones{};
    std::array<GuardState, kMaxGuards> guards{};
    std::array<Noise, kMaxNoises> noises{};
    std::uint32_t noise_count = 0;
};
static_assert(std::is_trivially_copyable_v<State>);
// No hidden padding anywhere: copies of equal states are equal bytes.
static_assert(sizeof(State) == 8 + sizeof(PlayerState) + sizeof(RulesState) + sizeof(State::doors) +
                                   sizeof(State::mirrors) + sizeof(State::group_on) + sizeof(State::lens_taken) +
                                   sizeof(State::stones) + sizeof(State::guards) + sizeof(State::noises) + 4);

// Whether a lamp shines now.
[[nodiscard]] inline bool is_lamp_on(const Level& level, const State& state, std::size_t lamp) {
    const std::uint32_t group = level.lamps[lamp].group;
    return group == kNoIndex ? level.lamps[lamp].starts_on : state.group_on[group] != 0;
}

}  // namespace gh::world
