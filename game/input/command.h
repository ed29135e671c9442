// input/command.h - what the player means to do in one tick, as it is recorded and as it is simulated.
//
// Everything a device says is quantised to this, once a tick, *after* sensitivity and key bindings; there is
// no other way into the game. Eight bytes without padding: an hour of them is 1.7 MB before compression.
//
// Angles    a turn is 65536 units. yaw 0 looks along -z, positive turns left (counter-clockwise from above)
//           and wraps; pitch is positive upwards and stays within 89 degrees of level.
// Same bits helpers use det_math only.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <type_traits>

namespace gh::input {

// Held in this tick. What happens once a press (jumping, using) is the simulation's business: it remembers
// the buttons of the tick before.
enum Button : std::uint16_t {
    Run = 1u << 0,
    Crouch = 1u << 1,
    Jump = 1u << 2,
    LeanLeft = 1u << 3,
    LeanRight = 1u << 4,
    Use = 1u << 5,         // doors, switches, turnable mirrors, picking up
    Throw = 1u << 6,       // held: aim; let go: throw
    Cancel = 1u << 7,      // puts an aimed stone back
    HandMirror = 1u << 8,  // holds the hand mirror up; leaning then moves the arm
    Restart = 1u << 9,     // back to the last checkpoint
};
inline constexpr std::uint16_t kAllButtons = (1u << 10) - 1;

inline constexpr std::int16_t kMaxPitch = 16202;  // 89 degrees
inline constexpr std::int8_t kMaxMove = 127;

struct Command {
    std::int16_t yaw = 0;          // absolute, not a change
    std::int16_t pitch = 0;        // in [-kMaxPitch, kMaxPitch]
    std::int8_t move_right = 0;    // in [-kMaxMove, kMaxMove]; full speed is 127
    std::int8_t move_forward = 0;  // towards where yaw looks
    std::uint16_t buttons = 0;     // Button flags

    bool operator==(const Command&) const = default;
    [[nodiscard]] bool is_held(Button button) const { return (buttons & button) != 0; }
};
static_assert(sizeof(Command) == 8 && std::is_trivially_copyable_v<Command>);
static_assert(std::has_unique_object_representations_v<Command>);

// Whether every field is in its range. A replay that says otherwise is damaged.
[[nodiscard]] bool is_valid(const Command& command);

[[nodiscard]] float yaw_radians(std::int16_t yaw);  // in [-pi, pi)
[[nodiscard]] float pitch_radians(std::int16_t pitch);

// The nearest unit; the angle may be any finite number of turns.
[[nodiscard]] std::int16_t quantise_yaw(float radians);
// The nearest unit, held within 89 degrees.
[[nodiscard]] std::int16_t quantise_pitch(float radians);
// The nearest of 127 steps to either side; `share` of full speed is held within [-1, 1], NaN counts as 0.
[[nodiscard]] std::int8_t quantise_move(float share);

// Unit vector along the line of sight, world frame.
[[nodiscard]] glm::vec3 look_direction(float yaw, float pitch);

}  // namespace gh::input
