#include "load/level_check.h"
#include "load/limits.h"
#include "load/part_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace gh::load {
namespace {

bool is_near(const glm::vec3& point) {
    constexpr auto kMost = static_cast<float>(kMaxCoordinate);
    return std::abs(point.x) <= kMost && std::abs(point.y) <= kMost &&
           std::abs(point.z) <= kMost;  // NaN fails
}

bool is_near(const glm::mat4x3& matrix) {
    return is_near(matrix[0]) && is_near(matrix[1]) && is_near(matrix[2]) && is_near(matrix[3]);
}

bool is_index_or_none(std::uint32_t index, std::size_t size) {
    return index == world::kNoIndex || index < size;
}

template <class T>
bool has_length_or_none(const std::vector<T>& values, std::size_t length) {
    return values.empty() || values.size() == length;
}

Result<void> check_mesh(const world::Level& level, const world::Mesh& mesh) {
    const auto refuse = [&](std::string_view why) {
        return Error{fmt::format("mesh '{}' {}", mesh.name, why)};
    };
    const std::size_t vertices = mesh.positions.size();
    if (mesh.normals.size() != vertices || !has_length_or_none(mesh.uvs, vertices) ||
        !has_length_or_none(mesh.tangents, vertices) || !has_length_or_none(mesh.colors, vertices) ||
        !has_length_or_none(mesh.joints, vertices) || mesh.joints.size() != mesh.weights.size() ||
        mesh.materials.size() != mesh.triangles.size()) {
        return refuse("has attributes of unequal length");
    }
    for (const glm::vec3& position : mesh.positions) {
        if (!is_near(position))
            return refuse(fmt::format("has a vertex farther than {} m away", kMaxCoordinate));
    }
    for (const glm::uvec3& t : mesh.triangles) {
        if (std::max({t[0], t[1], t[2]}) >= vertices) return refuse("has an index out of range");
    }
    for (const std::uint32_t material : mesh.materials) {
        if (material >= level.materials.size()) return refuse("wears a material that does not exist");
    }
    return {};
}

Result<void> check_part(const world::Level& level, const world::Part& part) {
    const auto refuse = [&](std::string_view why) {
        return Error{fmt::format("part '{}' {}", part.name, why)};
    };
    if (part.mesh >= level.meshes.size()) return refuse("has a mesh that does not exist");
    if (!is_near(part.mover_from_part)) return refuse("stands too far away or nowhere");
    if (!is_index_or_none(part.lamp_group, level.lamp_groups.size()))
        return refuse("is of an unknown lamp group");
    const std::size_t movers[] = {1,
                                  level.doors.size(),
                                  level.mirrors.size(),
                                  level.guards.size(),
                                  world::kMaxStones,
                                  level.lenses.size()};
    if (part.mover_index >= movers[static_cast<std::size_t>(part.mover)])
        return refuse("is moved by nothing");
    return {};
}

Result<void> check_material(const world::Level& level, const world::Material& material) {
    const world::Layers& layers = material.layers;
    for (const std::uint32_t texture :
         {material.base_color_texture, material.metallic_roughness_texture, material.normal_texture,
          material.emission_texture, material.transmission_texture, layers.specular_texture,
          layers.specular_color_texture, layers.coat_texture, layers.coat_roughness_texture,
          layers.coat_normal_texture, layers.sheen_color_texture, layers.sheen_roughness_texture,
          layers.anisotropy_texture}) {
        if (!is_index_or_none(texture, level.textures.size())) {
            return Error{fmt::format("material '{}' has a texture that does not exist", material.name)};
        }
    }
    if (!material.uv_transforms.empty() && material.uv_transforms.size() != world::kTextureSlots)
        return Error{fmt::format("material '{}' turns some of its textures only", material.name)};
    return {};
}

Result<void> check_lamp(const world::Level& level, const world::Lamp& lamp) {
    const auto refuse = [&](std::string_view why) {
        return Error{fmt::format("lamp '{}' {}", lamp.name, why)};
    };
    if (!is_index_or_none(lamp.group, level.lamp_groups.size())) return refuse("is of an unknown group");
    if (!is_index_or_none(lamp.part, level.parts.size())) return refuse("is a part that does not exist");
    if (!is_near(lamp.position) || !is_near(lamp.half_u) || !is_near(lamp.half_v))
        return refuse("is nowhere");
    if (!std::isfinite(lamp.intensity.x + lamp.intensity.y + lamp.intensity.z))
        return refuse("is infinitely bright");
    if (lamp.shape == world::LampShape::Sphere && !(lamp.radius > 0.0f)) return refuse("has no size");
    const glm::vec3 across = lamp.half_u * lamp.half_u + lamp.half_v * lamp.half_v;
    if (lamp.shape == world::LampShape::Rect && !(across.x + across.y + across.z > 0.0f))
        return refuse("has no size");
    return {};
}

template <class T, class Check>
Result<void> check_each(const world::Level& level, const std::vector<T>& items, const Check& check) {
    for (const T& item : items) {
        if (Result<void> checked = check(level, item); !checked) return checked;
    }
    return {};
}

}  // namespace

Result<void> check_ranges(const world::Level& level) {
    if (Result<void> r = check_each(level, level.meshes, check_mesh); !r) return r;
    if (Result<void> r = check_each(level, level.parts, check_part); !r) return r;
    if (Result<void> r = check_each(level, level.materials, check_material); !r) return r;
    if (Result<void> r = check_each(level, level.lamps, check_lamp); !r) return r;
    if (!is_near(level.bounds.min) || !is_near(level.bounds.max)) {
        return Error{fmt::format("reaches farther than {} m", kMaxCoordinate)};
    }
    if (level.stone_part_begin + world::kMaxStones > level.parts.size()) return Error{"has no stones"};
    for (const world::Switch& wall_switch : level.switches) {
        if (wall_switch.group >= level.lamp_groups.size())
            return Error{fmt::format("switch '{}' has no group", wall_switch.name)};
    }
    for (const world::Guard& guard : level.guards) {
        if (!is_index_or_none(guard.model, level.models.size()))
            return Error{fmt::format("guard '{}' has no body", guard.name)};
    }
    return {};
}

}  // namespace gh::load
