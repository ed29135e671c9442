// input/keys.h - a key of the keyboard or a button of the mouse, and what it is called.
//
// A keyboard's keys are places, named as a US keyboard has them: a binding stays where the hand knows it when the layout
// changes. What is written on a key here and now is for `Devices::label` to say.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gh::input {

struct Key {
    std::int16_t code = 0;  // GLFW's for a keyboard's, kFirstMouseButton and up for the mouse's; 0: none

    auto operator<=>(const Key&) const = default;
    [[nodiscard]] bool is_none() const { return code == 0; }
};

inline constexpr std::int16_t kFirstMouseButton = 1000;
inline constexpr std::int16_t kMouseButtons = 8;

[[nodiscard]] bool is_mouse_button(Key key);

// "W", "Shift", "Page Up", "left mouse"; empty for none and for keys that nothing can be bound to.
[[nodiscard]] std::string_view word_of(Key key);
// The other way; upper and lower case alike. Nullopt: no key is called that.
[[nodiscard]] std::optional<Key> key_named(std::string_view word);

// Every key that something can be bound to. Escape is none of them: it always opens the menu.
[[nodiscard]] std::span<const Key> bindable_keys();

}  // namespace gh::input
