#include "audio/acoustics.h"

#include "base/det_math.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace gh::audio {

float gain_from_db(float db) {
    return std::min(det::exp2(db * (1.0f / 6.0206f)), kMaxGain);
}

Heard heard_by(const Source& source, const sense::Transmission& way) {
    return {.sound = source.sound,
            .voice_key = source.key,
            .position = way.arrives_from,
            .gain = source.gain,
            .band_gain = way.band_gain,
            .loop = source.loops};
}

Heard heard_everywhere(const Source& source, const Ear& ear) {
    return {.sound = source.sound,
            .voice_key = source.key,
            .position = ear.position,
            .gain = source.gain,
            .loop = source.loops};
}

}  // namespace gh::audio
