// bench_sah.h - how good trees are, whoever built them: the cost of a random ray by the surface-area heuristic.
#pragma once

#include "bench_report.h"
#include "bench_scenes.h"

namespace bench {

// Every quality beside Embree's like, counted in the same terms, once by triangles and once by blocks of four; ours /
// theirs, lower is better.
void bench_sah(Report& report, const BenchScene& scene, bool with_embree);

}  // namespace bench
