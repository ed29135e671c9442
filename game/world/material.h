// world/material.h - what surfaces are made of: textures, and materials as glTF 2.0 has them. Filled by load, and of a
// Level (level.h), which never changes.
//
// Units     linear radiance (W/m2/sr per colour), metres.
// Threads   immutable after loading.
#pragma once

#include "world/surface.h"

#include "raycore/ray.h"

#include <glm/mat3x2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace gh::world {

inline constexpr std::uint32_t kNoIndex = 0xFFFFFFFFu;

enum class Wrap : std::uint8_t { Repeat, Clamp, Mirror };

struct Texture {
    std::string name;
    int width = 0;  // pixels, >= 1
    int height = 0;
    Wrap wrap_u = Wrap::Repeat;
    Wrap wrap_v = Wrap::Repeat;
    std::vector<std::uint8_t> rgba;  // rows top to bottom, as in the file: sRGB for colours, linear for data
};

enum class AlphaMode : std::uint8_t { Opaque, Mask, Blend };

// The textures a material may have, in the order of Material::uv_transforms.
enum class TextureSlot : std::uint8_t {
    BaseColor,
    MetallicRoughness,
    Normal,
    Emission,
    Specular,
    SpecularColor,
    Coat,
    CoatRoughness,
    SheenColor,
    SheenRoughness,
    Anisotropy,
    CoatNormal,
    Transmission
};
inline constexpr std::size_t kTextureSlots = 13;

// Colours are sRGB; all else is numbers.
[[nodiscard]] constexpr bool holds_colors(TextureSlot slot) {
    return slot == TextureSlot::BaseColor || slot == TextureSlot::Emission ||
           slot == TextureSlot::SpecularColor || slot == TextureSlot::SheenColor;
}

// What few materials have: KHR_materials_specular's colour, _clearcoat, _sheen, _anisotropy.
struct Layers {
    glm::vec3 specular_color{1.0f};  // of the dielectric's reflection head on
    glm::vec3 sheen_color{0.0f};
    float sheen_roughness = 0.0f;
    float coat = 0.0f;  // share of the surface that is varnished
    float coat_roughness = 0.0f;
    float anisotropy = 0.0f;                           // 0: round highlights, 1: drawn out along the tangent
    float anisotropy_rotation = 0.0f;                  // of that way, from the tangent towards the bitangent
    std::uint32_t specular_texture = kNoIndex;         // A
    std::uint32_t specular_color_texture = kNoIndex;   // RGB
    std::uint32_t coat_texture = kNoIndex;             // R
    std::uint32_t coat_roughness_texture = kNoIndex;   // G
    std::uint32_t sheen_color_texture = kNoIndex;      // RGB
    std::uint32_t sheen_roughness_texture = kNoIndex;  // A
    std::uint32_t anisotropy_texture = kNoIndex;       // RG direction, B strength
    std::uint32_t coat_normal_texture = kNoIndex;
    float coat_normal_scale = 1.0f;
};

// glTF 2.0 metallic-roughness with transmission, ior, volume and emissive strength. Texture ids may be kNoIndex.
// KHR_materials_unlit is a black material that shines in its base colour.
struct Material {
    std::string name;
    glm::vec4 base_color{1.0f};  // linear
    float metallic = 0.0f;
    float roughness = 1.0f;
    float transmission = 0.0f;
    float ior = 1.5f;
    float specular = 1.0f;  // KHR_materials_specular: share of the dielectric's reflection that is there
    glm::vec3 attenuation_color{1.0f};           // of light after attenuation_distance inside
    float attenuation_distance = rc::kInfinity;  // metres
    glm::vec3 emission{0.0f};                    // radiance: factor x strength
    float alpha_cutoff = 0.5f;
    float normal_scale = 1.0f;
    AlphaMode alpha_mode = AlphaMode::Opaque;
    Surface surface = Surface::Plaster;
    bool is_double_sided = false;
    std::int16_t priority = 0;  // of a body of glass: where bodies overlap, the one with the highest is there
    std::uint32_t base_color_texture = kNoIndex;
    std::uint32_t metallic_roughness_texture = kNoIndex;  // G roughness, B metallic
    std::uint32_t normal_texture = kNoIndex;
    std::uint32_t emission_texture = kNoIndex;
    std::uint32_t transmission_texture = kNoIndex;  // R
    Layers layers;
    bool has_layers = false;  // something in `layers` is not as it is there
    // One a TextureSlot: where its texture is looked up, from the mesh's uv (columns u, v, offset). Empty: as it is.
    std::vector<glm::mat3x2> uv_transforms;
};

}  // namespace gh::world
