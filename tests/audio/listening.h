// What the audio tests share: the game's own sounds, a loopback mixer that is run for some ticks, and levels.
#pragma once

#include "audio/mixer.h"
#include "audio/sound_bank.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace gh::audio::test {

inline std::filesystem::path sounds_folder() {
    return std::filesystem::path(GLASSHOUSE_SOURCE_DIR) / "assets" / "sounds";
}

inline SoundBank load_bank() {
    Result<SoundBank> bank = SoundBank::load(sounds_folder());
    if (!bank) throw std::runtime_error(bank.error().sentence);
    return std::move(*bank);
}

inline Mixer open_mixer(const SoundBank& bank, bool hrtf = true) {
    Result<Mixer> mixer = Mixer::open_loopback(bank, hrtf);
    if (!mixer) throw std::runtime_error(mixer.error().sentence);
    return std::move(*mixer);
}

struct Stereo {
    std::vector<float> samples;  // left and right in turn

    [[nodiscard]] double rms(std::size_t side) const {
        double sum = 0.0;
        for (std::size_t i = side; i < samples.size(); i += 2) {
            sum += static_cast<double>(samples[i]) * static_cast<double>(samples[i]);
        }
        return std::sqrt(2.0 * sum / static_cast<double>(samples.size()));
    }
    [[nodiscard]] double rms() const { return std::hypot(rms(0), rms(1)); }
};

// The mixer's output while it hears the same things for some ticks.
inline Stereo listen(Mixer& mixer, const Ear& ear, std::span<const Heard> heard, int ticks) {
    Stereo out;
    std::vector<float> block(2 * kFramesPerTick);
    for (int i = 0; i < ticks; ++i) {
        mixer.tick(ear, heard);
        mixer.render(block);
        out.samples.insert(out.samples.end(), block.begin(), block.end());
    }
    return out;
}

inline double decibels(double ratio) {
    return 20.0 * std::log10(ratio);
}

// Somebody with the game's sounds in his ears, who looks along -z: his left is -x.
class WithEars : public testing::Test {
  protected:
    SoundBank bank_ = load_bank();
    Ear ear_{.position = {0.0f, 1.6f, 0.0f}};
};

// A steady tone to measure with: the hum of a lamp.
inline Heard hum_at(const glm::vec3& position, std::uint32_t key = 1) {
    return {.sound = {Sound::LampHum, 0}, .voice_key = key, .position = position, .loop = true};
}

}  // namespace gh::audio::test
