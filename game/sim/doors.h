// sim/doors.h - doors swing, mirrors turn; neither crushes anybody.
//
// A door meets characters where it is about to be, not where the Scene last had it: each door has a small Scene
// of its own, closed, and a character is carried into its frame instead of the door into the character's.
//
// Cost      one capsule cast for each moving door and character beside it. Threads: State belongs to the tick.
#pragma once

#include <memory>
#include <vector>

#include "sim/motion.h"
#include "world/level.h"
#include "world/state.h"

#include "raycore/scene.h"

namespace gh::sim {

class DoorBodies {
  public:
    explicit DoorBodies(const world::Level& level);

    // Whether the door, as it stands in `state`, overlaps the body.
    [[nodiscard]] bool overlaps(const world::Level& level, const world::State& state, std::size_t door,
                                const Body& body) const;

  private:
    std::vector<std::shared_ptr<const rc::Scene>> closed_;  // one a door, in the frame of its hinge
};

// What most of a leaf is made of, by area: what it sounds like.
[[nodiscard]] world::Surface door_surface(const world::Level& level, std::size_t door);

// Turns a door the other way, with its sound; `by_guard` as in Noise.
void toggle_door(const world::Level& level, world::State& state, std::size_t door, std::uint8_t by_guard);

// Opens a door for a guard, who keeps it open until `until_tick` and shuts it then.
void hold_door_open(const world::Level& level, world::State& state, std::size_t door, std::uint32_t until_tick);

// 0 closed .. 1 open.
[[nodiscard]] float openness(const world::Level& level, const world::State& state, std::size_t door);

// One tick of every door: towards what it wants, unless the player (or, when no guard holds it, a guard) stands
// in its way.
void move_doors(const world::Level& level, const DoorBodies& bodies, world::State& state);

// One tick of every mirror towards its target: half a second a step.
void move_mirrors(const world::Level& level, world::State& state);

// One step of a turnable mirror, with its sound.
void turn_mirror(const world::Level& level, world::State& state, std::size_t mirror);

}  // namespace gh::sim
