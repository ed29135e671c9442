// filter/rows.h - a picture's rows over all threads.
#pragma once

#include "base/jobs.h"
#include "filter/plane.h"

#include <algorithm>
#include <cstddef>

namespace gh::filter {

// Rows an item holds: enough that starting it costs nothing, few enough that two cores end together.
inline constexpr int kRowsAtOnce = 8;

// Calls row(y) once for every y in [0, height), in any order and on any thread.
template <class Row>
void run_rows(int height, const Jobs& jobs, const Row& row) {
    const int bands = (height + kRowsAtOnce - 1) / kRowsAtOnce;
    jobs.run(static_cast<std::size_t>(bands), [&](std::size_t band, int) {
        const int begin = static_cast<int>(band) * kRowsAtOnce;
        for (int y = begin; y < std::min(begin + kRowsAtOnce, height); ++y) row(y);
    });
}

// The same with rows `step` apart following each other: filters that look `step` rows up and down then find what they
// need still in the cache.
template <class Row>
void run_rows_apart(int height, int step, const Jobs& jobs, const Row& row) {
    const int whole = height / step, more = height % step;  // `more` of the combs have one tooth more
    run_rows(height, jobs, [&](int i) {
        const int in_long = more * (whole + 1);
        const int comb = i < in_long ? i / (whole + 1) : more + (i - in_long) / std::max(1, whole);
        const int tooth = i < in_long ? i % (whole + 1) : (i - in_long) % std::max(1, whole);
        row(tooth * step + comb);
    });
}

// The three rows of a vector or colour.
inline void point_to(const float* to[3], const Plane3& planes, int y) {
    to[0] = planes.x.row(y);
    to[1] = planes.y.row(y);
    to[2] = planes.z.row(y);
}
inline void point_to(float* to[3], Plane3& planes, int y) {
    to[0] = planes.x.row(y);
    to[1] = planes.y.row(y);
    to[2] = planes.z.row(y);
}

}  // namespace gh::filter
