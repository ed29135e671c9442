// Which of the things that sound at once are heard, from when and until when.
#include "audio/mixer.h"

#include "audio/listening.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace gh::audio {
namespace {

using test::hum_at;
using test::listen;
using test::open_mixer;
using test::Stereo;

using MixerVoices = test::WithEars;

// Forty things sound at once; the loudest are heard and no more than may be.
TEST_F(MixerVoices, StealingNeverExceedsTheLimit) {
    Mixer mixer = open_mixer(bank_);
    std::vector<float> block(2 * kFramesPerTick);
    for (std::uint32_t tick = 0; tick < 40; ++tick) {
        std::vector<Heard> heard;
        for (std::uint32_t i = 0; i < 40; ++i) {
            Heard h = hum_at({1.0f, 1.0f, static_cast<float>(i)}, (i * 7 + tick * 3) % 200);
            h.gain = 0.01f + 0.001f * static_cast<float>((i * 13 + tick * 5) % 40);
            h.loop = i % 3 != 0;
            heard.push_back(h);
        }
        mixer.tick(ear_, heard);
        mixer.render(block);
        EXPECT_LE(mixer.voices(), kMaxVoices + kMaxFading);
        EXPECT_GE(mixer.voices(), kMaxVoices);
        for (const float x : block) ASSERT_TRUE(std::isfinite(x));
    }
}

// A distant step that no voice was free for must not be heard a second late, when the noise has died down.
TEST_F(MixerVoices, AStepThatFoundNoVoiceDoesNotComeLate) {
    Mixer mixer = open_mixer(bank_, false);
    std::vector<Heard> crowd;
    for (std::uint32_t i = 0; i < kMaxVoices; ++i) crowd.push_back(hum_at({1.0f, 1.0f, -1.0f}, 100 + i));
    crowd.push_back(
        {.sound = {Sound::BootMarble, 0}, .voice_key = 7, .position = {0.0f, 0.0f, -2.0f}, .gain = 0.5f});
    std::ignore = listen(mixer, ear_, crowd, 4);
    const std::vector<Heard> step = {crowd.back()};
    std::ignore = listen(mixer, ear_, step, 12);
    EXPECT_EQ(mixer.voices(), 0u);
    // And one that is pushed out half way does not begin again.
    std::ignore = listen(mixer, ear_, {}, 1);
    std::ignore = listen(mixer, ear_, step, 3);
    EXPECT_EQ(mixer.voices(), 1u);
    std::ignore = listen(mixer, ear_, crowd, 6);
    std::ignore = listen(mixer, ear_, step, 12);
    EXPECT_EQ(mixer.voices(), 0u);
}

// A sound that rang out is over, though its noise is still named; the next noise has another key.
TEST_F(MixerVoices, ASoundIsPlayedOnce) {
    Mixer mixer = open_mixer(bank_, false);
    const Heard click{.sound = {Sound::Switch, 0}, .voice_key = 5, .position = {0.0f, 1.6f, -1.0f}};
    const int length = static_cast<int>(bank_.ticks(click.sound));
    EXPECT_GT(listen(mixer, ear_, std::span(&click, 1), length + 4).rms(), 1e-5);
    EXPECT_EQ(mixer.voices(), 0u);
    EXPECT_LT(listen(mixer, ear_, std::span(&click, 1), 20).rms(), 1e-7);
    // Named anew after a silence, it sounds anew.
    std::ignore = listen(mixer, ear_, {}, 1);
    EXPECT_GT(listen(mixer, ear_, std::span(&click, 1), 4).rms(), 1e-5);
}

// A lamp switched off: its hum is gone within a fifth of a second, and without a step in between.
TEST_F(MixerVoices, ALoopFadesWhenItIsNoLongerNamed) {
    Mixer mixer = open_mixer(bank_, false);
    const Heard hum = hum_at({0.0f, 1.6f, -1.0f});
    const Stereo before = listen(mixer, ear_, std::span(&hum, 1), 30);
    const Stereo after = listen(mixer, ear_, {}, 12);
    EXPECT_EQ(mixer.voices(), 0u);
    float largest = 0.0f, fading = 0.0f;
    for (std::size_t i = before.samples.size() / 2 + 2; i < before.samples.size(); i += 2) {
        largest = std::max(largest, std::abs(before.samples[i] - before.samples[i - 2]));
    }
    for (std::size_t i = 2; i < after.samples.size(); i += 2) {
        fading = std::max(fading, std::abs(after.samples[i] - after.samples[i - 2]));
    }
    EXPECT_LE(fading, largest * 1.02f);
    EXPECT_EQ(after.samples.back(), 0.0f);
}

}  // namespace
}  // namespace gh::audio
