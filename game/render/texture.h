// render/texture.h - textures as a ray sees them: blurred to just the patch of surface its pixel covers.
//
// Memory    four thirds of the level's own bytes, in blocks of 4x4 texels, one cache line each.
// Cost      8 texels a tap, about 25 ns where they are near; one tap face on, up to 8 along the stretched side at
//           grazing angles.
// Same bits pure; averages are made in linear light, in index order.
#pragma once

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
        std::size_t blocks_across = 0;
        std::vector<std::uint32_t> rgba;  // red in the lowest byte

        Mip(int width, int height);
        [[nodiscard]] std::size_t index(int x, int y) const {
            const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
            return ((row >> 2) * blocks_across + (column >> 2)) * 16 + (row & 3) * 4 + (column & 3);
        }
    };
    [[nodiscard]] glm::vec4 linear(std::uint32_t texel) const;
    [[nodiscard]] std::uint32_t encoded(const glm::vec4& mean) const;
    [[nodiscard]] glm::vec4 bilinear(const Mip& mip, const glm::vec2& uv) const;
    [[nodiscard]] glm::vec4 trilinear(float level, const glm::vec2& uv) const;
    [[nodiscard]] Mip halved(const Mip& big) const;

    std::vector<Mip> mips_;
    world::Wrap wrap_u_;
    world::Wrap wrap_v_;
    Encoding encoding_;
};

}  // namespace gh::render
