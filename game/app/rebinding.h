// app/rebinding.h - changing what keys do: asks for a key, exchanges it with whoever has it, says what came of it.
//
// Knows no device: keys are told to it, so that all of it can be tried without a window.
#pragma once

#include "app/key_words.h"
#include "present/menu.h"

#include <optional>
#include <string>

namespace gh::app {

class Rebinding {
  public:
    void ask_for(input::KeySlot slot);
    void cancel();
    [[nodiscard]] bool is_waiting() const { return waiting_.has_value(); }

    // The key that was asked for.
    void take(input::Key key, input::Bindings& bindings, const KeyLabel& label);
    void remove(input::KeySlot slot, input::Bindings& bindings, const KeyLabel& label);
    void restore_defaults(input::Bindings& bindings);
    void forget_words() { said_.clear(); }

    // Rows in the order of input::Action.
    [[nodiscard]] present::ControlsPage page(const input::Bindings& bindings, const KeyLabel& label) const;

  private:
    void say(std::string words, bool is_warning);

    std::optional<input::KeySlot> waiting_;
    std::string said_;
    bool is_warning_ = false;
};

}  // namespace gh::app
