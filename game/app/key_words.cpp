#include "app/key_words.h"

namespace gh::app {

KeyWords key_words(const input::Bindings& bindings, const KeyLabel& label) {
    KeyWords words;
    for (std::size_t i = 0; i < input::kActions; ++i) {
        for (const input::Key key : bindings.keys[i]) {
            if (key.is_none()) continue;
            const std::string word = label(key);
            if (words.first[i].empty()) words.first[i] = word;
            words.all[i] += (words.all[i].empty() ? "" : " or ") + word;
        }
        if (!words.first[i].empty()) continue;
        words.first[i] = words.all[i] = "(no key)";
    }
    return words;
}

KeyWords key_words(const input::Bindings& bindings) {
    return key_words(bindings, [](input::Key key) { return std::string(input::word_of(key)); });
}

}  // namespace gh::app
