// figures.h - repeated measurements: medians with quartiles, and the hash of what was answered, so that a fast wrong
// answer is caught.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace bench {

inline double clock_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

// Of all this process's threads: what one-threaded work costs a core, even while others keep the machine busy.
inline double cpu_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

// Of the calling thread alone.
inline double thread_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

struct Samples {
    std::vector<double> ms;

    [[nodiscard]] double at(double share) const {
        if (ms.empty()) return 0.0;
        std::vector<double> sorted = ms;
        std::sort(sorted.begin(), sorted.end());
        return sorted[static_cast<std::size_t>(std::lround(share * static_cast<double>(sorted.size() - 1)))];
    }
};

// Times `work` `rounds` times with `clock`; a sample is divided by `calls`, the number of calls one `work` makes.
inline Samples measure(double (*clock)(), int rounds, std::size_t calls,
                       const std::function<void(int round)>& work) {
    Samples samples;
    for (int round = 0; round < rounds; ++round) {
        const double start = clock();
        work(round);
        samples.ms.push_back((clock() - start) / static_cast<double>(calls));
    }
    return samples;
}

inline void print_head(const char* what) {
    std::printf("\n%-44s %9s  %19s  %s\n", what, "median ms", "[quartiles]", "answer");
}

inline void print_row(const std::string& name, const Samples& samples, std::uint64_t answer = 0) {
    std::printf("%-44s %9.4f  [%8.4f %8.4f]  ", name.c_str(), samples.at(0.5), samples.at(0.25),
                samples.at(0.75));
    if (answer != 0) std::printf("%016llx", static_cast<unsigned long long>(answer));
    std::printf("\n");
    std::fflush(stdout);
}

}  // namespace bench
