// foyer_story.h - the winning run through the foyer, as a part for an Actor: what the game is, shown in about a minute.
#pragma once

#include "actor.h"

namespace gh::tools {

inline constexpr int kTakes = 32;

// Plays it from the spawn to the exit; afterwards the actor has won, or has trouble to report. Takes differ in how far
// the thief creeps and runs, and so in what the guard, whose search nobody can direct, is doing when he comes back.
void play_foyer(Actor& thief, int take);

}  // namespace gh::tools
