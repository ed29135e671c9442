// app/profile.h - ms by room, for the F3 overlay and the headless summary. Reads the clock so that nobody else must.
//
// Threads   one.
#pragma once

#include "present/profiler.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace gh::app {

using Clock = std::chrono::steady_clock;

[[nodiscard]] inline float milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<float, std::milli>(Clock::now() - start).count();
}

// Named stretches of time that follow each other: enter("render") ends the stretch before. The figures are means over
// the last kWindow rounds.
class Stopwatch {
  public:
    static constexpr std::size_t kWindow = 60;

    void begin_round();
    void enter(const std::string& room);
    void end_round();

    [[nodiscard]] float round_ms() const;                          // mean
    [[nodiscard]] std::vector<present::ProfileRow> rooms() const;  // in the order they were first entered
    [[nodiscard]] std::vector<float> history_ms() const;           // of whole rounds, oldest first
    [[nodiscard]] std::size_t rounds() const { return rounds_; }

  private:
    struct Room {
        std::string name;
        std::array<float, kWindow> ms{};
    };
    void close_stretch();
    [[nodiscard]] float mean(const std::array<float, kWindow>& ms) const;

    std::vector<Room> rooms_;
    std::array<float, kWindow> round_ms_{};
    std::size_t rounds_ = 0;
    std::size_t open_ = 0;  // index of the running stretch + 1; 0: none
    Clock::time_point round_start_{};
    Clock::time_point stretch_start_{};
};

}  // namespace gh::app
