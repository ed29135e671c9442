// bench_errors.h - how right: rays that must hit, for raycore and for Embree side by side, and what each triangle test and
// each structure pays for its errors.
#pragma once

#include "bench_report.h"

#include <cstddef>

namespace bench {

struct ErrorOptions {
    std::size_t rays = 1'000'000;  // of the largest case; the others ask a share of it
    int rounds = 5;
    bool with_embree = true;
};

// Leaks through closed meshes, rays onto grids, slivers and bad vertices; answers that differ between instruction sets,
// batches, and powers of two of the scale. Counts, out of so many; 0 is what is promised.
void bench_hard_cases(Report& report, const ErrorOptions& options);

// How many of the same rays are answered differently in a bit, or by another triangle, when only the instruction set, the
// batch, the scale (by a power of two) or the order of the triangles changes.
void bench_same_bits(Report& report, const ErrorOptions& options);

// Mrays/s beside leaks, wrong hits and the error of t against double precision: brute force, grid, kD-tree with
// Moeller-Trumbore, Woop's and raycore's own test; raycore on every instruction set; Embree fast, robust, in packets.
void bench_speed_error(Report& report, const ErrorOptions& options);

}  // namespace bench
