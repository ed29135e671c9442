// app/commands.h - the four things the program does. Each returns its exit code: 0 fine; 2 a file or device that
// cannot be used, said in one sentence on stderr; 3 a replay that diverged.
#pragma once

#include "app/options.h"
#include "base/result.h"
#include "world/level.h"

namespace gh::app {

inline constexpr int kExitFine = 0;
inline constexpr int kExitUnusable = 2;
inline constexpr int kExitDiverged = 3;

[[nodiscard]] int play(const PlayOptions& options);
[[nodiscard]] int replay(const ReplayOptions& options);
[[nodiscard]] int render(const RenderOptions& options);
[[nodiscard]] int inspect(const InspectOptions& options);

// "glasshouse: SENTENCE" on stderr; returns kExitUnusable.
[[nodiscard]] int refuse(const Error& error);

// What was odd in the level's file, a line each on stderr.
void tell(const world::Level& level);

void apply(const MachineOptions& machine);

}  // namespace gh::app
