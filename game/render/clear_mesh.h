// render/clear_mesh.h - is a piece of glass a body that light enters and leaves, or a sheet without a thickness?
#pragma once

#include "world/level.h"

namespace gh::render {

// Whether the mesh's triangles of transmissive materials close a volume: every edge is shared by two that run through
// it in opposite directions. Corners at the same place, as far as floats can
// tell, count as one. False when there are none.
[[nodiscard]] bool is_closed_glass(const world::Level& level, const world::Mesh& mesh);

}  // namespace gh::render
