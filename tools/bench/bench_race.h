// bench_race.h - contestants answer the same rays in turn, round by round, so that a slow second of the machine hits all
// alike. Time is processor time of the asking threads (the slowest of them): what others on the machine take is not
// counted. Ratios are formed within a round.
#pragma once

#include "bench_rays.h"
#include "bench_report.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace bench {

struct Contestant {
    std::string name;
    std::function<Answer(std::span<const rc::Ray> rays, bool any)> ask;
};

struct RaceOptions {
    int rounds = 7;
    unsigned threads = 1;
};

// Everybody's Mrays/s: speed[contestant][set] over the rounds, and what was answered.
struct RaceResult {
    std::vector<std::vector<Samples>> speed;
    std::vector<std::vector<Answer>> answers;
};

[[nodiscard]] RaceResult race(const std::vector<Contestant>& contestants, const std::vector<RaySet>& sets,
                              const RaceOptions& options);

// Round by round, a / b.
[[nodiscard]] Samples ratio_of(const Samples& a, const Samples& b);

// Prints speeds with the ratio to contestant `reference`.
void report_race(Report& report, const std::string& title, const std::vector<Contestant>& contestants,
                 const std::vector<RaySet>& sets, const RaceResult& result, std::size_t reference);

// Prints how many rays hit and the hash of who was hit: hits ought to agree; hashes may differ between libraries where
// two triangles lie in one place or a ray meets an edge.
void report_answers(Report& report, const std::string& title, const std::vector<Contestant>& contestants,
                    const std::vector<RaySet>& sets, const RaceResult& result);

}  // namespace bench
