#include "audio/voice_choice.h"

#include <algorithm>
#include <cmath>

namespace gh::audio {

float loudness(const Heard& heard) {
    const bool is_placed =
        std::isfinite(heard.position.x) && std::isfinite(heard.position.y) && std::isfinite(heard.position.z);
    float loudest = -1.0f;
    for (const float gain : heard.band_gain) {
        const float level = heard.gain * gain;
        if (!is_placed || !(level >= 0.0f) || !std::isfinite(level)) return -1.0f;
        loudest = std::max(loudest, level);
    }
    return loudest;
}

void choose_voices(std::span<const Heard> heard, std::size_t most, std::vector<Heard>& chosen) {
    chosen.clear();
    for (const Heard& h : heard) {
        if (loudness(h) >= 0.0f) chosen.push_back(h);
    }
    std::stable_sort(chosen.begin(), chosen.end(), [](const Heard& a, const Heard& b) {
        const float la = loudness(a), lb = loudness(b);
        return la > lb || (la == lb && a.voice_key < b.voice_key);
    });
    for (std::size_t i = 0; i < chosen.size() && i < most; ++i) {
        const auto same = [&](const Heard& h) { return h.voice_key == chosen[i].voice_key; };
        chosen.erase(std::remove_if(chosen.begin() + static_cast<std::ptrdiff_t>(i) + 1, chosen.end(), same),
                     chosen.end());
    }
    if (chosen.size() > most) chosen.resize(most);
}

}  // namespace gh::audio
