#include "audio/mixer.h"

#include "audio/acoustics.h"
#include "audio/listening.h"
#include "base/hash.h"

#include "raycore/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gh::audio {
namespace {

using test::decibels;
using test::hum_at;
using test::listen;
using test::open_mixer;
using test::Stereo;

using MixerTest = test::WithEars;

// A busy minute of the game, scaled down: a guard walks round the player, stones fall, a lamp hums, and the
// player turns his head.
std::uint64_t hash_of_a_walk(const SoundBank& bank) {
    Mixer mixer = open_mixer(bank);
    std::vector<float> block(2 * kFramesPerTick);
    Hasher hasher;
    for (std::uint32_t tick = 0; tick < 90; ++tick) {
        const float angle = 0.07f * static_cast<float>(tick);
        const Ear ear{.position = {0.0f, 1.6f, 0.0f}, .forward = {std::sin(angle), 0.0f, -std::cos(angle)}};
        std::vector<Heard> heard = {hum_at({2.0f, 2.0f, -1.0f})};
        for (std::uint32_t step = 0; step * 30 <= tick; ++step) {
            heard.push_back({.sound = {Sound::BootMarble, static_cast<std::uint8_t>(step % 4)},
                             .voice_key = 100 + step,
                             .position = {3.0f * std::cos(angle), 0.0f, 3.0f * std::sin(angle)},
                             .gain = 0.5f,
                             .band_gain = {0.5f, 0.3f, 0.1f}});
        }
        if (tick >= 40)
            heard.push_back({.sound = {Sound::StoneGlass, 1}, .voice_key = 9, .position = {-1, 0, -4}});
        mixer.tick(ear, heard);
        mixer.render(block);
        for (const float x : block) hasher.add(x);
    }
    return hasher.digest();
}

// The sound of a replay is part of its film: the same ticks, the same bits.
TEST_F(MixerTest, ALoopbackRendersTheSameBitsEveryTime) {
    const std::uint64_t first = hash_of_a_walk(bank_);
    EXPECT_EQ(hex16(hash_of_a_walk(bank_)), hex16(first));
    EXPECT_EQ(hex16(hash_of_a_walk(bank_)), hex16(first));
}

TEST_F(MixerTest, NothingHeardIsSilence) {
    Mixer mixer = open_mixer(bank_);
    EXPECT_EQ(listen(mixer, ear_, {}, 5).rms(), 0.0);
}

// A guard to the left must be heard on the left. A head shadows 2 kHz and more by several dB.
TEST_F(MixerTest, WhatIsLeftIsLouderInTheLeftEar) {
    for (const float side : {-1.0f, 1.0f}) {
        for (const bool hrtf : {true, false}) {
            Mixer mixer = open_mixer(bank_, hrtf);
            const Heard step{.sound = {Sound::BootGlass, 0}, .position = {3.0f * side, 1.6f, 0.0f}};
            const Stereo out = listen(mixer, ear_, std::span(&step, 1), 20);
            const double left_over_right = decibels(out.rms(0) / std::max(out.rms(1), 1e-9));
            EXPECT_GT(static_cast<double>(-side) * left_over_right, 4.0)
                << "hrtf " << hrtf << ", side " << side;
        }
    }
}

// And it stays there when the player turns round: his left is then the world's right.
TEST_F(MixerTest, TurningTheHeadTurnsTheWorldOfSound) {
    Mixer mixer = open_mixer(bank_);
    const Ear turned{.position = ear_.position, .forward = {0.0f, 0.0f, 1.0f}};
    const Heard step{.sound = {Sound::BootGlass, 0}, .position = {-3.0f, 1.6f, 0.0f}};
    const Stereo out = listen(mixer, turned, std::span(&step, 1), 20);
    EXPECT_GT(decibels(out.rms(1) / out.rms(0)), 4.0);
}

// One law for guards and player: sense gives 1/r, and the mixer adds nothing of its own. The tolerance is that of
// float gains; HRTF changes with direction, which stays the same here.
TEST_F(MixerTest, LoudnessFallsAsOneOverDistance) {
    const auto scene = rc::SceneBuilder().commit();
    const world::Level level;
    for (const bool hrtf : {false, true}) {
        double at_one_metre = 0.0;
        for (const float metres : {1.0f, 2.0f, 5.0f, 20.0f}) {
            const Source lamp{.sound = {Sound::LampHum, 0},
                              .position = ear_.position + glm::vec3(0.6f, 0.0f, -0.8f) * metres,
                              .loops = true};
            const Heard heard = heard_by(lamp, sense::hear(level, *scene, lamp.position, ear_.position));
            Mixer mixer = open_mixer(bank_, hrtf);
            const double rms = listen(mixer, ear_, std::span(&heard, 1), 30).rms();
            if (metres == 1.0f) at_one_metre = rms;
            EXPECT_NEAR(decibels(rms / at_one_metre), -decibels(static_cast<double>(metres)), 0.5)
                << metres << " m";
        }
    }
}

// Far from the level's origin floats are coarse; directions are taken relative to the ear before OpenAL sees them.
TEST_F(MixerTest, AnEarFarFromTheOriginHearsTheSame) {
    const glm::vec3 far(4096.0f, 0.0f, -8192.0f);
    const Heard near_step{.sound = {Sound::BootMarble, 0}, .position = {-2.0f, 1.5f, -1.0f}};
    Heard far_step = near_step;
    far_step.position += far;
    Ear near_ear{.position = {0.0f, 1.5f, 0.0f}};
    Ear far_ear{.position = near_ear.position + far};
    Mixer a = open_mixer(bank_), b = open_mixer(bank_);
    EXPECT_EQ(listen(a, near_ear, std::span(&near_step, 1), 10).samples,
              listen(b, far_ear, std::span(&far_step, 1), 10).samples);
}

double energy_of_highs(std::span<const float> samples) {
    const Bands bands = split_bands(samples, false);
    double sum = 0.0;
    for (const float x : bands[2]) sum += static_cast<double>(x) * static_cast<double>(x);
    return sum;
}

std::vector<float> left_of(const Stereo& out) {
    std::vector<float> left;
    for (std::size_t i = 0; i < out.samples.size(); i += 2) left.push_back(out.samples[i]);
    return left;
}

// A stone behind a brick wall thuds: of 46, 58 and 70 dB the highs lose 24 dB more than the lows. How much of that
// is heard over 2 kHz follows from the recording's own bands; plain panning adds a constant, which cancels.
TEST_F(MixerTest, AWallTakesTheHighsFirst) {
    const auto& loss_db = world::acoustics(world::Surface::Plaster).transmission_loss_db;
    const Heard open{.sound = {Sound::StoneGlass, 0}, .position = {0.0f, 1.6f, -3.0f}};
    Heard muffled = open;
    for (std::size_t b = 0; b < world::kBands; ++b)
        muffled.band_gain[b] = gain_from_db(loss_db[0] - loss_db[b]);

    constexpr int kTicks = 30;
    const Recording& recording = bank_[open.sound];
    std::vector<float> whole(kTicks * kFramesPerTick), behind_wall(kTicks * kFramesPerTick);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        for (std::size_t b = 0; b < world::kBands; ++b) {
            whole[i] += recording.bands[b][i];
            behind_wall[i] += recording.bands[b][i] * muffled.band_gain[b];
        }
    }
    Mixer a = open_mixer(bank_, false), b = open_mixer(bank_, false);
    const double heard = energy_of_highs(left_of(listen(b, ear_, std::span(&muffled, 1), kTicks))) /
                         energy_of_highs(left_of(listen(a, ear_, std::span(&open, 1), kTicks)));
    const double computed = energy_of_highs(behind_wall) / energy_of_highs(whole);
    EXPECT_NEAR(10.0 * std::log10(heard), 10.0 * std::log10(computed), 0.1);
    EXPECT_LT(10.0 * std::log10(heard), -15.0);
}

