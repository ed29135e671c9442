// sim/use_target.h - what `use` would do now: the simulation does it, and the HUD says so beforehand.
//
// Cost      one ray, and one more for each small thing near the line of sight.
// Threads   pure. Same bits: a function of (Level, Snapshot, PlayerState).
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "world/level.h"
#include "world/snapshot.h"

namespace gh::sim {

inline constexpr float kUseReach = 1.8f;   // metres from the eye
inline constexpr float kTakeReach = 1.6f;  // for lenses and stones

enum class UseKind : std::uint8_t { Nothing, Door, Mirror, Switch, Lens, Stone, HandMirror };

struct UseTarget {
    UseKind kind = UseKind::Nothing;
    std::uint32_t index = 0;   // of Level::doors, mirrors, switches, lenses, or of State::stones
    glm::vec3 point{0.0f};     // world: where a prompt goes
};

// The door or turnable mirror aimed at, or the small thing (switch, lens, hand mirror, stone at rest) nearest to the line of
// sight with nothing solid before it: glass keeps hands off.
[[nodiscard]] UseTarget use_target(const world::Level& level, const world::Snapshot& snapshot,
                                   const world::PlayerState& player);

}  // namespace gh::sim
