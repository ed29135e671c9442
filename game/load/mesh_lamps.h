// load/mesh_lamps.h - lamps that are meshes: a ball for a bulb, a rectangle for a panel, as bright as their
// emissive material.
#pragma once

#include "load/level_build.h"
#include "world/level.h"

#include <optional>
#include <string>

namespace gh::load {

enum class MeshLampShape { Either, Sphere, Rect };

// The lamp that part `part_id` is, or nothing when no triangle of it shines. `Either` takes a rectangle where
// nine tenths of what shines lie in one plane, and a ball otherwise.
[[nodiscard]] std::optional<world::Lamp> lamp_of_part(const LevelBuild& build, std::uint32_t part_id,
                                                      MeshLampShape shape);

// How far off a lamp gives less than 1e-3 W/m2 at best; infinite for a sun.
[[nodiscard]] float range_of(const world::Lamp& lamp);

}  // namespace gh::load
