// app/recording.h - a run on its way into a replay file, and what a replay must fit to be played again.
//
//   auto recorder = Recorder::start(path, recording_header("foyer", level, seed));
//   simulation.step(command);
//   recorder->note_tick(command, simulation.state());
//   recorder->finish();
#pragma once

#include "base/result.h"
#include "input/replay.h"
#include "world/level.h"
#include "world/state.h"

#include <filesystem>
#include <string>

namespace gh::app {

// `level_name`: what resolve_level takes, so that the replay finds its level again.
[[nodiscard]] input::ReplayHeader recording_header(const std::string& level_name, const world::Level& level,
                                                   std::uint32_t seed);

class Recorder {
  public:
    [[nodiscard]] static Result<Recorder> start(const std::filesystem::path& path,
                                                input::ReplayHeader header);

    // After the tick: `state` is what `command` led to.
    Result<void> note_tick(const input::Command& command, const world::State& state);
    Result<void> finish();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    Recorder(std::filesystem::path path, input::ReplayWriter writer);
    std::filesystem::path path_;
    input::ReplayWriter writer_;
};

// A name for a run that was not given one: recordings/2026-11-22_21-04-05_foyer.rec, never one that exists.
[[nodiscard]] std::filesystem::path fresh_recording_path(const std::string& level_name);

}  // namespace gh::app
