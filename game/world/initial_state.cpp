#include "world/initial_state.h"

#include "base/contracts.h"
#include "base/det_math.h"

namespace gh::world {

namespace {

std::int16_t turn_from_radians(float yaw) {
    const float turns = yaw / kTwoPi;
    const float fraction = turns - static_cast<float>(static_cast<std::int32_t>(turns));
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(static_cast<std::int32_t>(fraction * 65536.0f)));
}

void light_lamps(const Level& level, State& state) {
    // A group is on when any of its lamps starts so; a group that only glowing parts use starts on.
    std::array<std::uint8_t, kMaxLampGroups> has_lamp{};
    for (const Lamp& lamp : level.lamps) {
        if (lamp.group == kNoIndex) continue;
        has_lamp[lamp.group] = 1;
        if (lamp.starts_on) state.group_on[lamp.group] = 1;
    }
    for (std::size_t g = 0; g < level.lamp_groups.size(); ++g) {
        if (has_lamp[g] == 0) state.group_on[g] = 1;
    }
}

}  // namespace

State initial_state(const Level& level, std::uint32_t seed) {
    EXPECTS(level.guards.size() <= kMaxGuards && level.lamp_groups.size() <= kMaxLampGroups);
    State state;
    state.seed = seed;
    state.player.position = level.spawn.position;
    state.player.yaw = turn_from_radians(level.spawn.yaw);
    state.player.height = kStandingHeight;
    state.player.stones_left = kStonesAtStart;
    light_lamps(level, state);
    for (std::size_t g = 0; g < level.guards.size(); ++g) {
        state.guards[g].position = level.guards[g].position;
        state.guards[g].yaw = level.guards[g].yaw;
        state.guards[g].target = level.guards[g].position;
        state.guards[g].last_known = level.guards[g].position;
    }
    return state;
}

}  // namespace gh::world
