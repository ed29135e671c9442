#include "input/devices.h"

#include <algorithm>
#include <array>
#include <cmath>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace gh::input {

namespace {

constexpr float kRadiansAPixel = 0.12f * 0.017453293f;
constexpr float kStickTurnRate = 2.6f / 60.0f;  // radians a tick at full deflection
constexpr float kStickDeadZone = 0.18f;
constexpr float kMaxPitchRadians = 1.5533430f;  // 89 degrees

struct Binding {
    int key;
    Button button;
};

constexpr std::array kKeys = {
    Binding{GLFW_KEY_LEFT_SHIFT, Run}, Binding{GLFW_KEY_LEFT_CONTROL, Crouch},
    Binding{GLFW_KEY_C, Crouch},       Binding{GLFW_KEY_SPACE, Jump},
    Binding{GLFW_KEY_Q, LeanLeft},     Binding{GLFW_KEY_R, LeanRight},
    Binding{GLFW_KEY_E, Use},          Binding{GLFW_KEY_F, HandMirror},
    Binding{GLFW_KEY_G, Throw},        Binding{GLFW_KEY_BACKSPACE, Restart},
};

constexpr std::array kPadButtons = {
    Binding{GLFW_GAMEPAD_BUTTON_A, Jump},
    Binding{GLFW_GAMEPAD_BUTTON_B, Crouch},
    Binding{GLFW_GAMEPAD_BUTTON_X, Use},
    Binding{GLFW_GAMEPAD_BUTTON_LEFT_BUMPER, LeanLeft},
    Binding{GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER, LeanRight},
    Binding{GLFW_GAMEPAD_BUTTON_LEFT_THUMB, Run},
    Binding{GLFW_GAMEPAD_BUTTON_BACK, Restart},
};

float beyond_dead_zone(float axis) {
    const float size = std::abs(axis);
    if (size < kStickDeadZone) return 0.0f;
    return std::copysign((size - kStickDeadZone) / (1.0f - kStickDeadZone), axis);
}

}  // namespace

Devices::Devices(GLFWwindow* window) : window_(window) {}

void Devices::look_along(std::int16_t yaw, std::int16_t pitch) {
    yaw_ = yaw_radians(yaw);
    pitch_ = pitch_radians(pitch);
}

void Devices::turn_head(const DeviceSettings& settings) {
    double x = 0.0;
    double y = 0.0;
    glfwGetCursorPos(window_, &x, &y);
    if (knows_cursor_) {
        const float rate = kRadiansAPixel * settings.mouse_sensitivity;
        yaw_ -= static_cast<float>(x - cursor_x_) * rate;
        pitch_ -= static_cast<float>(y - cursor_y_) * rate * (settings.inverts_y ? -1.0f : 1.0f);
    }
    cursor_x_ = x;
    cursor_y_ = y;
    knows_cursor_ = true;
}

void Devices::read_gamepad(Command& command) {
    GLFWgamepadstate pad;
    if (glfwJoystickPresent(GLFW_JOYSTICK_1) == 0 || glfwGetGamepadState(GLFW_JOYSTICK_1, &pad) == 0) return;
    yaw_ -= beyond_dead_zone(pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_X]) * kStickTurnRate;
    pitch_ -= beyond_dead_zone(pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]) * kStickTurnRate;
    const float right = beyond_dead_zone(pad.axes[GLFW_GAMEPAD_AXIS_LEFT_X]);
    const float back = beyond_dead_zone(pad.axes[GLFW_GAMEPAD_AXIS_LEFT_Y]);
    if (right != 0.0f) command.move_right = quantise_move(right);
    if (back != 0.0f) command.move_forward = quantise_move(-back);
    if (pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] > 0.0f) command.buttons |= Throw;
    if (pad.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER] > 0.0f) command.buttons |= HandMirror;
    for (const Binding& binding : kPadButtons) {
        if (pad.buttons[binding.key] == GLFW_PRESS) command.buttons |= binding.button;
    }
}

ProgramKeys Devices::program_keys() {
    const auto is_down = [&](int key) { return glfwGetKey(window_, key) == GLFW_PRESS; };
    const ProgramKeys now{is_down(GLFW_KEY_ESCAPE), is_down(GLFW_KEY_F3), is_down(GLFW_KEY_F4),
                          is_down(GLFW_KEY_F11)};
    const ProgramKeys pressed{now.menu && !held_.menu, now.profiler && !held_.profiler,
                              now.next_plane && !held_.next_plane, now.fullscreen && !held_.fullscreen};
    held_ = now;
    return pressed;
}

Command Devices::sample(const DeviceSettings& settings, bool is_listening) {
    Command command;
    if (is_listening) {
        turn_head(settings);
        const auto is_down = [&](int key) { return glfwGetKey(window_, key) == GLFW_PRESS; };
        const int right = (is_down(GLFW_KEY_D) || is_down(GLFW_KEY_RIGHT)) -
                          (is_down(GLFW_KEY_A) || is_down(GLFW_KEY_LEFT));
        const int forward =
            (is_down(GLFW_KEY_W) || is_down(GLFW_KEY_UP)) - (is_down(GLFW_KEY_S) || is_down(GLFW_KEY_DOWN));
        command.move_right = static_cast<std::int8_t>(right * kMaxMove);
        command.move_forward = static_cast<std::int8_t>(forward * kMaxMove);
        for (const Binding& binding : kKeys) {
            if (is_down(binding.key)) command.buttons |= binding.button;
        }
        if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) command.buttons |= Throw;
        if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS) command.buttons |= Cancel;
        read_gamepad(command);
    } else {
        knows_cursor_ = false;  // the pointer may come back anywhere
    }

    const bool is_crouch_held = command.is_held(Crouch);
    if (settings.toggles_crouch) {
        if (is_crouch_held && !was_crouch_held_) is_crouched_ = !is_crouched_;
        command.buttons =
            static_cast<std::uint16_t>(is_crouched_ ? command.buttons | Crouch : command.buttons & ~Crouch);
    }
    was_crouch_held_ = is_crouch_held;

    pitch_ = std::clamp(pitch_, -kMaxPitchRadians, kMaxPitchRadians);
    command.yaw = quantise_yaw(yaw_);
    command.pitch = quantise_pitch(pitch_);
    return command;
}

}  // namespace gh::input
