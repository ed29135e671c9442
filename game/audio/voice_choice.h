// audio/voice_choice.h - who is heard when more sounds than voices.
#pragma once

#include "audio/mixer.h"

#include <cstddef>
#include <span>
#include <vector>

namespace gh::audio {

// How much of a sound reaches the ear: its loudest band. Not a finite number: -1, and it is never chosen.
[[nodiscard]] float loudness(const Heard& heard);

// The `most` loudest of `heard`, loudest first, equally loud: the lower key first. Of a key named twice the
// loudest counts.
void choose_voices(std::span<const Heard> heard, std::size_t most, std::vector<Heard>& chosen);

}  // namespace gh::audio
