// load/defaults.h - what a file that was never meant as a level lacks: a place to stand, and light.
#pragma once

#include "load/level_build.h"
#include "world/level.h"

namespace gh::load {

// Some ground near the middle with room to stand up, indoors and low down rather than on the roof, facing the
// way one sees farthest. Where there is no such ground: on top of whatever there is.
// Cost: builds trees over everything solid.
[[nodiscard]] world::Spawn find_spawn(const world::Level& level);

// When nothing lights the place: its emissive panels and bulbs become lamps, and where there are none, a sun, if one is to be hung.
void add_missing_light(LevelBuild& build, bool hangs_sun);

}  // namespace gh::load
