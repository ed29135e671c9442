// embree_sah.h - what Embree's builders would cost a random ray, counted as raycore counts its own trees.
//
// Embree keeps the trees of its scenes to itself; rtcBuildBVH builds with the same builders (binned SAH: medium; with
// spatial splits: high) and hands every node out. Trees are eight wide, leaves hold one to eight triangles; a node
// costs 1, and so does every `block` triangles of a leaf, or part of them: 1 is how rc::Blas::sah_cost counts, 4 how
// Embree's own scenes are built and walked.
#pragma once

#include "bench_scenes.h"
#include "embree_side.h"

namespace bench {

[[nodiscard]] double embree_sah_cost(const BenchScene& scene, EmbreeQuality quality, unsigned block);

}  // namespace bench
