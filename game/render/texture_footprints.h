// render/texture_footprints.h - where in a texture the patch lies that a pixel covers, and how many taps of which level
// stand for it: sixteen patches side by side.
//
// Cost      about 10 ns a patch where all sixteen are used, and little more than one alone would take where fewer are.
// Same bits for every instruction set: one IEEE operation at a time, no fused ones, nothing of the C library.
// Threads   pure.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gh::render {

inline constexpr std::size_t kPatches = 16;

// Plain numbers, since this crosses into code compiled for other instruction sets; what is not asked may hold anything.
struct TexturePatches {
    using Lanes = float[kPatches];
    // Asked. A patch is what a cone around the ray cuts out of a plane; texture units are 1 for a whole side.
    alignas(64) Lanes direction[3], normal[3];       // unit
    alignas(64) Lanes cone_width;                    // metres, where the ray ends
    alignas(64) Lanes u_gradient[3], v_gradient[3];  // texture units a metre
    alignas(64) Lanes uv[2];                         // of its middle; what is not finite counts as (0, 0)
    alignas(64) Lanes size[2];                       // of the finest level, texels
    alignas(64) Lanes last_level;
    // Answered.
    alignas(64) Lanes first[2], step[2];  // taps, in texture units
    alignas(64) Lanes level;              // 0 is the finest
    alignas(64) Lanes taps;
};

// Answers the first `count` of them, with at most `max_taps` taps each: what is longer is blurred across as well.
void place_taps(TexturePatches& patches, std::size_t count, float max_taps);

}  // namespace gh::render
