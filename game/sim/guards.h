// sim/guards.h - the museum's watch: what they notice, what they make of it, where they go, how they move.
//
// Suspicion is kept in log units: +10 is twice the stimulus. Sight adds with time, the more the larger and the
// better lit the player appears; a noise adds at once. What comes by one indirect channel alone (a mirror, a
// sound) never starts a chase; the player himself, in plain view for kReactionTicks, does.
//
//   Calm --6--> Suspicious --14--> Searching --24, in plain view--> Chasing --within reach--> caught
//
// Who is hit by a stone searches at once, and first where it came from.
//
// Guard g looks on ticks = g mod 4, and hears on every tick.
//
// Cost      about 20 rays a look, a path now and then, 3 casts a step.
// Threads   State belongs to the tick. Same bits: a function of its arguments, guards in index order.
#pragma once

#include <cstdint>

#include "sim/doors.h"
#include "sim/navigation.h"
#include "world/level.h"
#include "world/snapshot.h"

namespace gh::sim {

inline constexpr float kSuspiciousAt = 6.0f;
inline constexpr float kSearchingAt = 14.0f;
inline constexpr float kChasingAt = 24.0f;
inline constexpr std::uint16_t kReactionTicks = 24;  // 0.4 s
inline constexpr float kCatchReach = 1.0f;           // metres between feet

inline constexpr float kFaintestDb = 22.0f;          // the museum's own hum: what no guard hears

inline constexpr float kGuardWalkSpeed = 1.4f;    // m/s: the walk clip's own
inline constexpr float kGuardSearchSpeed = 1.7f;
inline constexpr float kGuardRunSpeed = 4.2f;     // m/s: the run clip's own

inline constexpr float kGuardHeight = 1.8f;       // metres

// What doors, stones and other guards meet of a guard.
[[nodiscard]] Body body_of(const world::GuardState& guard);

// The world as it stands, and the ways through it.
struct GuardWorld {
    const world::Level& level;
    const world::Snapshot& snapshot;
    const Navigation& navigation;
    const DoorBodies& doors;
};

// Decide: where each guard wants to go, from what it made of the last tick.
void decide_guards(const GuardWorld& before, world::State& state);

// Motion: one tick of walking, turning and of the clips that show it. Opens doors and waits for them.
void move_guards(const GuardWorld& before, world::State& state);

// Perceive: how lit the player is, and what each guard sees and hears now. `now` is of this very tick; barks of
// the tick before, `last`, are heard as well, for they are given after everybody has listened.
void perceive(const GuardWorld& now, const world::State& last, world::State& state);

// Judge: suspicion, alerts with their barks, and arrests. Barks sound in the tick they are given in.
void judge_guards(const GuardWorld& now, world::State& state);

}  // namespace gh::sim
