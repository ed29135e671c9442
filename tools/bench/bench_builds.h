// bench_builds.h - building trees over what stands still, and keeping up with what moves, beside Embree.
//
// Wall time, since threads are the point, and processor time of the whole process beside it: on a machine that others
// use, believe the second. Contestants build in turn, round by round.
#pragma once

#include "bench_report.h"
#include "bench_scenes.h"

namespace bench {

struct BuildOptions {
    int rounds = 5;
    unsigned threads = 2;
    bool with_embree = true;
};

// Every quality on one thread and on `threads`: ms, Mtri/s, bytes a triangle, and the ratio to Embree's like.
void bench_builds(Report& report, const BenchScene& scene, const BuildOptions& options);

// A cloth of 131 k triangles that swings: refit, and building anew, every frame.
void bench_cloth(Report& report, const BuildOptions& options);

// Top levels of 200 and of 10,000 instances that all move every frame; rays into the larger one.
void bench_crowd(Report& report, const BuildOptions& options);

}  // namespace bench
