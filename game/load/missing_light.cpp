#include "load/defaults.h"
#include "load/mesh_lamps.h"

#include <glm/geometric.hpp>

#include <vector>

namespace gh::load {
namespace {

// Whether a mesh shines, and by a plain colour: a textured emission is a screen or a glowing seam of something,
// seen but no lamp.
std::vector<bool> plainly_shining_meshes(const LevelBuild& build) {
    std::vector<bool> shines(build.meshes.size(), false);
    for (std::uint32_t id = 0; id < shines.size(); ++id) {
        bool is_textured = false;
        for (const std::uint32_t material_id : build.meshes.mesh(id).materials) {
            const world::Material& material = build.materials.materials[material_id];
            if (material.emission == glm::vec3(0.0f)) continue;
            shines[id] = true;
            is_textured = is_textured || material.emission_texture != world::kNoIndex;
        }
        if (is_textured) shines[id] = false;
    }
    return shines;
}

}  // namespace

void add_missing_light(LevelBuild& build, bool hangs_sun) {
    if (!build.level.lamps.empty()) return;
    constexpr std::size_t kMostFound =
        64;  // a chandelier of emissive beads would be more than anyone can sample
    const std::vector<bool> shines = plainly_shining_meshes(build);
    for (std::uint32_t i = 0; i < build.level.parts.size() && build.level.lamps.size() < kMostFound; ++i) {
        if (build.level.parts[i].mover != world::Mover::None || !shines[build.level.parts[i].mesh]) continue;
        std::optional<world::Lamp> lamp = lamp_of_part(build, i, MeshLampShape::Either);
        if (lamp) build.level.lamps.push_back(std::move(*lamp));
    }
    if (!build.level.lamps.empty() || !hangs_sun) return;
    world::Lamp sun;
    sun.name = "(sun)";
    sun.shape = world::LampShape::Sun;
    sun.direction = glm::normalize(glm::vec3(-0.45f, -0.8f, -0.4f));
    sun.intensity = glm::vec3(3.0f, 2.9f, 2.7f);
    build.level.lamps.push_back(std::move(sun));
}

}  // namespace gh::load
