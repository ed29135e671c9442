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

struct PadBinding {
    int key;
    Button button;
};

constexpr std::array kPadButtons = {
    PadBinding{GLFW_GAMEPAD_BUTTON_A, Jump},
    PadBinding{GLFW_GAMEPAD_BUTTON_B, Crouch},
    PadBinding{GLFW_GAMEPAD_BUTTON_X, Use},
    PadBinding{GLFW_GAMEPAD_BUTTON_LEFT_BUMPER, LeanLeft},
    PadBinding{GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER, LeanRight},
    PadBinding{GLFW_GAMEPAD_BUTTON_LEFT_THUMB, Run},
    PadBinding{GLFW_GAMEPAD_BUTTON_BACK, Restart},
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
    for (const PadBinding& binding : kPadButtons) {
        if (pad.buttons[binding.key] == GLFW_PRESS) command.buttons |= binding.button;
    }
}

bool Devices::is_down(Key key) const {
    if (is_mouse_button(key)) return glfwGetMouseButton(window_, key.code - kFirstMouseButton) == GLFW_PRESS;
    return glfwGetKey(window_, key.code) == GLFW_PRESS;
}

ProgramKeys Devices::program_keys(const Bindings& bindings) {
    // No other keys: to look at one whose tap is over already is to forget the tap, and the next tick wants it.
    const auto is_acting = [&](Action action) {
        const auto& keys = bindings.of(action);
        return std::any_of(keys.begin(), keys.end(), [&](Key key) { return !key.is_none() && is_down(key); });
    };
    const ProgramKeys now{glfwGetKey(window_, GLFW_KEY_ESCAPE) == GLFW_PRESS, is_acting(Action::Profiler),
                          is_acting(Action::Planes), is_acting(Action::FullScreen)};
    const ProgramKeys pressed{now.menu && !held_.menu, now.profiler && !held_.profiler,
                              now.next_plane && !held_.next_plane, now.fullscreen && !held_.fullscreen};
    held_ = now;
    return pressed;
}

void Devices::begin_asking() {
    down_before_asking_.clear();
    for (const Key key : bindable_keys()) {
        if (is_down(key)) down_before_asking_.push_back(key);
    }
}

Key Devices::asked_key() {
    for (const Key key : bindable_keys()) {
        const auto before = std::find(down_before_asking_.begin(), down_before_asking_.end(), key);
        if (!is_down(key)) {
            if (before != down_before_asking_.end()) down_before_asking_.erase(before);
        } else if (before == down_before_asking_.end()) {
            return key;
        }
    }
    return Key{};
}

std::string Devices::label(Key key) {
    std::string word(word_of(key));
    // Letters and signs lie elsewhere on other keyboards; what is not Latin has Latin beside it on the key.
    if (key.code <= GLFW_KEY_SPACE || key.code > GLFW_KEY_WORLD_2) return word;
    const char* const name = glfwGetKeyName(key.code, 0);
    if (name == nullptr || name[0] == '\0') return word;
    const auto first = static_cast<unsigned char>(name[0]);
    if (name[1] == '\0' && 'a' <= first && first <= 'z') return std::string(1, static_cast<char>(first - 32));
    const bool is_ascii = first < 0x80 && name[1] == '\0';
    const bool is_latin_1 = (first == 0xC2 || first == 0xC3) && name[1] != '\0' && name[2] == '\0';
    return is_ascii || is_latin_1 ? std::string(name) : word;
}

void Devices::begin_listening() {
    knows_cursor_ = false;
    deaf_.reset();
    for (const Action action :
         {Action::Jump, Action::Use, Action::Throw, Action::PutBack, Action::Checkpoint})
        deaf_.set(index_of(action));
}

Command Devices::sample(const DeviceSettings& settings, const Bindings& bindings) {
    Command command;
    turn_head(settings);
    const ActionSet held = held_actions(bindings, [&](Key key) { return is_down(key); });
    deaf_ &= held;
    put_actions(held & ~deaf_, command);
    read_gamepad(command);

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
