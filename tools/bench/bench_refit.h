// bench_refit.h - when is a refitted tree so much worse than a new one that building anew pays?
#pragma once

#include "bench_report.h"

namespace bench {

struct RefitOptions {
    int rounds = 7;
    std::size_t rays = 20'000;
};

// Meshes that move ever farther from where they were built: a cloth that swings and crumples, the guard through his walk,
// fragments that fly apart. For each: how much the cost by SAH has grown, how much longer rays take than in a new tree
// (same rays, in turn), and how many rays a tick it takes for a build instead of a refit to pay.
void bench_refit(Report& report, const RefitOptions& options);

}  // namespace bench
