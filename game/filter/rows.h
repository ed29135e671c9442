// filter/rows.h - a picture's rows over all threads.
#pragma once

#include "base/jobs.h"
#include "filter/plane.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace gh::filter {

// Rows an item holds: enough that starting it costs nothing, few enough that two cores end together.
inline constexpr int kRowsAtOnce = 8;
// Of a strip through several passes, about: many, since what lies between two of them falls out of the cache.
inline constexpr int kStripRows = 90;

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

// Passes one after the other, of which each needs rows of the one before: up to reach[pass] above and below (the first
// needs none). Calls row(pass, y) once for each, as soon as what it needs is there, so that few rows lie between a pass
// and the next and are still in the cache. Strips of rows run on all threads, narrowing from pass to pass; then what is
// missing between them, widening. A pass may write where the one before the last wrote, if it reaches as far as that or
// further: whoever reads a row has done so by then.
template <class Row>
void run_passes(int height, std::span<const int> reach, const Jobs& jobs, const Row& row) {
    const int passes = static_cast<int>(reach.size());
    std::array<int, 24> lag{};  // rows a pass is behind the first
    EXPECTS(passes >= 1 && reach.size() <= lag.size());
    for (std::size_t pass = 1; pass < reach.size(); ++pass) lag[pass] = lag[pass - 1] + reach[pass];
    const int last = lag[reach.size() - 1];
    const int wanted = std::max((height + kStripRows - 1) / kStripRows, jobs.threads());
    const int strips = std::clamp(wanted, 1, std::max(1, height / std::max(1, 2 * last)));
    const auto begin_of = [&](int strip) { return strip * height / strips; };
    jobs.run(static_cast<std::size_t>(strips), [&](std::size_t strip, int) {
        const int begin = begin_of(static_cast<int>(strip)), end = begin_of(static_cast<int>(strip) + 1);
        for (int t = begin; t < end + last; ++t) {
            for (int pass = 0; pass < passes; ++pass) {
                const int behind = lag[static_cast<std::size_t>(pass)], y = t - behind;
                if (y >= begin + (begin > 0 ? behind : 0) && y < end - (end < height ? behind : 0))
                    row(pass, y);
            }
        }
    });
    jobs.run(static_cast<std::size_t>(strips - 1), [&](std::size_t strip, int) {
        const int border = begin_of(static_cast<int>(strip) + 1);
        for (int pass = 0; pass < passes; ++pass) {
            const int behind = lag[static_cast<std::size_t>(pass)];
            for (int y = border - behind; y < border + behind; ++y) row(pass, y);
        }
    });
}

// What a stage does to make its row `y`.
using RowWork = std::function<void(int y)>;

inline void run_rows(int height, const Jobs& jobs, const RowWork& work) {
    if (work) run_rows<RowWork>(height, jobs, work);
}

// Stages as the passes of run_passes(): what one leaves is still in the cache when the next reads it.
class RowPasses {
  public:
    // What is added from now on needs rows of what was added before: up to `reach` above and below.
    void begin(int reach) {
        reach_.push_back(reach);
        work_.emplace_back();
    }
    // Works of one pass follow each other on every row. An empty one does nothing.
    void add(RowWork work) {
        EXPECTS(!work_.empty());
        if (work) work_.back().push_back(std::move(work));
    }
    // To a pass that was begun already, the first being 0.
    void add_to(std::size_t pass, RowWork work) {
        EXPECTS(pass < work_.size());
        if (work) work_[pass].push_back(std::move(work));
    }
    // The passes of a picture of half the sides, rounded up, beside these, the first of them beside `first` (at least 1):
    // its row v may read rows 2 v and 2 v + 1 of what was added to the pass before. It is made with the second of those,
    // or with the last one there is.
    void add_halved(RowPasses half, int height, std::size_t first) {
        EXPECTS(first >= 1 && first <= work_.size());
        for (std::size_t i = 0; i < half.work_.size(); ++i) {
            if (first + i == work_.size()) begin(0);
            int& reach = reach_[first + i];
            reach = std::max(reach, 2 * half.reach_[i] + 1);
            for (RowWork& work : half.work_[i]) {
                add_to(first + i, [work = std::move(work), height](int y) {
                    if (y % 2 == 1 || y + 1 == height) work(y / 2);
                });
            }
        }
    }
    void run(int height, const Jobs& jobs) const {
        if (work_.empty() || height == 0) return;
        run_passes(height, reach_, jobs, [&](int pass, int y) {
            for (const RowWork& work : work_[static_cast<std::size_t>(pass)]) work(y);
        });
    }

  private:
    std::vector<int> reach_;
    std::vector<std::vector<RowWork>> work_;
};

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
