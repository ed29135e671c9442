// render/probe_weights.h - which of the eight grid points around a place light it, and how much: the inner loop of the
// baked light, eight points at a time.
//
// Cost      about 100 ns. Same bits for every instruction set: one IEEE operation at a time, no fused ones, and sums in
//           the order of the points.
// Threads   pure.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gh::render {

inline constexpr int kSightSide = 6;  // texels a side of the octahedral map of what a grid point sees
inline constexpr std::size_t kSightMoments = 2 * kSightSide * kSightSide;

// Plain numbers, since this crosses into code compiled for other instruction sets.
struct ProbeQuery {
    const float* moments;  // kSightMoments a grid point: mean distance, mean squared distance, texel by texel
    const std::uint32_t* point;  // of the eight corners; corner i lies towards bit 0: x, bit 1: y, bit 2: z
    const float* plain;          // of each corner: trilinear weight, 0 where it says nothing
    float from[3], low[3];       // the place, and corner 0, metres
    float spacing[3], normal[3];
};

// weight[i]: plain[i] times how much corner i faces the surface and the chance that nothing is in between.
void weigh_probes(const ProbeQuery& query, float weight[8]);

}  // namespace gh::render
