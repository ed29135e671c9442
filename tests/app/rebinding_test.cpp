#include "app/rebinding.h"

#include <gtest/gtest.h>

namespace gh::app {
namespace {

using input::Action;
using input::Bindings;
using input::Key;

class RebindingTest : public ::testing::Test {
  protected:
    static Key key(const char* word) { return input::key_named(word).value_or(Key{}); }
    static std::string label(Key k) { return std::string(input::word_of(k)); }

    void give(Action action, std::size_t place, const char* word) {
        rebinding_.ask_for({action, place});
        rebinding_.take(key(word), bindings_, label);
    }
    [[nodiscard]] present::ControlsPage page() const { return rebinding_.page(bindings_, label); }

    Rebinding rebinding_;
    Bindings bindings_ = input::default_bindings();
};

TEST_F(RebindingTest, ThePageShowsEveryActionWithItsKeys) {
    const auto rows = page().rows;
    ASSERT_EQ(rows.size(), input::kActions);
    EXPECT_EQ(rows[input::index_of(Action::Crouch)].keys[0], "Ctrl");
    EXPECT_EQ(rows[input::index_of(Action::Crouch)].keys[1], "C");
    EXPECT_EQ(rows[input::index_of(Action::Jump)].keys[1], "");
}

TEST_F(RebindingTest, AsksForAKeyAndTakesIt) {
    rebinding_.ask_for({Action::Jump, 1});
    ASSERT_TRUE(page().waiting);
    EXPECT_EQ(page().waiting->row, input::index_of(Action::Jump));
    EXPECT_EQ(page().waiting->place, 1u);
    rebinding_.take(key("middle mouse"), bindings_, label);
    EXPECT_FALSE(rebinding_.is_waiting());
    EXPECT_EQ(bindings_.of(Action::Jump)[1], key("middle mouse"));
}

TEST_F(RebindingTest, EscapeLeavesEverythingAsItWas) {
    rebinding_.ask_for({Action::Use, 0});
    rebinding_.cancel();
    rebinding_.take(key("F"), bindings_, label);  // too late
    EXPECT_EQ(bindings_, input::default_bindings());
    EXPECT_TRUE(page().said.empty());
}

TEST_F(RebindingTest, SaysWhoHadTheKeyAndWhatHeGotForIt) {
    give(Action::Use, 0, "F");
    EXPECT_NE(page().said.find("hold up the mirror"), std::string::npos) << page().said;
    EXPECT_NE(page().said.find("has E now"), std::string::npos) << page().said;
    EXPECT_FALSE(page().is_warning);
}

TEST_F(RebindingTest, WarnsWhenAnActionIsLeftWithoutAKey) {
    give(Action::Use, 1, "F");
    EXPECT_NE(page().said.find("no key"), std::string::npos) << page().said;
    EXPECT_TRUE(page().is_warning);
    give(Action::Jump, 1, "C");
    EXPECT_FALSE(page().is_warning) << "crouching still has Ctrl: " << page().said;
    rebinding_.remove({Action::Crouch, 0}, bindings_, label);
    EXPECT_TRUE(page().is_warning) << page().said;
}

TEST_F(RebindingTest, DefaultsBringEverythingBack) {
    give(Action::Use, 0, "F");
    give(Action::WalkForward, 0, "mouse 4");
    rebinding_.remove({Action::Throw, 0}, bindings_, label);
    EXPECT_NE(bindings_, input::default_bindings());
    rebinding_.restore_defaults(bindings_);
    EXPECT_EQ(bindings_, input::default_bindings());
}

TEST_F(RebindingTest, WordsAreThoseOfTheKeysThatAreBoundNow) {
    EXPECT_EQ(key_words(bindings_).one(Action::Use), "E");
    EXPECT_EQ(key_words(bindings_).any(Action::Crouch), "Ctrl or C");
    give(Action::Use, 0, "mouse 5");
    EXPECT_EQ(key_words(bindings_).one(Action::Use), "mouse 5");
    rebinding_.remove({Action::Use, 0}, bindings_, label);
    EXPECT_EQ(key_words(bindings_).one(Action::Use), "(no key)");
    rebinding_.remove({Action::Crouch, 0}, bindings_, label);
    EXPECT_EQ(key_words(bindings_).one(Action::Crouch), "C") << "the second is the first there is";
}

}  // namespace
}  // namespace gh::app
