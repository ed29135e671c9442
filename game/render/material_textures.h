// render/material_textures.h - what a material's textures hold at a place of a surface, all looked up together.
//
// Same bits pure.
#pragma once

#include "render/texture_lookups.h"
#include "world/material.h"

#include <glm/mat3x2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace gh::render {

// Those that shading looks up, in the slots' order.
struct MaterialTextures {
    struct Slot {
        std::uint32_t texture = world::kNoIndex;
        world::TextureSlot slot{};
    };
    std::uint32_t count = 0;
    std::array<Slot, world::kTextureSlots> slots{};
};
[[nodiscard]] MaterialTextures textures_of(const world::Material& material);

// By slot; 1 where there is none.
struct Texels {
    std::array<glm::vec4, world::kTextureSlots> values;
    Texels() { values.fill(glm::vec4(1.0f)); }
    [[nodiscard]] const glm::vec4& operator[](world::TextureSlot slot) const {
        return values[static_cast<std::size_t>(slot)];
    }
};
// `textures` are the level's, `which` and `place` the material's, the place as all slots start from it.
[[nodiscard]] Texels look_up(const std::vector<MipTexture>& textures, const world::Material& material,
                             const MaterialTextures& which, const TexturePlace& place, const MetCone& cone,
                             float max_taps);

// Where a texture of this slot is looked up.
[[nodiscard]] inline TexturePlace place_of(const world::Material& material, world::TextureSlot slot,
                                           const TexturePlace& place) {
    if (material.uv_transforms.empty()) return place;
    const glm::mat3x2& m = material.uv_transforms[static_cast<std::size_t>(slot)];
    return {.uv = m * glm::vec3(place.uv, 1.0f),
            .gradients = {place.gradients.u * m[0][0] + place.gradients.v * m[1][0],
                          place.gradients.u * m[0][1] + place.gradients.v * m[1][1]}};
}

}  // namespace gh::render
