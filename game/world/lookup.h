// world/lookup.h - from what a ray met to what it is: hit -> instance = part -> triangle -> material.
//
// Cost      three array reads. Bad input: hits of this Level's own Snapshot only, and no misses.
#pragma once

#include "world/level.h"

#include "raycore/ray.h"

namespace gh::world {

[[nodiscard]] inline const Part& part_at(const Level& level, const rc::Hit& hit) {
    return level.parts[hit.instance];
}

[[nodiscard]] inline const Material& material_at(const Level& level, const rc::Hit& hit) {
    const Mesh& mesh = level.meshes[level.parts[hit.instance].mesh];
    return level.materials[mesh.materials[hit.primitive]];
}

}  // namespace gh::world
