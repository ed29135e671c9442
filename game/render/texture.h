// render/texture.h - a texture and smaller copies of it, each half as large as the one before: what rays look up
// (texture_lookups.h).
//
// Memory    eight thirds of the level's own bytes: 16 bits of linear light a channel, in blocks of 4x4 texels.
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

class MipTexture {
  public:
    MipTexture(const world::Texture& texture, Encoding encoding);

    // Linear values at `uv` (v runs down) of the finest level. A uv that is not finite counts as (0, 0).
    [[nodiscard]] glm::vec4 at(glm::vec2 uv) const;

    [[nodiscard]] glm::vec2 size() const { return size_; }  // texels
    [[nodiscard]] int level_count() const { return static_cast<int>(mips_.size()); }
    // Of a level and the next coarser one (the last twice): one tap at the origin, all of the fine one.
    [[nodiscard]] TapQuery query(std::size_t fine) const;

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

    glm::vec2 size_;
    std::vector<Mip> mips_;
    std::vector<MipPair> pairs_;  // every level and the next
};

}  // namespace gh::render
