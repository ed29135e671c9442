// speed_error/clocks.h - time as a cost: what the processor spent, and what a player waits.
#pragma once

#include <chrono>
#include <ctime>

namespace speed_error {

// Of all threads of this program together.
[[nodiscard]] inline double core_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

[[nodiscard]] inline double wall_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace speed_error
