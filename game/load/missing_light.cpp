#include "load/defaults.h"
#include "load/mesh_lamps.h"

#include <glm/geometric.hpp>

namespace gh::load {

void add_missing_light(LevelBuild& build) {
    if (!build.level.lamps.empty()) return;
    constexpr std::size_t kMostFound =
        64;  // a chandelier of emissive beads would be more than anyone can sample
    for (std::uint32_t i = 0; i < build.level.parts.size() && build.level.lamps.size() < kMostFound; ++i) {
        if (build.level.parts[i].mover != world::Mover::None) continue;
        std::optional<world::Lamp> lamp = lamp_of_part(build, i, MeshLampShape::Either);
        // A textured emission is a screen or a glowing seam of something: seen, but no lamp.
        if (lamp && !is_emission_textured(build, i)) build.level.lamps.push_back(std::move(*lamp));
    }
    if (!build.level.lamps.empty()) return;
    world::Lamp sun;
    sun.name = "(sun)";
    sun.shape = world::LampShape::Sun;
    sun.direction = glm::normalize(glm::vec3(-0.45f, -0.8f, -0.4f));
    sun.intensity = glm::vec3(3.0f, 2.9f, 2.7f);
    build.level.lamps.push_back(std::move(sun));
}

}  // namespace gh::load
