// How long rooms ring, and what is heard while one goes from one to the next.
#include "audio/mixer.h"

#include "audio/hall.h"
#include "audio/listening.h"
#include "audio/room_sound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace gh::audio {
namespace {

using test::decibels;
using test::hum_at;
using test::listen;
using test::open_mixer;
using test::Stereo;

using MixerRooms = test::WithEars;

// A stone's click is over; what is left of it between two moments says how long the room rings.
double seconds_to_60_db(Mixer& mixer, const Ear& ear) {
    const Heard click{.sound = {Sound::StoneParquet, 0}, .voice_key = 77, .position = ear.position + glm::vec3(0, 0, -2)};
    std::ignore = listen(mixer, ear, std::span(&click, 1), 36);
    const double early = listen(mixer, ear, {}, 12).rms();
    std::ignore = listen(mixer, ear, {}, 12);
    const double late = listen(mixer, ear, {}, 12).rms();
    return -60.0 * 24.0 / 60.0 / decibels(late / early);
}

RoomSound ringing_for(float seconds) {
    return {.decay = {seconds, seconds, seconds}, .mean_free_path = 4.0f};
}

// Every room rings as long as it says. OpenAL Soft's own decay is 2 to 8 % long, and a window of noise has its spread.
TEST_F(MixerRooms, ARoomRingsAsLongAsItIsSaidTo) {
    for (const float seconds : {0.9f, 1.9f, 3.5f}) {
        Mixer mixer = open_mixer(bank_);
        mixer.set_room(ringing_for(seconds));
        std::ignore = listen(mixer, ear_, {}, kHallFadeTicks + 2);
        EXPECT_NEAR(seconds_to_60_db(mixer, ear_) / static_cast<double>(seconds), 1.0, 0.2) << seconds << " s";
    }
}

// What has no place, as the room's own tone, is dry.
TEST_F(MixerRooms, WhatHasNoPlaceDoesNotRing) {
    Mixer dry = open_mixer(bank_);
    const Heard sting{.sound = {Sound::Switch, 0}, .position = ear_.position};
    std::ignore = listen(dry, ear_, std::span(&sting, 1), static_cast<int>(bank_.ticks(sting.sound)) + 2);
    EXPECT_LT(listen(dry, ear_, {}, 6).rms(), 1e-7);
}

// Through a door and back: each time the room one is in is heard half a second later, also when one turns back half way.
TEST_F(MixerRooms, WalkingFromRoomToRoomChangesHowLongItRings) {
    Mixer mixer = open_mixer(bank_);
    for (const float seconds : {2.5f, 0.9f}) {
        mixer.set_room(ringing_for(seconds));
        std::ignore = listen(mixer, ear_, {}, kHallFadeTicks + 2);
        EXPECT_NEAR(seconds_to_60_db(mixer, ear_) / static_cast<double>(seconds), 1.0, 0.2) << seconds << " s";
        std::ignore = listen(mixer, ear_, {}, 150);  // and dies away
    }
    mixer.set_room(ringing_for(0.9f));
    std::ignore = listen(mixer, ear_, {}, kHallFadeTicks / 2);
    mixer.set_room(ringing_for(2.5f));
    std::ignore = listen(mixer, ear_, {}, 2 * kHallFadeTicks + 4);
    EXPECT_NEAR(seconds_to_60_db(mixer, ear_) / 2.5, 1.0, 0.2);
}

// A lamp hums on while one walks through a door: no step in the sound larger than the hum's own, and at equal power.
TEST_F(MixerRooms, NothingClicksWhenTheRoomChanges) {
    Mixer mixer = open_mixer(bank_);
    const Heard hum = hum_at({0.0f, 1.6f, -1.0f});
    const auto largest_step = [](const Stereo& out) {
        float largest = 0.0f;
        for (std::size_t i = 2; i < out.samples.size(); i += 2) {
            largest = std::max(largest, std::abs(out.samples[i] - out.samples[i - 2]));
        }
        return largest;
    };
    mixer.set_room(ringing_for(2.0f));
    std::ignore = listen(mixer, ear_, std::span(&hum, 1), 120);
    const Stereo before = listen(mixer, ear_, std::span(&hum, 1), 240);
    mixer.set_room(ringing_for(1.9f));
    const Stereo change = listen(mixer, ear_, std::span(&hum, 1), kHallFadeTicks + 30);
    EXPECT_LE(largest_step(change), 1.1f * largest_step(before));
}

}  // namespace
}  // namespace gh::audio
