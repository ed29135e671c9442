// app/hint_words.h - the sentence for each lesson, with the level's own names and the keys that are bound now.
#pragma once

#include "app/hints.h"
#include "app/key_words.h"

namespace gh::app {

[[nodiscard]] std::string words_for(Lesson lesson, const world::Level& level, const KeyWords& keys);

}  // namespace gh::app
