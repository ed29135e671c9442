// sense/walls.h - which walls a straight sound crosses, and what each takes.
//
// A wall is counted once, whichever way the sound runs: entering and leaving one part are its two faces; leaving the
// shell of one room and entering that of the next are the two faces of the wall between them; what lies inside
// another crossing of the same part (a panel let into a door) is no wall of its own; a lone face is a single sheet.
// A wall whose faces differ takes the larger loss of the two.
// Cost      one `crossings`. Threads: pure. Same bits: losses are summed along the way; whole decibels are exact.
#pragma once

#include "world/level.h"
#include "world/snapshot.h"
#include "world/surface.h"

#include "raycore/scene.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace gh::sense {

using BandDb = std::array<float, world::kBands>;

inline constexpr std::size_t kMaxBlockers = 4;

struct Walls {
    BandDb loss_db{};
    std::array<std::uint32_t, kMaxBlockers>
        parts{};  // the first few parts in the way, each once, in index order
    std::size_t part_count = 0;
};

[[nodiscard]] Walls walls_between(const world::Level& level, const rc::Scene& scene, const glm::vec3& from,
                                  const glm::vec3& to);

}  // namespace gh::sense
