#include "audio/soundscape.h"

#include "audio/acoustics.h"
#include "audio/foley.h"
#include "audio/listening.h"

#include "sense/hearing.h"
#include "support/rest_scene.h"
#include "support/small_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace gh::audio {
namespace {

class SoundscapeTest : public testing::Test {
  protected:
    // The sources of the next tick.
    std::vector<Source> next() {
        ++state_.tick;
        const auto listed = soundscape_.sources(level_, state_, ear_);
        state_.noise_count = 0;
        return {listed.begin(), listed.end()};
    }
    void emit(world::NoiseKind kind, world::Surface surface, float loudness_db = 50.0f) {
        world::Noise& noise = state_.noises[state_.noise_count++];
        noise = {};
        noise.kind = kind;
        noise.surface = static_cast<std::uint8_t>(surface);
        noise.loudness_db = loudness_db;
        noise.position = {1.0f, 0.0f, 2.0f};
    }
    static std::size_t count_of(const std::vector<Source>& sources, Sound sound) {
        return static_cast<std::size_t>(std::count_if(
            sources.begin(), sources.end(), [&](const Source& s) { return s.sound.sound == sound; }));
    }
    static world::Lamp lamp_at(float x) {
        world::Lamp lamp;
        lamp.position = {x, 2.0f, 0.0f};
        return lamp;
    }