// With all bands at 1 a voice is the file: through plain stereo straight ahead, both ears get it alike, and the
// three sources that carry it start on the same sample.
TEST_F(MixerTest, ThreeBandsTogetherAreTheSoundAsItWasMade) {
    Mixer mixer = open_mixer(bank_, false);
    const Heard step{.sound = {Sound::StoneMarble, 0}, .position = {0.0f, 1.6f, -1.0f}};
    const Stereo out = listen(mixer, ear_, std::span(&step, 1), 10);
    const Recording& recording = bank_[step.sound];
    // Best fit of the output to the recording, for the panning's own constant gain.
    double xy = 0.0, xx = 0.0, yy = 0.0;
    for (std::size_t i = 0; i < 10 * kFramesPerTick; ++i) {
        const double x = static_cast<double>(recording.bands[0][i]) +
                         static_cast<double>(recording.bands[1][i]) +
                         static_cast<double>(recording.bands[2][i]);
        const auto y = static_cast<double>(out.samples[2 * i]);
        xy += x * y;
        xx += x * x;
        yy += y * y;
    }
    EXPECT_GT(xy / std::sqrt(xx * yy), 0.9999);
}

TEST_F(MixerTest, ThePauseMenuIsSilentAndNothingIsLost) {
    Mixer a = open_mixer(bank_), b = open_mixer(bank_);
    const Heard step{.sound = {Sound::StoneMetal, 0}, .position = {1.0f, 1.0f, -1.0f}};
    EXPECT_EQ(listen(a, ear_, std::span(&step, 1), 3).samples,
              listen(b, ear_, std::span(&step, 1), 3).samples);
    a.set_paused(true);
    std::vector<float> block(2 * kFramesPerTick, 1.0f);
    a.render(block);
    EXPECT_EQ(*std::max_element(block.begin(), block.end()), 0.0f);
    a.set_paused(false);
    EXPECT_EQ(listen(a, ear_, std::span(&step, 1), 3).samples,
              listen(b, ear_, std::span(&step, 1), 3).samples);
}

