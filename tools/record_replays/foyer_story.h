// foyer_story.h - the winning run through the foyer, as a part for an Actor: what the game is, shown in about a minute.
#pragma once

#include "actor.h"

namespace gh::tools {

// Plays it from the spawn to the exit; afterwards the actor has won, or has trouble to report.
void play_foyer(Actor& thief);

}  // namespace gh::tools
