#include "load/fuse_parts.h"

#include "load/part_geometry.h"
#include "world/layers.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace gh::load {

namespace {

constexpr std::size_t kMostCopies =
    100'000;  // triangles one mesh may become by being fused in all its places
constexpr std::size_t kMostFused = 4'000'000;  // triangles in all

// Parts are fused with those of the same layers whose vertices carry the same things.
struct Alike {
    rc::LayerMask layers;
    bool has_normals, has_uvs, has_tangents, has_colors;

    bool operator==(const Alike&) const = default;
};

Alike alike(const world::Part& part, const world::Mesh& mesh) {
    return {part.layers, !mesh.normals.empty(), !mesh.uvs.empty(), !mesh.tangents.empty(),
            !mesh.colors.empty()};
}

std::vector<std::uint8_t> parts_to_fuse(const world::Level& level) {
    std::vector<std::size_t> places(level.meshes.size(), 0);
    for (const world::Part& part : level.parts) ++places[part.mesh];
    std::vector<std::uint8_t> fuses(level.parts.size(), 0);
    std::size_t total = 0;
    for (std::size_t i = 0; i < fuses.size(); ++i) {
        const world::Part& part = level.parts[i];
        const std::size_t triangles = level.meshes[part.mesh].triangles.size();
        const bool stays = part.mover == world::Mover::None && part.lamp_group == world::kNoIndex &&
                           !part.is_shell && (part.layers & world::Clear) == 0;
        if (!stays || triangles * places[part.mesh] > kMostCopies || total + triangles > kMostFused) continue;
        fuses[i] = 1;
        total += triangles;
    }
    for (const world::Lamp& lamp : level.lamps) {
        if (lamp.part != world::kNoIndex) fuses[lamp.part] = 0;
    }
    for (const world::Mirror& mirror : level.mirrors) {
        if (mirror.pane_part != world::kNoIndex) fuses[mirror.pane_part] = 0;
    }
    return fuses;
}

glm::vec3 turned_or(const glm::vec3& v, const glm::vec3& fallback) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : fallback;
}

void append(world::Mesh& whole, const world::Mesh& mesh, const glm::mat4x3& to_world) {
    const glm::mat3 turn(to_world[0], to_world[1], to_world[2]);
    const glm::mat3 cofactor(glm::cross(turn[1], turn[2]), glm::cross(turn[2], turn[0]),
                             glm::cross(turn[0], turn[1]));
    const bool is_mirrored = glm::dot(turn[0], cofactor[0]) < 0.0f;
    const float outwards = is_mirrored ? -1.0f : 1.0f;
    const auto first = static_cast<std::uint32_t>(whole.positions.size());
    for (const glm::vec3& p : mesh.positions) whole.positions.push_back(transform_point(to_world, p));
    for (const glm::vec3& n : mesh.normals) whole.normals.push_back(turned_or(cofactor * n * outwards, n));
    whole.uvs.insert(whole.uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
    whole.colors.insert(whole.colors.end(), mesh.colors.begin(), mesh.colors.end());
    for (const glm::vec4& t : mesh.tangents) {
        const glm::vec3 along = turned_or(turn * glm::vec3(t), glm::vec3(t));
        whole.tangents.emplace_back(along, is_mirrored ? -t.w : t.w);
    }
    for (const glm::uvec3& corners : mesh.triangles) {
        const glm::uvec3 moved = corners + first;
        whole.triangles.push_back(is_mirrored ? glm::uvec3(moved.x, moved.z, moved.y) : moved);
    }
    whole.materials.insert(whole.materials.end(), mesh.materials.begin(), mesh.materials.end());
}

// Meshes that nothing shows any more go, the others move up.
void drop_unused_meshes(world::Level& level) {
    std::vector<std::uint32_t> moved(level.meshes.size(), world::kNoIndex);
    std::vector<world::Mesh> kept;
    const auto keep = [&](std::uint32_t& mesh) {
        std::uint32_t& to = moved[mesh];
        if (to == world::kNoIndex) {
            to = static_cast<std::uint32_t>(kept.size());
            kept.push_back(std::move(level.meshes[mesh]));
        }
        mesh = to;
    };
    for (world::Part& part : level.parts) keep(part.mesh);
    for (world::Model& model : level.models) {
        if (model.mesh != world::kNoIndex) keep(model.mesh);
    }
    level.meshes = std::move(kept);
}

}  // namespace

void fuse_still_parts(world::Level& level) {
    const glm::vec3 reach = glm::max(glm::abs(level.bounds.min), glm::abs(level.bounds.max));
    if (!(std::max({reach.x, reach.y, reach.z}) <= kFarthest)) return;
    const std::vector<std::uint8_t> fuses = parts_to_fuse(level);
    std::vector<Alike> kinds;
    std::vector<world::Part> parts;
    for (std::size_t i = 0; i < fuses.size(); ++i) {
        if (fuses[i] == 0) continue;
        const world::Part& part = level.parts[i];
        const Alike kind = alike(part, level.meshes[part.mesh]);
        auto at = static_cast<std::size_t>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
        if (at == kinds.size()) {
            kinds.push_back(kind);
            world::Part whole;
            whole.name = "still";
            whole.mesh = static_cast<std::uint32_t>(level.meshes.size());
            whole.layers = part.layers;
            parts.push_back(std::move(whole));
            level.meshes.emplace_back().name = "still";
        }
        const world::Mesh mesh =
            level.meshes[part.mesh];  // a copy: `meshes` has grown, and the mesh may be shared
        append(level.meshes[parts[at].mesh], mesh, part.mover_from_part);
    }
    std::vector<std::uint32_t> moved(level.parts.size() + 1, world::kNoIndex);
    for (std::size_t i = 0; i < fuses.size(); ++i) {
        if (i == level.stone_part_begin) level.stone_part_begin = static_cast<std::uint32_t>(parts.size());
        if (fuses[i] != 0) continue;
        moved[i] = static_cast<std::uint32_t>(parts.size());
        parts.push_back(std::move(level.parts[i]));
    }
    for (world::Lamp& lamp : level.lamps) {
        if (lamp.part != world::kNoIndex) lamp.part = moved[lamp.part];
    }
    for (world::Mirror& mirror : level.mirrors) {
        if (mirror.pane_part != world::kNoIndex) mirror.pane_part = moved[mirror.pane_part];
    }
    level.parts = std::move(parts);
    drop_unused_meshes(level);
}

}  // namespace gh::load
