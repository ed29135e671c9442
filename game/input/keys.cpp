#include "input/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>

namespace gh::input {

namespace {

struct Named {
    std::string_view word;
    std::int16_t code;
};

constexpr std::array kNamed = {Named{"A", GLFW_KEY_A},
                               Named{"B", GLFW_KEY_B},
                               Named{"C", GLFW_KEY_C},
                               Named{"D", GLFW_KEY_D},
                               Named{"E", GLFW_KEY_E},
                               Named{"F", GLFW_KEY_F},
                               Named{"G", GLFW_KEY_G},
                               Named{"H", GLFW_KEY_H},
                               Named{"I", GLFW_KEY_I},
                               Named{"J", GLFW_KEY_J},
                               Named{"K", GLFW_KEY_K},
                               Named{"L", GLFW_KEY_L},
                               Named{"M", GLFW_KEY_M},
                               Named{"N", GLFW_KEY_N},
                               Named{"O", GLFW_KEY_O},
                               Named{"P", GLFW_KEY_P},
                               Named{"Q", GLFW_KEY_Q},
                               Named{"R", GLFW_KEY_R},
                               Named{"S", GLFW_KEY_S},
                               Named{"T", GLFW_KEY_T},
                               Named{"U", GLFW_KEY_U},
                               Named{"V", GLFW_KEY_V},
                               Named{"W", GLFW_KEY_W},
                               Named{"X", GLFW_KEY_X},
                               Named{"Y", GLFW_KEY_Y},
                               Named{"Z", GLFW_KEY_Z},
                               Named{"0", GLFW_KEY_0},
                               Named{"1", GLFW_KEY_1},
                               Named{"2", GLFW_KEY_2},
                               Named{"3", GLFW_KEY_3},
                               Named{"4", GLFW_KEY_4},
                               Named{"5", GLFW_KEY_5},
                               Named{"6", GLFW_KEY_6},
                               Named{"7", GLFW_KEY_7},
                               Named{"8", GLFW_KEY_8},
                               Named{"9", GLFW_KEY_9},
                               Named{"'", GLFW_KEY_APOSTROPHE},
                               Named{",", GLFW_KEY_COMMA},
                               Named{"-", GLFW_KEY_MINUS},
                               Named{".", GLFW_KEY_PERIOD},
                               Named{"/", GLFW_KEY_SLASH},
                               Named{";", GLFW_KEY_SEMICOLON},
                               Named{"=", GLFW_KEY_EQUAL},
                               Named{"[", GLFW_KEY_LEFT_BRACKET},
                               Named{"\\", GLFW_KEY_BACKSLASH},
                               Named{"]", GLFW_KEY_RIGHT_BRACKET},
                               Named{"`", GLFW_KEY_GRAVE_ACCENT},
                               Named{"World 1", GLFW_KEY_WORLD_1},
                               Named{"World 2", GLFW_KEY_WORLD_2},
                               Named{"Space", GLFW_KEY_SPACE},
                               Named{"Enter", GLFW_KEY_ENTER},
                               Named{"Tab", GLFW_KEY_TAB},
                               Named{"Backspace", GLFW_KEY_BACKSPACE},
                               Named{"Insert", GLFW_KEY_INSERT},
                               Named{"Delete", GLFW_KEY_DELETE},
                               Named{"Right", GLFW_KEY_RIGHT},
                               Named{"Left", GLFW_KEY_LEFT},
                               Named{"Down", GLFW_KEY_DOWN},
                               Named{"Up", GLFW_KEY_UP},
                               Named{"Page Up", GLFW_KEY_PAGE_UP},
                               Named{"Page Down", GLFW_KEY_PAGE_DOWN},
                               Named{"Home", GLFW_KEY_HOME},
                               Named{"End", GLFW_KEY_END},
                               Named{"Caps Lock", GLFW_KEY_CAPS_LOCK},
                               Named{"Scroll Lock", GLFW_KEY_SCROLL_LOCK},
                               Named{"Num Lock", GLFW_KEY_NUM_LOCK},
                               Named{"Print Screen", GLFW_KEY_PRINT_SCREEN},
                               Named{"Pause", GLFW_KEY_PAUSE},
                               Named{"F1", GLFW_KEY_F1},
                               Named{"F2", GLFW_KEY_F2},
                               Named{"F3", GLFW_KEY_F3},
                               Named{"F4", GLFW_KEY_F4},
                               Named{"F5", GLFW_KEY_F5},
                               Named{"F6", GLFW_KEY_F6},
                               Named{"F7", GLFW_KEY_F7},
                               Named{"F8", GLFW_KEY_F8},
                               Named{"F9", GLFW_KEY_F9},
                               Named{"F10", GLFW_KEY_F10},
                               Named{"F11", GLFW_KEY_F11},
                               Named{"F12", GLFW_KEY_F12},
                               Named{"Keypad 0", GLFW_KEY_KP_0},
                               Named{"Keypad 1", GLFW_KEY_KP_1},
                               Named{"Keypad 2", GLFW_KEY_KP_2},
                               Named{"Keypad 3", GLFW_KEY_KP_3},
                               Named{"Keypad 4", GLFW_KEY_KP_4},
                               Named{"Keypad 5", GLFW_KEY_KP_5},
                               Named{"Keypad 6", GLFW_KEY_KP_6},
                               Named{"Keypad 7", GLFW_KEY_KP_7},
                               Named{"Keypad 8", GLFW_KEY_KP_8},
                               Named{"Keypad 9", GLFW_KEY_KP_9},
                               Named{"Keypad .", GLFW_KEY_KP_DECIMAL},
                               Named{"Keypad /", GLFW_KEY_KP_DIVIDE},
                               Named{"Keypad *", GLFW_KEY_KP_MULTIPLY},
                               Named{"Keypad -", GLFW_KEY_KP_SUBTRACT},
                               Named{"Keypad +", GLFW_KEY_KP_ADD},
                               Named{"Keypad Enter", GLFW_KEY_KP_ENTER},
                               Named{"Keypad =", GLFW_KEY_KP_EQUAL},
                               Named{"Shift", GLFW_KEY_LEFT_SHIFT},
                               Named{"Ctrl", GLFW_KEY_LEFT_CONTROL},
                               Named{"Alt", GLFW_KEY_LEFT_ALT},
                               Named{"Super", GLFW_KEY_LEFT_SUPER},
                               Named{"Right Shift", GLFW_KEY_RIGHT_SHIFT},
                               Named{"Right Ctrl", GLFW_KEY_RIGHT_CONTROL},
                               Named{"Right Alt", GLFW_KEY_RIGHT_ALT},
                               Named{"Right Super", GLFW_KEY_RIGHT_SUPER},
                               Named{"Menu", GLFW_KEY_MENU},
                               Named{"left mouse", kFirstMouseButton + 0},
                               Named{"right mouse", kFirstMouseButton + 1},
                               Named{"middle mouse", kFirstMouseButton + 2},
                               Named{"mouse 4", kFirstMouseButton + 3},
                               Named{"mouse 5", kFirstMouseButton + 4},
                               Named{"mouse 6", kFirstMouseButton + 5},
                               Named{"mouse 7", kFirstMouseButton + 6},
                               Named{"mouse 8", kFirstMouseButton + 7}};

constexpr auto kBindable = [] {
    std::array<Key, kNamed.size()> keys;
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = Key{kNamed[i].code};
    return keys;
}();

char lower(char c) {
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool is_same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

bool is_mouse_button(Key key) {
    return kFirstMouseButton <= key.code && key.code < kFirstMouseButton + kMouseButtons;
}

std::string_view word_of(Key key) {
    const auto found = std::find_if(kNamed.begin(), kNamed.end(),
                                    [&](const Named& named) { return named.code == key.code; });
    return found == kNamed.end() ? std::string_view() : found->word;
}

std::optional<Key> key_named(std::string_view word) {
    const auto found = std::find_if(kNamed.begin(), kNamed.end(),
                                    [&](const Named& named) { return is_same_word(named.word, word); });
    if (found == kNamed.end()) return std::nullopt;
    return Key{found->code};
}

std::span<const Key> bindable_keys() {
    return kBindable;
}

}  // namespace gh::input
