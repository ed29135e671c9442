#include "world/state_hash.h"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "world/initial_state.h"

namespace gh::world {
namespace {

Level level_with_a_guard_and_lamps() {
    Level level;
    level.spawn = {.position = {1.0f, 0.0f, -2.0f}, .yaw = 1.5707964f};
    level.lamp_groups = {"hall", "vault", "sign"};
    Lamp hall;
    hall.group = 0;
    Lamp vault;
    vault.group = 1;
    vault.starts_on = false;
    level.lamps = {hall, vault};
    Guard guard;
    guard.position = {4.0f, 0.0f, 4.0f};
    guard.yaw = 0.5f;
    level.guards = {guard};
    return level;
}

TEST(StateHash, EveryByteThatMeansSomethingChangesTheTotalAndExactlyOnePart) {
    State state = initial_state(level_with_a_guard_and_lamps(), 7);
    const StateHash before = state_hash(state);
    std::size_t unseen = 0, in_two_parts = 0;
    std::array<std::byte, sizeof(State)> bytes;
    std::memcpy(bytes.data(), &state, sizeof(State));
    for (std::size_t i = 0; i < sizeof(State); ++i) {
        bytes[i] ^= std::byte{1};
        State changed;
        std::memcpy(&changed, bytes.data(), sizeof(State));
        bytes[i] ^= std::byte{1};
        const StateHash after = state_hash(changed);
        int parts = 0;
        for (std::size_t p = 0; p < kHashParts; ++p) parts += after.part[p] != before.part[p];
        unseen += parts == 0;
        in_two_parts += parts > 1;
        EXPECT_EQ(parts == 0, after.total == before.total) << "byte " << i;
    }
    const std::size_t named_padding = sizeof(PlayerState::pad_) + kMaxDoors * sizeof(DoorState::pad_) +
                                      sizeof(RulesState::pad_) + kMaxStones * sizeof(StoneState::pad_) +
                                      kMaxGuards * sizeof(Percept::pad_);
    EXPECT_EQ(unseen, named_padding) << "a member of State is not hashed";
    EXPECT_EQ(in_two_parts, 0u);
}

TEST(StateHash, MinusZeroIsAnotherStateThanZeroBecauseLaterTicksMayTellThemApart) {
    State a = initial_state({}, 0), b = a;
    b.player.velocity.x = -0.0f;
    EXPECT_NE(state_hash(a).total, state_hash(b).total);
}

TEST(StateHash, PartsHaveTheNamesADivergenceIsReportedWith) {
    EXPECT_EQ(hash_part_name(HashPart::Player), "player");
    EXPECT_EQ(hash_part_name(HashPart::Noises), "noises");
}

TEST(InitialState, PutsEverybodyAndEveryLampWhereTheFileSays) {
    const Level level = level_with_a_guard_and_lamps();
    const State state = initial_state(level, 7);
    EXPECT_EQ(state.seed, 7u);
    EXPECT_EQ(state.player.position, level.spawn.position);
    EXPECT_EQ(state.player.yaw, 16384) << "a quarter turn to the left";
    EXPECT_EQ(state.group_on[0], 1);
    EXPECT_EQ(state.group_on[1], 0) << "the vault's lamp starts dark";
    EXPECT_EQ(state.group_on[2], 1) << "a group of glowing parts alone";
    EXPECT_TRUE(is_lamp_on(level, state, 0));
    EXPECT_FALSE(is_lamp_on(level, state, 1));
    EXPECT_EQ(state.guards[0].position, level.guards[0].position);
    EXPECT_EQ(state.rules.outcome, Outcome::Playing);
}

TEST(InitialState, SpawnsFacingAnyYawIncludingTheSeamOfTheTurn) {
    for (const float yaw : {-3.1415927f, -1.0f, 0.0f, 3.1415927f, 9.0f}) {
        Level level;
        level.spawn.yaw = yaw;
        const State state = initial_state(level, 0);
        const float difference = static_cast<float>(state.player.yaw) * (6.2831855f / 65536.0f) - yaw;
        const float turns = difference / 6.2831855f;
        EXPECT_NEAR(turns, std::round(turns), 2e-5f) << yaw;
    }
}

}  // namespace
}  // namespace gh::world
