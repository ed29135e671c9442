// app/noise_words.h - what is heard, in words for who can not hear it.
#pragma once

#include "world/state.h"

#include <string>

namespace gh::app {

// What a noise is to a listener: "a stone clatters on marble"; empty for the player's own steps.
[[nodiscard]] std::string caption_of(const world::Noise& noise);

// What makes it, if one line is enough for all its noises: a stone clatters down a stair, a guard walks from carpet to
// marble or finds other words. Empty: every noise has a line of its own.
[[nodiscard]] std::string subject_of(const world::Noise& noise);

}  // namespace gh::app