    SoundBank bank_ = test::load_bank();
    Soundscape soundscape_{bank_};
    world::Level level_;
    world::State state_{};
    glm::vec3 ear_{0.0f};
};

TEST_F(SoundscapeTest, ANoiseOfOneTickRingsUntilItsSoundIsOver) {
    emit(world::NoiseKind::Switch, world::Surface::Metal);
    std::vector<Source> sources = next();
    ASSERT_EQ(count_of(sources, Sound::Switch), 1u);
    const SoundId id = sources[0].sound;
    const std::uint32_t key = sources[0].key;
    for (std::uint32_t i = 1; i < bank_.ticks(id); ++i) {
        sources = next();
        ASSERT_EQ(count_of(sources, Sound::Switch), 1u) << "tick " << i;
        ASSERT_EQ(sources[0].key, key);
    }
    EXPECT_EQ(count_of(next(), Sound::Switch), 0u);
}

// Feet stand on the floor to within rounding, and the floor is marble: own steps were lost below it.
TEST_F(SoundscapeTest, NoFloorMufflesTheStepThatFallsOnIt) {
    gh::test::SmallLevel small;
    small.add_box({-4.0f, -0.3f, -4.0f}, {4.0f, 0.0f, 4.0f}, small.add_material(world::Surface::Marble));
    const auto scene = gh::test::rest_scene(small.level);
    const glm::vec3 ear(1.0f, 1.6f, 2.0f);
    for (const float feet : {-1e-3f, -1e-6f, 0.0f, 1e-6f}) {
        emit(world::NoiseKind::Footstep, world::Surface::Marble);
        state_.noises[0].position.y = feet;
        const std::vector<Source> sources = next();
        const auto step = std::find_if(sources.rbegin(), sources.rend(),
                                       [](const Source& s) { return s.sound.sound == Sound::StepMarble; });
        ASSERT_NE(step, sources.rend());
        const sense::Transmission way = sense::hear(small.level, *scene, step->position, ear);
        EXPECT_NEAR(sense::level_db(50.0f, way), 50.0f - 20.0f * std::log10(1.6f), 0.5f) << feet;
    }
}

// Two stones in one tick, and steps in the next, are as many voices.
TEST_F(SoundscapeTest, EveryNoiseHasAVoiceOfItsOwn) {
    std::set<std::uint32_t> keys;
    for (int tick = 0; tick < 3; ++tick) {
        emit(world::NoiseKind::StoneHit, world::Surface::Metal);
        emit(world::NoiseKind::StoneHit, world::Surface::Metal);
        for (const Source& s : next()) {
            if (s.sound.sound == Sound::StoneMetal) keys.insert(s.key);
        }
    }
    EXPECT_EQ(keys.size(), 6u);
}

TEST_F(SoundscapeTest, AnyNumberOfNoisesRingWithinTheLimit) {
    for (int tick = 0; tick < 10; ++tick) {
        for (std::size_t i = 0; i < world::kMaxNoises; ++i)
            emit(world::NoiseKind::StoneHit, world::Surface::Metal);
        EXPECT_LE(count_of(next(), Sound::StoneMetal), kMaxRinging);
    }
}

// Crouching is 15 dB quieter in the world, and audibly so in the headphones.
TEST_F(SoundscapeTest, AQuieterStepPlaysMoreSoftly) {
    emit(world::NoiseKind::Footstep, world::Surface::Marble, 50.0f);
    emit(world::NoiseKind::Footstep, world::Surface::Marble, 35.0f);
    const std::vector<Source> sources = next();
    EXPECT_FLOAT_EQ(sources[0].gain, 1.0f);
    EXPECT_NEAR(test::decibels(static_cast<double>(sources[1].gain)), -0.75 * 15.0, 0.01);
}

TEST_F(SoundscapeTest, FloorsSoundAsWhatTheyAre) {
    const struct {
        world::Surface surface;
        Sound step, boot, stone;
    } cases[] = {
        {world::Surface::Marble, Sound::StepMarble, Sound::BootMarble, Sound::StoneMarble},
        {world::Surface::Parquet, Sound::StepParquet, Sound::BootParquet, Sound::StoneParquet},
        {world::Surface::Carpet, Sound::StepCarpet, Sound::BootCarpet, Sound::StoneCarpet},
        {world::Surface::Metal, Sound::StepMetal, Sound::BootMetal, Sound::StoneMetal},
        {world::Surface::Pane, Sound::StepGlass, Sound::BootGlass, Sound::StoneGlass},
    };
    for (const auto& c : cases) {
        world::Noise noise;
        noise.surface = static_cast<std::uint8_t>(c.surface);
        noise.kind = world::NoiseKind::Footstep;
        EXPECT_EQ(sound_of(noise, 1, 0)->sound, c.step);
        noise.kind = world::NoiseKind::GuardStep;
        EXPECT_EQ(sound_of(noise, 1, 0)->sound, c.boot);
        noise.kind = world::NoiseKind::StoneHit;
        EXPECT_EQ(sound_of(noise, 1, 0)->sound, c.stone);
    }
}

// A vitrine's lid is a door to the game; to the ear it is glass on a small hinge.
TEST_F(SoundscapeTest, AVitrinesLidIsNoOakDoor) {
    level_.doors.resize(2);
    level_.doors[0].handle = level_.doors[0].hinge = {1.0f, 1.0f, 0.0f};
    level_.doors[1].handle = level_.doors[1].hinge = {6.0f, 1.0f, 0.0f};
    level_.doors[1].axis = {1.0f, 0.0f, 0.0f};
    for (const bool opens : {true, false}) {
        emit(opens ? world::NoiseKind::DoorOpen : world::NoiseKind::DoorClose, world::Surface::Oak);
        emit(opens ? world::NoiseKind::DoorOpen : world::NoiseKind::DoorClose, world::Surface::Oak);
        state_.noises[0].position = {1.2f, 1.0f, 0.3f};
        state_.noises[1].position = {5.8f, 1.3f, 0.0f};
        const std::vector<Source> sources = next();
        EXPECT_EQ(count_of(sources, opens ? Sound::DoorOpen : Sound::DoorClose), 1u);
        EXPECT_EQ(count_of(sources, opens ? Sound::VitrineOpen : Sound::VitrineClose), 1u);
    }
}

// The same walk sounds the same in the replay; and no variant is left out or favoured by much.
TEST_F(SoundscapeTest, VariantsFollowFromTheTickAndComeUpEvenly) {
    std::array<int, 4> counts{};
    for (std::uint32_t tick = 0; tick < 4000; ++tick) {
        const SoundId id = variant_of(Sound::StepMarble, tick, 0);
        EXPECT_EQ(id, variant_of(Sound::StepMarble, tick, 0));
        ++counts[id.variant];
    }
    for (const int count : counts) EXPECT_NEAR(count, 1000, 110);  // four standard deviations
}

TEST_F(SoundscapeTest, OnlyLampsThatShineAndAreNearHum) {
    for (const float x : {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 40.0f}) level_.lamps.push_back(lamp_at(x));
    level_.lamps[0].group = 3;
    state_.group_on[3] = 1;
    std::vector<Source> sources = next();
    EXPECT_EQ(count_of(sources, Sound::LampHum), kMaxHums);
    state_.group_on[3] = 0;
    sources = next();
    EXPECT_EQ(count_of(sources, Sound::LampHum), kMaxHums);  // the fifth takes its place
    EXPECT_TRUE(std::none_of(sources.begin(), sources.end(), [&](const Source& s) {
        return s.sound.sound == Sound::LampHum && s.position == level_.lamps[0].position;
    }));
}

// Walking away from a lamp, its hum fades to nothing before it is dropped.
TEST_F(SoundscapeTest, AHumFadesTowardsTheEdgeOfItsRange) {
    level_.lamps.push_back(lamp_at(0.0f));
    ear_ = {kHumRange - 0.001f, 2.0f, 0.0f};
    for (const Source& s : next()) {
        if (s.sound.sound != Sound::LampHum) continue;
        EXPECT_LT(s.gain, 0.001f);
    }
    ear_.x = kHumRange + 0.001f;
    EXPECT_EQ(count_of(next(), Sound::LampHum), 0u);
}

TEST_F(SoundscapeTest, BeingCaughtAndWinningAreHeardOnce) {
    EXPECT_EQ(count_of(next(), Sound::StingCaught), 0u);
    state_.rules.times_caught = 1;
    EXPECT_EQ(count_of(next(), Sound::StingCaught), 1u);
    EXPECT_EQ(count_of(next(), Sound::StingCaught), 1u);
    state_.rules.outcome = world::Outcome::Won;
    EXPECT_EQ(count_of(next(), Sound::StingWon), 1u);
    EXPECT_EQ(count_of(next(), Sound::StingWon), 1u);
}

// A checkpoint puts the world back: what rang in the time that never was is gone.
TEST_F(SoundscapeTest, AJumpInTimeSilencesWhatRang) {
    emit(world::NoiseKind::StoneHit, world::Surface::Metal);
    EXPECT_EQ(count_of(next(), Sound::StoneMetal), 1u);
    state_.tick = 500;
    EXPECT_EQ(count_of(next(), Sound::StoneMetal), 0u);
}

TEST_F(SoundscapeTest, AGuardsVoiceStaysWithTheGuard) {
    level_.guards.resize(1);
    state_.guards[0].position = {0.0f, 0.0f, 0.0f};
    emit(world::NoiseKind::Bark, world::Surface::Marble, 60.0f);
    state_.noises[0].bark = world::Bark::Alarm;
    state_.noises[0].by_guard = 0;
    ASSERT_EQ(next()[0].sound.sound, Sound::VoiceAlarm);
    state_.guards[0].position = {4.0f, 0.0f, 0.0f};
    EXPECT_FLOAT_EQ(next()[0].position.x, 4.0f);
}

TEST(Acoustics, DecibelsBecomeAmplitudes) {
    EXPECT_FLOAT_EQ(gain_from_db(0.0f), 1.0f);
    EXPECT_NEAR(gain_from_db(-20.0f), 0.1f, 1e-5f);
    EXPECT_NEAR(gain_from_db(6.0206f), 2.0f, 1e-5f);
    EXPECT_EQ(gain_from_db(500.0f), kMaxGain);
}

// What the walls leave of a sound, and where it seems to come from, reach the mixer unchanged.
TEST(Acoustics, TheWayOfASoundShapesWhatIsHeard) {
    sense::Transmission way;
    way.band_gain = {0.5f, 0.2f, 0.01f};
    way.arrives_from = {3.0f, 1.0f, 0.0f};
    const Source source{
        .sound = {Sound::BootMarble, 2}, .key = 77, .position = {9.0f, 0.0f, 9.0f}, .gain = 0.7f};
    const Heard heard = heard_by(source, way);
    EXPECT_EQ(heard.voice_key, 77u);
    EXPECT_EQ(heard.position, way.arrives_from);
    EXPECT_EQ(heard.band_gain, way.band_gain);
    EXPECT_EQ(heard.gain, 0.7f);
}

}  // namespace
}  // namespace gh::audio
