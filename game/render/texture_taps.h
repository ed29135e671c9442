// render/texture_taps.h - the inner loop of texture look-ups: eight texels a tap, four channels at a time.
//
// Cost      about 10 ns a tap where texels are near.
// Same bits for every instruction set: one IEEE operation at a time, no fused ones, taps in their order.
// Threads   pure.
#pragma once

#include <cstdint>

namespace gh::render {

inline constexpr int kBlockSide = 4;  // texels are stored in blocks of 4x4, row by row, and so are blocks

// One level of a texture: linear light or plain numbers, 65535 is 1. Plain numbers, since this crosses into code
// compiled for other instruction sets.
struct MipView {
    const std::uint16_t* rgba = nullptr;
    int width = 0, height = 0;  // texels, at least 1
    int blocks_across = 0;
};

enum class Edge : std::uint8_t { Repeat, Clamp, Mirror };

struct TapQuery {
    MipView fine, coarse;
    float blend = 0.0f;  // how much of the coarse one, in [0, 1); it is not looked at when 0
    float uv[2]{};       // of the first tap; all taps finite and within +-2e6
    float step[2]{};     // from tap to tap
    int taps = 1;        // at least 1
    Edge edge[2]{};      // what lies outside [0, 1]
};

// The mean of the taps, each bilinear in both levels.
void average_taps(const TapQuery& query, float rgba[4]);

}  // namespace gh::render
