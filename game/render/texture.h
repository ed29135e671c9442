// render/texture.h - textures as a ray sees them: blurred to just the patch of surface its pixel covers.
//
// Memory    a third more than the level's own bytes, which level 0 borrows: the Level must outlive it.
// Cost      8 texels a tap; one tap face on, up to 8 along the stretched side at grazing angles.
// Same bits pure; averages are made in linear light, in index order.
#pragma once

#include "world/level.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace gh::render {

enum class Encoding : std::uint8_t { Srgb, Linear };  // of red, green and blue; alpha is always linear

// The patch of texture under one pixel: two half-axes of an ellipse, in texture units (1 is the whole side).
struct Footprint {
    glm::vec2 major{0.0f};
    glm::vec2 minor{0.0f};
};

class MipTexture {
  public:
    MipTexture(const world::Texture& texture, Encoding encoding);

    // Linear values at `uv` (v runs down), averaged over the footprint. A uv that is not finite counts as (0, 0).
    [[nodiscard]] glm::vec4 sample(glm::vec2 uv, const Footprint& footprint) const;

    [[nodiscard]] int level_count() const { return static_cast<int>(levels_.size()); }

  private:
    struct Size {
        int width;
        int height;
    };
    [[nodiscard]] std::span<const std::uint8_t> texels(int level) const;
    [[nodiscard]] glm::vec4 texel(int level, int x, int y) const;
    [[nodiscard]] glm::vec4 bilinear(int level, const glm::vec2& uv) const;
    [[nodiscard]] glm::vec4 trilinear(float level, const glm::vec2& uv) const;
    void add_level(int from);

    std::vector<Size> levels_;
    std::span<const std::uint8_t> whole_;             // level 0, the level's own
    std::vector<std::vector<std::uint8_t>> smaller_;  // level 1 and on
    world::Wrap wrap_u_;
    world::Wrap wrap_v_;
    Encoding encoding_;
};

}  // namespace gh::render
