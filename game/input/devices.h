// input/devices.h - keyboard, mouse and gamepad become one quantised Command a tick.
//
// Threads   the window's thread. Determinism: none here, and none needed: the Command is what is recorded.
#pragma once

#include "input/command.h"

struct GLFWwindow;

namespace gh::input {

struct DeviceSettings {
    float mouse_sensitivity = 1.0f;  // 1: 0.12 degrees a pixel
    bool inverts_y = false;
    bool toggles_crouch = false;
};

// Keys that speak to the program, not to the player's body. True in the one call after the key went down.
struct ProgramKeys {
    bool menu = false;        // Esc
    bool profiler = false;    // F3
    bool next_plane = false;  // F4
    bool fullscreen = false;  // F11
};

class Devices {
  public:
    explicit Devices(GLFWwindow* window);

    // Where the head looks from now on: at the start, and after a checkpoint.
    void look_along(std::int16_t yaw, std::int16_t pitch);

    // What is held now. While not `is_listening` (a menu is open, the cursor is free) only the head's angles stay.
    [[nodiscard]] Command sample(const DeviceSettings& settings, bool is_listening);

    [[nodiscard]] ProgramKeys program_keys();

  private:
    void turn_head(const DeviceSettings& settings);
    void read_gamepad(Command& command);

    GLFWwindow* window_;
    float yaw_ = 0.0f;  // radians, before quantisation, so that slow turns add up
    float pitch_ = 0.0f;
    double cursor_x_ = 0.0;
    double cursor_y_ = 0.0;
    bool knows_cursor_ = false;
    bool is_crouched_ = false;  // when crouch toggles
    bool was_crouch_held_ = false;
    ProgramKeys held_;  // a moment ago
};

}  // namespace gh::input
