// render/texture_taps.h - the inner loop of texture look-ups: eight texels a tap, four channels at a time.
//
// Cost      about 10 ns a tap where texels are near.
// Same bits for every instruction set: one IEEE operation at a time, no fused ones, taps in their order.
// Threads   pure.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gh::render {

inline constexpr int kBlockSide = 4;  // texels are stored in blocks of 4x4, row by row, and so are blocks

// One level of a texture: linear light or plain numbers, 65535 is 1.
struct MipView {
    const std::uint16_t* rgba = nullptr;
    int width = 0, height = 0;  // texels, at least 1
    int blocks_across = 0;
};

enum class Edge : std::uint8_t { Repeat, Clamp, Mirror };

// Two levels that are looked up together along one axis, as the inner loop wants them: numbers of the fine one and of the
// coarse one by turns. Plain numbers, since this crosses into code compiled for other instruction sets.
struct MipAxis {
    alignas(16) float size[4]{};
    alignas(16) std::int32_t last[4]{};
    alignas(16) std::int32_t below[4]{}, above[4]{};  // texel -1, and the one behind the last
    alignas(16) std::int32_t block_step[4]{};         // from block to block, in texels
    std::int32_t texel_step = 0;                      // within one
    Edge edge = Edge::Repeat;                         // what lies outside [0, 1]
};

struct MipPair {
    MipAxis axis[2];  // u and v
};
[[nodiscard]] MipPair mip_pair(const MipView& fine, const MipView& coarse, Edge edge_u, Edge edge_v);

inline constexpr int kMostTaps = 8;

struct TapQuery {
    const MipPair* levels;
    const std::uint16_t* fine;  // as MipView::rgba
    const std::uint16_t* coarse;
    float blend;    // how much of the coarse one, in [0, 1); it is not looked at when 0
    float uv[2];    // of the first tap; all taps finite and within +-2e6
    float step[2];  // from tap to tap
    int taps;       // 1 to kMostTaps
};

// The means of the taps, each bilinear in both levels: four numbers a query. Memory is asked for ahead.
void average_taps(const TapQuery* queries, std::size_t count, float* rgba);

}  // namespace gh::render
