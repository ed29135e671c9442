#include "input/bindings.h"

#include <gtest/gtest.h>

#include <set>

namespace gh::input {
namespace {

Key key(const char* word) {
    return key_named(word).value_or(Key{});
}

// The Command of somebody who holds these keys.
Command command_of(const Bindings& bindings, const std::set<Key>& down) {
    Command command;
    put_actions(held_actions(bindings, [&](Key k) { return down.contains(k); }), command);
    return command;
}

TEST(Keys, EveryKeyHasOneWordAndTheWordLeadsBackToIt) {
    std::set<std::string_view> words;
    for (const Key k : bindable_keys()) {
        ASSERT_FALSE(word_of(k).empty()) << k.code;
        EXPECT_TRUE(words.insert(word_of(k)).second) << word_of(k);
        EXPECT_EQ(key_named(word_of(k)), k) << word_of(k);
    }
    EXPECT_EQ(key_named("LEFT MOUSE"), key("left mouse"));
    EXPECT_FALSE(key_named(""));
    EXPECT_FALSE(key_named("Hyper"));
}

// A player who gives Escape away has no menu left to take it back in.
TEST(Keys, EscapeIsNotToBeBound) {
    EXPECT_FALSE(key_named("Escape"));
    EXPECT_FALSE(key_named("Esc"));
    for (const Key k : bindable_keys()) EXPECT_NE(k.code, 256) << "GLFW's Escape";
}

TEST(Keys, TheMouseHasEightButtonsAmongThem) {
    int buttons = 0;
    for (const Key k : bindable_keys()) buttons += is_mouse_button(k) ? 1 : 0;
    EXPECT_EQ(buttons, kMouseButtons);
    EXPECT_TRUE(is_mouse_button(key("middle mouse")));
    EXPECT_FALSE(is_mouse_button(key("M")));
}

TEST(Bindings, AtFirstEveryActionHasAKeyAndNoKeyTwoActions) {
    const Bindings bindings = default_bindings();
    std::set<Key> seen;
    for (std::size_t i = 0; i < kActions; ++i) {
        EXPECT_FALSE(bindings.keys[i][0].is_none()) << title_of(static_cast<Action>(i));
        for (const Key k : bindings.keys[i]) {
            EXPECT_TRUE(k.is_none() || seen.insert(k).second) << word_of(k);
        }
    }
}

TEST(Bindings, AKeyThatIsTakenIsExchanged) {
    Bindings bindings = default_bindings();
    const auto loser = bind(bindings, {Action::Use, 0}, key("F"));
    ASSERT_TRUE(loser);
    EXPECT_EQ(*loser, (KeySlot{Action::HandMirror, 0}));
    EXPECT_EQ(bindings.of(Action::Use)[0], key("F"));
    EXPECT_EQ(bindings.of(Action::HandMirror)[0], key("E"));
    EXPECT_EQ(bind(bindings, {Action::HandMirror, 0}, key("F")), (KeySlot{Action::Use, 0}));
    EXPECT_EQ(bindings, default_bindings()) << "and back again";
}

TEST(Bindings, AKeyMayMoveToTheSecondPlaceOrBeBoundAsItIs) {
    Bindings bindings = default_bindings();
    EXPECT_FALSE(bind(bindings, {Action::Jump, 0}, key("Space")));
    EXPECT_EQ(bindings, default_bindings());
    EXPECT_EQ(bind(bindings, {Action::Crouch, 0}, key("C")), (KeySlot{Action::Crouch, 1}));
    EXPECT_EQ(bindings.of(Action::Crouch)[1], key("Ctrl"));
    EXPECT_FALSE(bind(bindings, {Action::Crouch, 1}, Key{}));
    EXPECT_TRUE(bindings.of(Action::Crouch)[1].is_none());
    EXPECT_FALSE(slot_of(bindings, key("Ctrl"))) << "free again";
}

TEST(Bindings, WhatIsHeldIsTheCommandThatTheFirstKeysGave) {
    const Bindings bindings = default_bindings();
    EXPECT_EQ(command_of(bindings, {}), Command());
    const Command forward = command_of(bindings, {key("W"), key("Shift")});
    EXPECT_EQ(forward.move_forward, kMaxMove);
    EXPECT_EQ(forward.buttons, input::Run);
    EXPECT_EQ(command_of(bindings, {key("Up"), key("Shift")}), forward);
    EXPECT_EQ(command_of(bindings, {key("W"), key("S")}).move_forward, 0) << "both ways at once is neither";
    EXPECT_EQ(command_of(bindings, {key("left mouse")}).buttons, Throw);
    EXPECT_EQ(command_of(bindings, {key("right mouse"), key("C")}).buttons, Cancel | Crouch);
    EXPECT_EQ(command_of(bindings, {key("F3"), key("F4"), key("F11")}), Command())
        << "the program's keys are nothing that a recording should know of";
}

// A recording holds Commands: who has other keys and does the same with them writes the same recording.
TEST(Bindings, TheSameDoneWithOtherKeysIsTheSameCommand) {
    const Bindings first = default_bindings();
    Bindings other = first;
    // Every action gets the key that another one has, round in a circle.
    for (std::size_t i = 0; i < kActions; ++i) other.keys[i] = first.keys[(i + 5) % kActions];
    for (std::uint32_t mask = 0; mask < (1u << kActions); mask += 37) {
        std::set<Key> with_first;
        std::set<Key> with_other;
        for (std::size_t i = 0; i < kActions; ++i) {
            if ((mask >> i & 1u) == 0) continue;
            with_first.insert(first.keys[i][0]);
            with_other.insert(other.keys[i][0]);
        }
        ASSERT_EQ(command_of(first, with_first), command_of(other, with_other)) << "actions " << mask;
    }
}

}  // namespace
}  // namespace gh::input
