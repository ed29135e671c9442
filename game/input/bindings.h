// input/bindings.h - which keys mean what: two an action, no key to two actions.
//
// Bindings end here: what comes out is a Command, and a Command is what is recorded. A recording plays the same whoever
// watches it and whatever keys he has.
#pragma once

#include "input/command.h"
#include "input/keys.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <functional>
#include <optional>

namespace gh::input {

enum class Action : std::uint8_t {
    WalkForward,
    WalkBack,
    WalkLeft,
    WalkRight,
    Run,
    Crouch,
    Jump,
    LeanLeft,
    LeanRight,
    Use,
    HandMirror,
    Throw,
    PutBack,
    Checkpoint,
    FullScreen,  // from here on they speak to the program, not to the player's body
    Profiler,
    Planes,
};
inline constexpr std::size_t kActions = 17;
inline constexpr std::size_t kKeysAnAction = 2;

using ActionSet = std::bitset<kActions>;

[[nodiscard]] constexpr std::size_t index_of(Action action) {
    return static_cast<std::size_t>(action);
}

// "walk_forward": what the settings file calls it. "walk forward": what the menu does.
[[nodiscard]] std::string_view word_of(Action action);
[[nodiscard]] std::string_view title_of(Action action);

struct Bindings {
    std::array<std::array<Key, kKeysAnAction>, kActions> keys{};

    bool operator==(const Bindings&) const = default;
    [[nodiscard]] const std::array<Key, kKeysAnAction>& of(Action action) const {
        return keys[index_of(action)];
    }
};

[[nodiscard]] Bindings default_bindings();

struct KeySlot {
    Action action = Action::WalkForward;
    std::size_t place = 0;  // below kKeysAnAction

    bool operator==(const KeySlot&) const = default;
};

// Where a key lies; nullopt when it is free.
[[nodiscard]] std::optional<KeySlot> slot_of(const Bindings& bindings, Key key);

// Puts a key into a slot; no key empties it. Who had the key gets what lay in the slot, and is returned.
std::optional<KeySlot> bind(Bindings& bindings, KeySlot slot, Key key);

// What is being done by the keys that are down.
[[nodiscard]] ActionSet held_actions(const Bindings& bindings, const std::function<bool(Key)>& is_down);

// The steps and buttons of a Command; its angles are none of a key's business.
void put_actions(const ActionSet& held, Command& command);

}  // namespace gh::input
