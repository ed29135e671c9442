#include "render/prepared.h"

#include "render/ambient_bake.h"
#include "render/clear_mesh.h"
#include "render/scene_view.h"
#include "world/clear_parts.h"
#include "world/layers.h"

#include <algorithm>
#include <optional>

namespace gh::render {

namespace {

// A texture is a colour if any material uses it as one; all others hold numbers.
std::vector<Encoding> encodings(const world::Level& level) {
    std::vector<Encoding> result(level.textures.size(), Encoding::Linear);
    for (const world::Material& material : level.materials) {
        for (const std::uint32_t texture :
             {material.base_color_texture, material.emission_texture, material.layers.specular_color_texture,
              material.layers.sheen_color_texture}) {
            if (texture != world::kNoIndex) result[texture] = Encoding::Srgb;
        }
    }
    return result;
}

std::vector<MipTexture> shrink_textures(const world::Level& level, const Jobs& jobs) {
    const std::vector<Encoding> encoding = encodings(level);
    std::vector<std::optional<MipTexture>> made(level.textures.size());
    jobs.run(made.size(), [&](std::size_t i, int) { made[i].emplace(level.textures[i], encoding[i]); });
    std::vector<MipTexture> textures;
    textures.reserve(made.size());
    for (std::optional<MipTexture>& texture : made) textures.push_back(std::move(*texture));
    return textures;
}

// Whether the level's maker told opaque parts from clear ones.
bool are_layers_split(const world::Level& level) {
    return std::all_of(level.parts.begin(), level.parts.end(), [](const world::Part& part) {
        const rc::LayerMask kind = part.layers & (world::Blocker | world::Clear);
        return (part.layers & world::Light) == 0 || kind == world::Blocker || kind == world::Clear;
    });
}

std::vector<PartTraits> part_traits(const world::Level& level, const Jobs& jobs) {
    std::vector<std::uint8_t> is_clear(level.meshes.size(), 0), is_solid(level.meshes.size(), 0);
    jobs.run(level.meshes.size(), [&](std::size_t i, int) {
        is_clear[i] = world::has_clear_triangles(level, level.meshes[i]) ? 1 : 0;
        is_solid[i] = is_clear[i] != 0 && is_closed_glass(level, level.meshes[i]) ? 1 : 0;
    });
    std::vector<PartTraits> parts(level.parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].is_clear = is_clear[level.parts[i].mesh] != 0;
        parts[i].is_solid_glass = is_solid[level.parts[i].mesh] != 0;
    }
    for (std::uint32_t i = 0; i < level.lamps.size(); ++i) {
        if (level.lamps[i].part != world::kNoIndex) parts[level.lamps[i].part].lamp = i;
    }
    return parts;
}

}  // namespace

Prepared prepare(const world::Level& level, const world::Snapshot& rest, const Jobs& jobs,
                 const PrepareSettings& settings) {
    Prepared prepared;
    prepared.textures = shrink_textures(level, jobs);
    prepared.parts = part_traits(level, jobs);
    std::vector<std::uint8_t> is_solid;
    for (const PartTraits& part : prepared.parts) is_solid.push_back(part.is_solid_glass ? 1 : 0);
    prepared.needs = scene_needs(level, is_solid);
    for (const world::Material& material : level.materials)
        prepared.material_textures.push_back(textures_of(material));
    prepared.energy = GlossEnergy(prepared.needs.has(Need::Cloth));
    prepared.emitters = find_emitters(level);
    const bool is_split = are_layers_split(level);
    for (const PartTraits& part : prepared.parts) prepared.has_clear_parts |= part.is_clear;
    prepared.blocking_layers = is_split ? world::Blocker : world::Light;
    for (const world::Lamp& lamp : level.lamps) prepared.bulbs.push_back(bulb_clearance(level, rest, lamp));

    const Grid grid = make_grid(level.bounds, settings.spacing, settings.max_cells);
    prepared.lamp_lists = find_lamp_lists(level, rest, prepared.bulbs, grid, settings.lamp_list_rays, jobs);
    prepared.gleams = find_gleams({level, rest, prepared}, grid, jobs);
    if (settings.bakes_ambient) {
        const BakeSettings bake{.rays = settings.rays, .bounces = settings.bounces};
        prepared.ambient = bake_ambient({level, rest, prepared}, grid, bake, jobs);
    }
    return prepared;
}

}  // namespace gh::render
