// tests/render/shaded.h - a surface by itself, to be asked what it does with light.
#pragma once

#include "render/bsdf.h"
#include "render/gloss_energy.h"
#include "render/shading_point.h"

#include <glm/vec3.hpp>

#include <cmath>

namespace gh::test {

// Something to be shaded, facing +z.
[[nodiscard]] inline render::ShadingPoint facing_z(const world::Material& material) {
    render::ShadingPoint at;
    at.material = &material;
    at.geometric = at.normal = at.smooth = at.coat_normal = {0, 0, 1};
    at.base_color = glm::vec3(material.base_color);
    at.metallic = material.metallic;
    at.roughness = material.roughness;
    at.transmission = material.transmission;
    return at;
}

// A direction that makes an angle of this cosine with +z.
[[nodiscard]] inline glm::vec3 tilted(float cosine, float turn = 0.3f) {
    const float sine = std::sqrt(1.0f - cosine * cosine);
    return {sine * std::cos(turn), sine * std::sin(turn), cosine};
}

[[nodiscard]] inline const render::GlossEnergy& energy() {
    static const render::GlossEnergy table;
    return table;
}

}  // namespace gh::test
