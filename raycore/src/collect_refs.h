// collect_refs.h - a box around each triangle worth keeping, and its slack: what every build starts from.
#pragma once

#include "binned_builder.h"
#include "unfilled.h"

#include "raycore/mesh.h"

#include <glm/vec3.hpp>

#include <cstddef>

namespace rc {

struct CollectedRefs {
    Unfilled<BuildRef> refs;
    GrowingBox bounds;  // of the triangles themselves
};

// In order of primitives, in parallel, with room reserved for `most` of them; what is not worth keeping is counted in
// `report`.
[[nodiscard]] CollectedRefs collect_refs(const MeshView& mesh, std::size_t most, MeshReport& report);

// How far boxes reach beyond a triangle, or a part of it.
[[nodiscard]] float slack_of(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

}  // namespace rc
