// app/key_words.h - what prompts and hints call the keys that are bound now.
#pragma once

#include "input/bindings.h"

#include <array>
#include <functional>
#include <string>

namespace gh::app {

using KeyLabel = std::function<std::string(input::Key)>;

struct KeyWords {
    std::array<std::string, input::kActions> first;  // "E"; "(no key)" where none is bound
    std::array<std::string, input::kActions> all;    // "Ctrl or C"

    [[nodiscard]] const std::string& one(input::Action action) const {
        return first[input::index_of(action)];
    }
    [[nodiscard]] const std::string& any(input::Action action) const { return all[input::index_of(action)]; }
};

// `label` says what is written on a key.
[[nodiscard]] KeyWords key_words(const input::Bindings& bindings, const KeyLabel& label);
// By the names the settings file knows.
[[nodiscard]] KeyWords key_words(const input::Bindings& bindings);

}  // namespace gh::app
