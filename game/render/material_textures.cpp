#include "render/material_textures.h"

namespace gh::render {

MaterialTextures textures_of(const world::Material& material) {
    using Slot = world::TextureSlot;
    MaterialTextures which;
    const auto add = [&](std::uint32_t texture, Slot slot) {
        if (texture != world::kNoIndex) which.slots[which.count++] = {texture, slot};
    };
    add(material.base_color_texture, Slot::BaseColor);
    add(material.metallic_roughness_texture, Slot::MetallicRoughness);
    add(material.normal_texture, Slot::Normal);
    if (material.emission != glm::vec3(0.0f)) add(material.emission_texture, Slot::Emission);
    if (material.transmission > 0.0f) add(material.transmission_texture, Slot::Transmission);
    if (!material.has_layers) return which;
    const world::Layers& layers = material.layers;
    add(layers.specular_texture, Slot::Specular);
    add(layers.specular_color_texture, Slot::SpecularColor);
    add(layers.coat_texture, Slot::Coat);
    add(layers.coat_roughness_texture, Slot::CoatRoughness);
    add(layers.sheen_color_texture, Slot::SheenColor);
    add(layers.sheen_roughness_texture, Slot::SheenRoughness);
    if (layers.anisotropy > 0.0f) add(layers.anisotropy_texture, Slot::Anisotropy);
    if (layers.coat > 0.0f) add(layers.coat_normal_texture, Slot::CoatNormal);
    return which;
}

Texels look_up(const std::vector<MipTexture>& textures, const world::Material& material,
               const MaterialTextures& which, const TexturePlace& place, const MetCone& cone,
               float max_taps) {
    Texels texels;
    if (which.count == 0) return texels;
    TextureLookUps looks;
    for (std::uint32_t i = 0; i < which.count; ++i) {
        const auto [texture, slot] = which.slots[i];
        looks.add(textures[texture], place_of(material, slot, place), cone);
    }
    looks.work_out(max_taps);
    for (std::uint32_t i = 0; i < which.count; ++i)
        texels.values[static_cast<std::size_t>(which.slots[i].slot)] = looks.value(i);
    return texels;
}

}  // namespace gh::render
