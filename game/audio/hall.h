// audio/hall.h - the stone house that every sound rings in: one EAX reverb, set once and never touched again.
//
// OpenAL Soft clicks when an audible reverb changes (and its decay errs by 2 to 8 %), so there is one hall for the
// whole museum until rooms crossfade between several. Private to the mixer; needs a current context.
#pragma once

#include <AL/al.h>

namespace gh::audio {

inline constexpr float kHallDecay = 1.9f;  // seconds to fall by 60 dB

// The effect slot that sources send to, or 0 where the library has no EFX: then the house is dry.
[[nodiscard]] ALuint make_hall();

}  // namespace gh::audio
