// sim/planes.h - what is left of a motion between surfaces it may not enter.
//
// Threads   pure. Cost: cubic in the number of planes, of which there are at most five.
#pragma once

#include <span>

#include <glm/vec3.hpp>

namespace gh::sim {

// `v` without what runs into the planes (unit normals, pointing out): along one, along the common edge of two,
// zero in a corner.
[[nodiscard]] glm::vec3 along_planes(std::span<const glm::vec3> planes, const glm::vec3& v);

}  // namespace gh::sim
