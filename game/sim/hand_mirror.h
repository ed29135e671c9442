// sim/hand_mirror.h - the verb of the hand mirror: held up while its button is, held out to a side by the lean keys,
// which then move the arm and not the head; never through a wall.
//
// Guards see the player in it as in any other mirror: its pane is one of Snapshot::panes.
//
// Cost      one sphere cast while it is held. Threads: State belongs to the tick. Same bits: as the queries'.
#pragma once

#include "input/command.h"
#include "world/snapshot.h"
#include "world/state.h"

namespace gh::sim {

// Whether the lean keys are the arm's now.
[[nodiscard]] bool steers_mirror(const input::Command& command, const world::PlayerState& player);

// One tick of the arm, after stance, height and lean are settled.
void move_hand_mirror(const world::Snapshot& before, const input::Command& command,
                      world::PlayerState& player);

}  // namespace gh::sim
