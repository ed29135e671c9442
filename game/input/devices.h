// input/devices.h - keyboard, mouse and gamepad become one quantised Command a tick.
//
// Threads   the window's thread. Determinism: none here, and none needed: the Command is what is recorded.
#pragma once

#include "input/bindings.h"

#include <string>
#include <vector>

struct GLFWwindow;

namespace gh::input {

struct DeviceSettings {
    float mouse_sensitivity = 1.0f;  // 1: 0.12 degrees a pixel
    bool inverts_y = false;
    bool toggles_crouch = false;
};

// Keys that speak to the program, not to the player's body. True in the one call after the key went down.
struct ProgramKeys {
    bool menu = false;  // Esc, always: a menu that no key opens could not be mended in the menu
    bool profiler = false;
    bool next_plane = false;
    bool fullscreen = false;
};

class Devices {
  public:
    explicit Devices(GLFWwindow* window);

    // Where the head looks from now on: at the start, and after a checkpoint.
    void look_along(std::int16_t yaw, std::int16_t pitch);

    // After a menu: the pointer may be anywhere, and a press that still lasts is no jump, no use and no throw.
    void begin_listening();
    // What is held now.
    [[nodiscard]] Command sample(const DeviceSettings& settings, const Bindings& bindings);

    [[nodiscard]] ProgramKeys program_keys(const Bindings& bindings);

    // The next key or button that goes down, to bind something to it: begin, then ask once a picture.
    void begin_asking();
    [[nodiscard]] Key asked_key();

    // What is written on a key, by the keyboard's layout as it is now.
    [[nodiscard]] static std::string label(Key key);

  private:
    [[nodiscard]] bool is_down(Key key) const;
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
    ActionSet deaf_;    // held since before anybody listened
    ProgramKeys held_;  // a moment ago
    std::vector<Key> down_before_asking_;
};

}  // namespace gh::input
