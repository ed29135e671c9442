// collect_refs.h - a box around each triangle worth keeping: what every build starts from.
#pragma once

#include "binned_builder.h"
#include "unfilled.h"

#include "raycore/mesh.h"

namespace rc {

// In order of primitives, in parallel; what is not worth keeping is counted in `report`.
[[nodiscard]] Unfilled<BuildRef> collect_refs(const MeshView& mesh, MeshReport& report);

}  // namespace rc
