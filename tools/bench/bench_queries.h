// bench_queries.h - rays against one mesh: raycore one ray at a time and in batches, beside Embree.
#pragma once

#include "bench_report.h"
#include "bench_scenes.h"

#include <cstddef>

namespace bench {

struct QueryOptions {
    int rounds = 7;
    int keep = 8;            // every how many-th 8x8 tile of 1280x720
    unsigned threads = 2;    // of the second race; 1: no second race
    std::size_t batch = 64;  // rays a call
    bool with_embree = true;
};

// What a tree costs (bytes, nodes and leaves a ray), the race on one thread and on `threads`, and the ratios that matter.
void bench_queries(Report& report, const BenchScene& scene, const QueryOptions& options);

}  // namespace bench
