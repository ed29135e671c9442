// audio/acoustics.h - from how a sound travels (sense/hearing) to how the mixer plays it.
#pragma once

#include "audio/mixer.h"
#include "audio/soundscape.h"
#include "sense/hearing.h"

namespace gh::audio {

// A sound at its source, as it arrives by `way`: the 1/r law and the walls are in the way's band gains, the
// direction is that of the loudest path. Where nothing is heard the gains are 0.
[[nodiscard]] Heard heard_by(const Source& source, const sense::Transmission& way);

// A sound of no place (room tone, a sting): as loud at the ear as at its source.
[[nodiscard]] Heard heard_everywhere(const Source& source, const Ear& ear);

// Amplitude of `db` over the level at which the file plays as it is; at most kMaxGain.
[[nodiscard]] float gain_from_db(float db);

}  // namespace gh::audio
