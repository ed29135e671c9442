// embree_sah.h - what Embree's builders would cost a random ray, counted as raycore counts its own trees.
//
// Embree keeps the trees of its scenes to itself; rtcBuildBVH builds with the same builders (binned SAH: medium; with
// spatial splits: high) and hands every node out. Trees are eight wide, leaves hold one to eight triangles, nodes and
// triangles cost 1: the terms of rc::Blas::sah_cost.
#pragma once

#include "bench_scenes.h"
#include "embree_side.h"

namespace bench {

[[nodiscard]] float embree_sah_cost(const BenchScene& scene, EmbreeQuality quality);

}  // namespace bench
