// spatial/skinning.h - linear blend skinning: vertices follow the joints that own them.
//
// Cost      about 20 ns a vertex; no allocation once `out` has its size.
// Threads   pure. Same bits: sums in the order of the four weights.
// Bad input weights sum to 1 and joints are in range (level_check).
#pragma once

#include "world/level.h"
#include "world/snapshot.h"

#include <glm/mat4x3.hpp>

#include <span>

namespace gh::spatial {

// Carries positions and normals through the blend of skin[joint]. Normals go through the blend's cofactors,
// so that they stay upright on the surface under uneven scales too, and come out unit.
void skin_mesh(const world::Mesh& mesh, std::span<const glm::mat4x3> skin, world::PosedMesh& out);

}  // namespace gh::spatial
