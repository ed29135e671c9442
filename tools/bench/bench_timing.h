// bench_timing.h - wall and processor time of work that may use several threads, gathered round by round.
#pragma once

#include "bench_report.h"

#include <string>

namespace bench {

struct Timing {
    Samples wall, core;

    template <class Work>
    void run(Work&& work) {
        const double w = clock_ms(), c = cpu_ms();
        work();
        add(clock_ms() - w, cpu_ms() - c);
    }
    void add(double wall_ms, double core_ms) {
        wall.ms.push_back(wall_ms);
        core.ms.push_back(core_ms);
    }
};

// How many times as fast as `peer`, by wall and by processor time: "1.31 / 1.28".
inline std::string times_as_fast(const Timing& ours, const Timing& peer) {
    const auto median = [](const Samples& a, const Samples& b) {
        Samples ratio;
        for (std::size_t i = 0; i < std::min(a.ms.size(), b.ms.size()); ++i)
            ratio.ms.push_back(b.ms[i] / a.ms[i]);
        return ratio.at(0.5);
    };
    char text[48];
    std::snprintf(text, sizeof(text), "%.2f / %.2f", median(ours.wall, peer.wall),
                  median(ours.core, peer.core));
    return text;
}

}  // namespace bench
