// bench_casts.h - moving and resting bodies against one mesh: questions a second.
#pragma once

#include "bench_report.h"
#include "bench_scenes.h"

namespace bench {

// Balls and capsules thrown and walked about where the camera sees something; sizes are shares of the scene's.
void bench_casts(Report& report, const BenchScene& scene, int rounds);

}  // namespace bench
