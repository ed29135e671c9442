// render/texture.h - textures as a ray sees them: blurred to just the patch of surface its pixel covers.
//
// Memory    eight thirds of the level's own bytes: 16 bits of linear light a channel, in blocks of 4x4 texels.
// Cost      8 texels a tap (texture_taps.h); one tap face on, up to 8 along the stretched side at grazing angles.
// Same bits pure; averages are made in index order.
#pragma once

#include "render/texture_taps.h"
#include "world/level.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gh::render {

enum class Encoding : std::uint8_t { Srgb, Linear };  // of red, green and blue; alpha is always linear

// The patch of texture under one pixel: two half-axes of an ellipse, in texture units (1 is the whole side).
struct Footprint {
    glm::vec2 major{0.0f};
    glm::vec2 minor{0.0f};
};

inline constexpr float kMostTaps = 8.0f;

class MipTexture {
  public:
    MipTexture(const world::Texture& texture, Encoding encoding);

    // Linear values at `uv` (v runs down), averaged over the footprint with at most `max_taps` taps: what is longer is
    // blurred across as well. A uv that is not finite counts as (0, 0).
    [[nodiscard]] glm::vec4 sample(glm::vec2 uv, const Footprint& footprint,
                                   float max_taps = kMostTaps) const;

    [[nodiscard]] int level_count() const { return static_cast<int>(mips_.size()); }

  private:
    struct Mip {
        int width = 0, height = 0;  // texels
        int blocks_across = 0;
        std::vector<std::uint16_t> rgba;

        Mip(int width, int height);
        [[nodiscard]] std::uint16_t* texel(int x, int y);
        // The mean of the texels from `begin` up to `end`, which is not among them.
        void average(const glm::ivec2& begin, const glm::ivec2& end, std::uint16_t* mean);
        [[nodiscard]] MipView view() const { return {rgba.data(), width, height, blocks_across}; }
    };
    [[nodiscard]] static Mip halved(Mip& big);

    std::vector<Mip> mips_;
    std::vector<MipPair> pairs_;  // every level and the next
};

}  // namespace gh::render
