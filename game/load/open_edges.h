// load/open_edges.h - is a mesh closed? Light, sound and stones stay in a room only if its shell has no hole.
//
// Corners at the same position are one corner, whatever their normals and uvs. An edge is open when only one
// triangle has it: at a hole, and where a corner of one side lies within an edge of the other (a T-joint),
// which leaks too.
#pragma once

#include "world/level.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace gh::load {

struct OpenEdges {
    std::size_t count = 0;
    std::vector<glm::vec3> middles;  // of the first few, in the mesh's frame
};

// O(n log n) in triangles. Triangles with two equal corners have no edges.
[[nodiscard]] OpenEdges find_open_edges(const world::Mesh& mesh);

}  // namespace gh::load
