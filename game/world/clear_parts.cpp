#include "world/clear_parts.h"

#include "world/layers.h"

#include <algorithm>

namespace gh::world {

bool has_clear_triangles(const Level& level, const Mesh& mesh) {
    return std::any_of(mesh.materials.begin(), mesh.materials.end(), [&](std::uint32_t id) {
        const Material& material = level.materials[id];
        return material.transmission > 0.0f || material.alpha_mode != AlphaMode::Opaque;
    });
}

void mark_clear_parts(Level& level) {
    for (Part& part : level.parts) {
        part.layers &= ~(Blocker | Clear);
        if ((part.layers & Light) == 0) continue;
        part.layers |= has_clear_triangles(level, level.meshes[part.mesh]) ? Clear : Blocker;
    }
}

}  // namespace gh::world
