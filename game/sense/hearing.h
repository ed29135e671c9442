// sense/hearing.h - what of a sound arrives: one computation for the guards' ears and the player's.
//
// Sound takes the loudest of three ways, band by band:
//   through   the straight line: 1/r, and every wall on it takes its transmission loss (walls.h).
//   around    past an edge of a thing that stands between (a column, a case, a door ajar): 1/r along the bent way, the
//             barrier loss of Kurze and Anderson (1971), and the loss of what stands in either leg.
//   detour    past the corners the caller knows (a path on the navmesh, at ear height): 1/r along all of it, a barrier
//             loss a corner, and the loss of what closes a leg: a shut door on the way silences it.
//
// Symmetric swapping source and ear (and reversing the detour) changes nothing but `arrives_from`.
// Layers    Sound. Bodies and stones take nothing.
// Cost      one `crossings`; when blocked, up to 24 more a thing in between, and one a leg of the detour.
// Threads   pure. Same bits: no libm.
#pragma once

#include "world/level.h"
#include "world/snapshot.h"
#include "world/surface.h"

#include "raycore/scene.h"

#include <glm/vec3.hpp>

#include <array>
#include <span>

namespace gh::sense {

inline constexpr float kSilenceDb = -120.0f;  // nothing is ever quieter than that

// How a sound arrives from a source that would be heard at 0 dB from 1 m away in the open.
struct Transmission {
    std::array<float, world::kBands> band_gain{};  // amplitude, in [0, 10]: 1 is 1 m away in the open
    std::array<float, world::kBands> band_db{};    // the same in dB, at least kSilenceDb
    float metres = 0.0f;                           // along the loudest way: delay = metres / 343 s
    glm::vec3 arrives_from{
        0.0f};  // where the loudest way seems to come from: the source, an edge or a corner
};

[[nodiscard]] Transmission hear(const world::Level& level, const rc::Scene& scene, const glm::vec3& source,
                                const glm::vec3& ear, std::span<const glm::vec3> detour = {});

// Level at the ear, in dB, of a noise of `loudness_db` at 1 m with the same power in each band.
[[nodiscard]] float level_db(float loudness_db, const Transmission& transmission);

// Loss of a sound bent over an edge that makes its way `extra_metres` longer (>= 0) at `frequency` Hz: 5 dB
// at the edge of the shadow, 24 dB at most.
[[nodiscard]] float barrier_loss_db(float extra_metres, float frequency);

}  // namespace gh::sense
