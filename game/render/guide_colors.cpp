#include "render/guide_colors.h"

#include "render/material_textures.h"

namespace gh::render {

void GuideColors::add(const SceneView& view, const GuideTriangle& triangle, const rc::Hit& hit,
                      const MetCone& cone, const ColorSums& sums) {
    const world::Material& material = *triangle.material;
    const TexturePlace place{triangle.uv + triangle.uv_edge1 * hit.u + triangle.uv_edge2 * hit.v,
                             triangle.gradients};
    const auto add_one = [&](std::uint32_t texture, world::TextureSlot slot, const glm::vec3& factor,
                             glm::vec3* sum) {
        if (texture == world::kNoIndex || !triangle.is_textured) {
            *sum += factor;
            return;
        }
        if (looks_.count() == kPatches) flush();
        waiting_[looks_.count()] = {sum, factor};
        looks_.add(view.prepared.textures[texture], place_of(material, slot, place), cone);
    };
    *sums.albedo = guide_albedo(glm::vec3(0.0f), material.metallic);
    add_one(material.base_color_texture, world::TextureSlot::BaseColor, glm::vec3(material.base_color),
            sums.albedo);
    const glm::vec3 emission = sums.weight * material.emission;
    if (emission != glm::vec3(0.0f))
        add_one(material.emission_texture, world::TextureSlot::Emission, emission, sums.clean);
}

void GuideColors::flush() {
    looks_.work_out(max_taps_);
    for (std::size_t i = 0; i < looks_.count(); ++i)
        *waiting_[i].sum += waiting_[i].factor * glm::vec3(looks_.value(i));
    looks_.clear();
}

}  // namespace gh::render
