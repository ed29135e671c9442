#include "app/hud_model.h"

#include "app/noise_words.h"

#include <gtest/gtest.h>

namespace gh::app {
namespace {

using input::Action;

class HudModelTest : public ::testing::Test {
  protected:
    // As somebody sees it who uses things by the mouse's fourth button and holds the mirror up by X.
    [[nodiscard]] present::HudModel model() const {
        input::Bindings bindings = input::default_bindings();
        input::bind(bindings, {Action::Use, 0}, *input::key_named("mouse 4"));
        input::bind(bindings, {Action::HandMirror, 0}, *input::key_named("X"));
        HudChoices choices;
        choices.keys = key_words(bindings);
        return HudReader().model(level_, now_, render::Camera(), 16.0f / 9.0f, choices);
    }

    world::Level level_;
    world::Snapshot now_;
};

TEST_F(HudModelTest, WhoIsCaughtIsToldTheKeyThatIsBoundToGoBack) {
    now_.state.rules.outcome = world::Outcome::Caught;
    EXPECT_EQ(model().headline, "Caught");
    EXPECT_NE(model().subline.find("press mouse 4"), std::string::npos) << model().subline;
    EXPECT_TRUE(model().prompt.empty()) << "nothing is to be used any more";
}

TEST_F(HudModelTest, TheHandMirrorStandsThereWithItsKeyOnceItIsCarried) {
    now_.state.rules.outcome = world::Outcome::Caught;  // no scene is asked what could be used
    EXPECT_TRUE(model().mirror.empty());
    now_.state.player.has_mirror = 1;
    EXPECT_EQ(model().mirror, "X  hand mirror");
}

TEST_F(HudModelTest, WhoStandsIsNotSaidToWalk) {
    now_.state.rules.outcome = world::Outcome::Won;
    EXPECT_FALSE(model().is_walking);
    now_.state.player.velocity = {0.0f, 0.0f, -1.4f};
    EXPECT_TRUE(model().is_walking);
    EXPECT_FALSE(model().is_running);
    now_.state.player.velocity = {0.0f, 0.0f, -4.5f};
    EXPECT_TRUE(model().is_running);
}

TEST_F(HudModelTest, WhatTheProgramSaysIsReadWithoutCaptionsToo) {
    now_.state.rules.outcome = world::Outcome::Won;
    now_.state.noises[0].kind = world::NoiseKind::DoorOpen;
    now_.state.noise_count = 1;
    HudReader reader;
    reader.note_tick(level_, now_);
    reader.say("this run is not recorded");
    HudChoices choices;
    const auto read = [&] { return reader.model(level_, now_, render::Camera(), 1.0f, choices).captions; };
    ASSERT_EQ(read().size(), 2u);
    choices.captions = false;
    ASSERT_EQ(read().size(), 1u);
    EXPECT_EQ(read()[0].text, "this run is not recorded");
}

TEST(NoiseWords, AStoneAndAVoiceAreOneLineEachAndDoorsAreMany) {
    const auto subject = [](world::NoiseKind kind) {
        world::Noise noise{};
        noise.kind = kind;
        return subject_of(noise);
    };
    EXPECT_FALSE(subject(world::NoiseKind::StoneHit).empty());
    EXPECT_NE(subject(world::NoiseKind::StoneHit), subject(world::NoiseKind::Bark));
    EXPECT_TRUE(subject(world::NoiseKind::DoorOpen).empty());
}

}  // namespace
}  // namespace gh::app
