// audio/ceiling.h - keeps what is mixed below what a speaker can do, without an audible edge.
//
// Cost      a division for a sample above the knee, a comparison for the rest. Same bits no libm.
// Bad input NaN is silence, infinity the ceiling.
#pragma once

namespace gh::audio {

inline constexpr float kKnee = 0.8f;  // quieter samples stay as they are

// Odd, rising, and never 1 or more; its slope is 1 up to the knee and falls without a step from there.
[[nodiscard]] constexpr float under_ceiling(float sample) {
    const float size = sample < 0.0f ? -sample : sample;
    if (size <= kKnee) return sample;
    if (!(size > kKnee)) return 0.0f;
    constexpr float kRoom = 0.999f - kKnee;
    const float over = (size - kKnee) / kRoom;
    const float bent = over < 1e6f ? kKnee + kRoom * (over / (1.0f + over)) : kKnee + kRoom;
    return sample < 0.0f ? -bent : bent;
}

}  // namespace gh::audio