TEST_F(MixerTest, HalfTheVolumeIsHalfTheAmplitude) {
    Mixer mixer = open_mixer(bank_);
    const Heard hum = hum_at({0.0f, 1.6f, -1.0f});
    std::ignore = listen(mixer, ear_, std::span(&hum, 1), 20);
    const double full = listen(mixer, ear_, std::span(&hum, 1), 60).rms();
    mixer.set_volume(0.5f);
    std::ignore =
        listen(mixer, ear_, std::span(&hum, 1), 180);  // the loop is 240 ticks long: compare like with like
    EXPECT_NEAR(listen(mixer, ear_, std::span(&hum, 1), 60).rms() / full, 0.5, 0.01);
}

TEST_F(MixerTest, VolumeEndsWhereItIsSaidToEnd) {
    Mixer mixer = open_mixer(bank_);
    const Heard hum = hum_at({0.0f, 1.6f, -1.0f});
    std::ignore = listen(mixer, ear_, std::span(&hum, 1), 20);
    const double as_made = listen(mixer, ear_, std::span(&hum, 1), 60).rms();
    mixer.set_volume(1e9f);
    std::ignore = listen(mixer, ear_, std::span(&hum, 1), 180);
    EXPECT_NEAR(listen(mixer, ear_, std::span(&hum, 1), 60).rms() / as_made, kMostVolume, 0.04);
}

TEST_F(MixerTest, ASoundFromNowhereIsNotPlayed) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    Mixer mixer = open_mixer(bank_);
    std::vector<Heard> heard = {hum_at({kNan, 0.0f, 0.0f}, 1), hum_at({1.0f, 0.0f, 0.0f}, 2)};
    heard[1].gain = kNan;
    EXPECT_EQ(listen(mixer, ear_, heard, 3).rms(), 0.0);
    EXPECT_EQ(mixer.voices(), 0u);
}

// A machine without a sound card plays on in silence and says so; one with a card opens it.
TEST_F(MixerTest, NoDeviceIsASentence) {
    const Result<Mixer> mixer = Mixer::open_device(bank_);
    if (!mixer) {
        EXPECT_NE(mixer.error().sentence.find("silently"), std::string::npos) << mixer.error().sentence;
    }
}

}  // namespace
}  // namespace gh::audio
