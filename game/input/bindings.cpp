#include "input/bindings.h"

#include "base/contracts.h"

#include <algorithm>
#include <utility>

namespace gh::input {

namespace {

struct ActionRow {
    std::string_view word;
    std::string_view title;
    std::string_view first;  // keys, at first
    std::string_view second;
    std::uint16_t buttons;  // of the Command
};

// In the order of Action.
constexpr std::array<ActionRow, kActions> kActionRows = {{
    {"walk_forward", "walk forward", "W", "Up", 0},
    {"walk_back", "walk back", "S", "Down", 0},
    {"walk_left", "step left", "A", "Left", 0},
    {"walk_right", "step right", "D", "Right", 0},
    {"run", "run (loud)", "Shift", "", Run},
    {"crouch", "crouch (quiet)", "Ctrl", "C", Crouch},
    {"jump", "jump", "Space", "", Jump},
    {"lean_left", "lean left", "Q", "", LeanLeft},
    {"lean_right", "lean right", "R", "", LeanRight},
    {"use", "use: doors, lamps, lens", "E", "", Use},
    {"hand_mirror", "hold up the mirror", "F", "", HandMirror},
    {"throw", "aim a stone, and throw", "left mouse", "G", Throw},
    {"put_back", "put the stone back", "right mouse", "", Cancel},
    {"checkpoint", "back to the checkpoint", "Backspace", "", Restart},
    {"full_screen", "full screen", "F11", "", 0},
    {"profiler", "profiler", "F3", "", 0},
    {"planes", "what the renderer sees", "F4", "", 0},
}};

}  // namespace

std::string_view word_of(Action action) {
    return kActionRows[index_of(action)].word;
}

std::string_view title_of(Action action) {
    return kActionRows[index_of(action)].title;
}

Bindings default_bindings() {
    Bindings bindings;
    for (std::size_t i = 0; i < kActions; ++i) {
        bindings.keys[i] = {key_named(kActionRows[i].first).value_or(Key{}),
                            key_named(kActionRows[i].second).value_or(Key{})};
    }
    return bindings;
}

std::optional<KeySlot> slot_of(const Bindings& bindings, Key key) {
    if (key.is_none()) return std::nullopt;
    for (std::size_t i = 0; i < kActions; ++i) {
        const auto found = std::find(bindings.keys[i].begin(), bindings.keys[i].end(), key);
        if (found == bindings.keys[i].end()) continue;
        return KeySlot{static_cast<Action>(i), static_cast<std::size_t>(found - bindings.keys[i].begin())};
    }
    return std::nullopt;
}

std::optional<KeySlot> bind(Bindings& bindings, KeySlot slot, Key key) {
    EXPECTS(slot.place < kKeysAnAction);
    EXPECTS(key.is_none() || !word_of(key).empty());
    const std::optional<KeySlot> owner = slot_of(bindings, key);
    const Key before = std::exchange(bindings.keys[index_of(slot.action)][slot.place], key);
    if (!owner || *owner == slot) return std::nullopt;
    bindings.keys[index_of(owner->action)][owner->place] = before;
    return owner;
}

ActionSet held_actions(const Bindings& bindings, const std::function<bool(Key)>& is_down) {
    ActionSet held;
    for (std::size_t i = 0; i < kActions; ++i) {
        held[i] = std::any_of(bindings.keys[i].begin(), bindings.keys[i].end(),
                              [&](Key key) { return !key.is_none() && is_down(key); });
    }
    return held;
}

void put_actions(const ActionSet& held, Command& command) {
    const auto is_held = [&](Action action) { return held[index_of(action)] ? 1 : 0; };
    command.move_right =
        static_cast<std::int8_t>((is_held(Action::WalkRight) - is_held(Action::WalkLeft)) * kMaxMove);
    command.move_forward =
        static_cast<std::int8_t>((is_held(Action::WalkForward) - is_held(Action::WalkBack)) * kMaxMove);
    for (std::size_t i = 0; i < kActions; ++i) {
        if (held[i]) command.buttons = static_cast<std::uint16_t>(command.buttons | kActionRows[i].buttons);
    }
}

}  // namespace gh::input
