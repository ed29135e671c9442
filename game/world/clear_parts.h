// world/clear_parts.h - which parts let light through somewhere: glass, cut-out leaves, tints.
#pragma once

#include "world/level.h"

namespace gh::world {

// Whether light may pass some triangle of this mesh.
[[nodiscard]] bool has_clear_triangles(const Level& level, const Mesh& mesh);

// Gives every part with layer Light one of the layers Blocker and Clear as well. Once, by whoever makes a Level;
// without it pictures are the same but shadows cost more. Precondition: indices are in range.
void mark_clear_parts(Level& level);

}  // namespace gh::world
