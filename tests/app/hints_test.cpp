#include "app/hints.h"

#include "app/hint_words.h"

#include <gtest/gtest.h>

#include <map>

namespace gh::app {
namespace {

// A room with a lens, a lamp switch, a door and a guard, and nothing that happens but what a test says.
class HintsTest : public ::testing::Test {
  protected:
    HintsTest() {
        level_.rooms = {{.name = "room_a", .title = "Lens Cabinet", .box = {{-5, 0, -5}, {5, 4, 5}}},
                        {.name = "room_b", .title = "Vestibule", .box = {{95, 0, -5}, {105, 4, 5}}}};
        level_.lenses = {{.name = "lens", .title = "The Founder's Lens", .centre = {0, 1, 0}}};
        level_.exits = {{{98, 0, -1}, {100, 2, 1}}};
        level_.switches = {{.name = "switch", .title = "Lamp", .position = {3, 1, 0}, .group = 0}};
        level_.doors.resize(1);
        level_.doors[0].handle = {40, 1, 0};
        level_.guards.resize(1);
        now_.state.guards[0].position = {60, 0, 0};
    }

    // Seconds pass; which lessons were shown, and for how long each.
    std::map<Lesson, float> pass(float seconds) {
        std::map<Lesson, float> shown;
        for (int i = 0; i < static_cast<int>(seconds * 60.0f); ++i) {
            ++now_.state.tick;
            hints_.note_tick(level_, now_);
            if (hints_.lesson()) shown[*hints_.lesson()] += 1.0f / 60.0f;
        }
        return shown;
    }

    // What the line says to somebody who has these keys.
    [[nodiscard]] std::string words(const input::Bindings& bindings = input::default_bindings()) const {
        return hints_.lesson() ? words_for(*hints_.lesson(), level_, key_words(bindings)) : "";
    }

    world::State& state() { return now_.state; }
    world::PlayerState& player() { return now_.state.player; }
    world::GuardState& guard() { return now_.state.guards[0]; }

    world::Level level_;
    world::Snapshot now_;
    Hints hints_;
};

TEST_F(HintsTest, FirstOfAllANewcomerIsToldWhatToStealAndWhereItIs) {
    pass(3.0f);
    ASSERT_EQ(hints_.lesson(), Lesson::Goal);
    EXPECT_NE(words().find("Steal the Founder's Lens"), std::string::npos);
    EXPECT_NE(words().find("Lens Cabinet"), std::string::npos);
    EXPECT_EQ(hints_.strength(), 1.0f);
}

TEST_F(HintsTest, NothingIsSaidTwiceAndThenThereIsQuiet) {
    const auto shown = pass(60.0f);
    EXPECT_EQ(shown.size(), 1u) << "there is nothing to be told in an empty house but the goal";
    EXPECT_NEAR(shown.at(Lesson::Goal), 7.0f, 0.2f);
    EXPECT_FALSE(hints_.lesson());
}

TEST_F(HintsTest, CrouchingIsTaughtToWhoWalksNearAGuardAndNotToWhoCrouches) {
    pass(12.0f);  // the goal has been read
    guard().position = {8, 0, 0};
    player().velocity = {2, 0, 0};
    Hints cautious = hints_;
    EXPECT_TRUE(pass(2.0f).contains(Lesson::Crouch));
    hints_ = cautious;
    player().stance = world::Stance::Crouch;
    pass(0.1f);
    player().stance = world::Stance::Stand;
    EXPECT_FALSE(pass(20.0f).contains(Lesson::Crouch));
}

TEST_F(HintsTest, ALineGoesSoonAfterWhatItAsksForIsDone) {
    pass(12.0f);
    player().has_mirror = 1;
    pass(1.5f);
    ASSERT_EQ(hints_.lesson(), Lesson::HandMirror);
    player().mirror_raise = 1.0f;
    pass(0.8f);
    EXPECT_FALSE(hints_.lesson());
}

TEST_F(HintsTest, LampsAreTaughtWhereOneCouldBePutOutAndSomebodyCouldSeeIt) {
    pass(12.0f);
    player().exposure = 0.9f;
    state().group_on[0] = 1;
    EXPECT_TRUE(pass(5.0f).empty()) << "the guard is 60 m off";
    guard().position = {12, 0, 0};
    state().group_on[0] = 0;
    EXPECT_TRUE(pass(5.0f).empty()) << "the lamp is out already";
    state().group_on[0] = 1;
    EXPECT_TRUE(pass(1.0f).contains(Lesson::Light));
}

TEST_F(HintsTest, AChaseInterruptsWhateverIsSaid) {
    pass(3.0f);
    ASSERT_EQ(hints_.lesson(), Lesson::Goal);
    guard().alert = world::Alert::Chasing;
    pass(0.1f);
    EXPECT_EQ(hints_.lesson(), Lesson::Chase);
}

TEST_F(HintsTest, TheLensInHandPointsToTheWayOut) {
    pass(12.0f);
    state().rules.lenses_taken_count = 1;
    pass(1.0f);
    ASSERT_EQ(hints_.lesson(), Lesson::Exit);
    EXPECT_NE(words().find("Vestibule"), std::string::npos);
    state().rules.outcome = world::Outcome::Won;
    pass(0.1f);
    EXPECT_FALSE(hints_.lesson()) << "who has won needs no advice";
}

TEST_F(HintsTest, KeysAreCalledWhatTheyAreBoundToNow) {
    pass(12.0f);
    player().has_mirror = 1;
    pass(1.5f);
    ASSERT_EQ(hints_.lesson(), Lesson::HandMirror);
    EXPECT_NE(words().find("Hold F:"), std::string::npos) << words();
    input::Bindings bindings = input::default_bindings();
    input::bind(bindings, {input::Action::HandMirror, 0}, *input::key_named("mouse 4"));
    input::bind(bindings, {input::Action::LeanLeft, 0}, *input::key_named("Z"));
    EXPECT_NE(words(bindings).find("Hold mouse 4:"), std::string::npos) << words(bindings);
    EXPECT_NE(words(bindings).find("Z or R"), std::string::npos) << words(bindings);
}

TEST_F(HintsTest, ALevelWithNothingInItTeachesNothing) {
    level_ = world::Level();
    player().velocity = {2, 0, 0};
    EXPECT_TRUE(pass(40.0f).empty());
}

}  // namespace
}  // namespace gh::app
