// app/hints.h - what somebody who plays for the first time is told, each thing once, at the moment it becomes useful.
//
// Who has done a thing is not told of it any more, and a line goes when what it asks for is done. Reads the State,
// decides nothing in it.
#pragma once

#include "world/level.h"
#include "world/snapshot.h"

#include <array>
#include <cstdint>
#include <optional>

namespace gh::app {

// The first ones interrupt the others.
enum class Lesson : std::uint8_t { Chase, Search, Doubt, Exit, Goal, HandMirror, Light, Crouch, Lean, Stone };
inline constexpr std::size_t kLessons = 10;

class Hints {
  public:
    void note_tick(const world::Level& level, const world::Snapshot& now);

    // What is shown now; none between two lines.
    [[nodiscard]] std::optional<Lesson> lesson() const { return shown_; }
    // 0 gone .. 1 fully there.
    [[nodiscard]] float strength() const;

  private:
    void learn(const world::Level& level, const world::State& state);
    void show(Lesson lesson);

    std::array<std::uint8_t, kLessons> is_known_{};
    std::optional<Lesson> shown_;
    float age_ = 0.0f;   // seconds the line has stood
    float left_ = 0.0f;  // seconds it will
    float rest_ = 0.0f;  // seconds of quiet before the next
};

}  // namespace gh::app
