// sim/player.h - the player's body: looking, walking, running, crouching, leaning, jumping, and the sound of it.
//
// Threads   State belongs to the tick. Same bits: a function of (Level, Snapshot, Command, State).
// Bad input a Command outside its ranges is a contract violation; recordings are checked when they are read.
#pragma once

#include <optional>

#include "input/command.h"
#include "sim/doors.h"
#include "sim/motion.h"
#include "world/snapshot.h"
#include "world/state.h"

namespace gh::sim {

inline constexpr float kPlayerRadius = 0.3f;  // metres
inline constexpr float kGuardRadius = 0.3f;
inline constexpr float kWalkSpeed = 2.0f;     // m/s
inline constexpr float kCrouchSpeed = 1.1f;
inline constexpr float kRunSpeed = 4.5f;
inline constexpr float kJumpHeight = 1.0f;    // metres the feet rise

[[nodiscard]] Body body_of(const world::PlayerState& player);

// Whether the button went down in this tick. PlayerState::buttons_before is that of the tick before.
[[nodiscard]] bool is_pressed(const world::PlayerState& player, const input::Command& command,
                              input::Button button);

// Turns the view and settles stance and lean: what the player wants of the body.
void decide_player(const world::Snapshot& before, const input::Command& command, world::State& state);

// Moves the body through the world as it last stood, but not into a door that has moved since.
void move_player(const world::Level& level, const world::Snapshot& before, const DoorBodies& doors,
                 const input::Command& command, world::State& state);

// Steps and landings since the last tick. `before` is the state at its end.
void sound_player(const world::State& before, const input::Command& command, world::State& state);

}  // namespace gh::sim
