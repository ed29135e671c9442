// world/initial_state.h - the world before the first tick, and what a checkpoint returns to.
#pragma once

#include "world/state.h"

namespace gh::world {

inline constexpr std::uint8_t kStonesAtStart = 8;
inline constexpr float kStandingHeight = 1.75f;   // metres, of the player's capsule
inline constexpr float kCrouchingHeight = 1.1f;

// Doors closed, mirrors at rest, lamps as the file says, everyone where they start.
[[nodiscard]] State initial_state(const Level& level, std::uint32_t seed);

}  // namespace gh::world
