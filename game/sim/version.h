// sim/version.h - raised whenever the same commands no longer give the same states. Recordings of another version
// are refused, and tools/record_replays makes the bundled ones anew.
#pragma once

#include <cstdint>

namespace gh::sim {

inline constexpr std::uint32_t kSimulationVersion = 4;

}  // namespace gh::sim
