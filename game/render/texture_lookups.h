// render/texture_lookups.h - textures as rays see them, looked up side by side: each blurred to just the patch of surface
// that its pixel covers.
//
//   TextureLookUps looks;
//   looks.add(texture, place, cone);       // up to kPatches of them
//   looks.work_out(max_taps);
//   ... looks.value(0) ...
//
// Cost      texture_footprints.h for all of them, texture_taps.h for each; memory of all is asked for before any is read.
// Same bits a value depends on what was asked alone, not on what else was asked with it.
#pragma once

#include "render/texture.h"
#include "render/texture_footprints.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>

namespace gh::render {

// How a texture's u and v change along a world vector in the triangle's plane; 0 where the triangle has no area.
struct UvGradients {
    glm::vec3 u{0.0f}, v{0.0f};
};

struct TexturePlace {
    glm::vec2 uv{0.0f};  // v runs down
    UvGradients gradients;
};

// The cone that a pixel covers, where it meets a plane.
struct MetCone {
    glm::vec3 direction{0.0f};  // unit
    glm::vec3 normal{0.0f};     // unit, of the plane
    float width = 0.0f;         // metres
};

class TextureLookUps {
  public:
    [[nodiscard]] std::size_t count() const { return count_; }
    void clear() { count_ = 0; }
    // Precondition: fewer than kPatches are there. The texture must live on.
    void add(const MipTexture& texture, const TexturePlace& place, const MetCone& cone);
    void work_out(float max_taps);
    // Of the i-th that was added, linear.
    [[nodiscard]] const glm::vec4& value(std::size_t i) const { return values_[i]; }

  private:
    std::size_t count_ = 0;  // of what is below; the rest may hold anything
    std::array<const MipTexture*, kPatches> textures_;
    TexturePatches patches_;
    std::array<glm::vec4, kPatches> values_;
};

}  // namespace gh::render
