// sim/carry.h - how a sound gets to an ear, along the corridors as well: one computation for guards and player.
//
// Cost      a path and sense::hear. Threads: pure. Same bits: a function of its arguments.
#pragma once

#include "sense/hearing.h"
#include "sim/navigation.h"
#include "world/level.h"

#include "raycore/scene.h"

#include <glm/vec3.hpp>

namespace gh::sim {

// sense::hear with the way one would walk from the source to the listener's feet as the detour. On a level
// without a navmesh sound goes through and past things only.
[[nodiscard]] sense::Transmission carry_sound(const world::Level& level, const rc::Scene& scene,
                                              const Navigation& navigation, const glm::vec3& source,
                                              const glm::vec3& ear, const glm::vec3& feet);

}  // namespace gh::sim
