// Stones: kMaxStones parts that fly when thrown, of the file's own mesh or a pebble made here.
#include "load/level_build.h"
#include "load/part_geometry.h"
#include "world/layers.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace gh::load {
namespace {

// Cuts every triangle of a ball in four and lifts the new corners to its surface.
void subdivide(world::Mesh& ball) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle_of;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto id = static_cast<std::uint32_t>(ball.normals.size());
        const auto [known, is_new] = middle_of.emplace(std::minmax(a, b), id);
        if (is_new) ball.normals.push_back(glm::normalize(ball.normals[a] + ball.normals[b]));
        return known->second;
    };
    std::vector<glm::uvec3> finer;
    for (const glm::uvec3& t : ball.triangles) {
        const std::uint32_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
        finer.insert(finer.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
    }
    ball.triangles = std::move(finer);
}

// A ball from an octahedron: 128 triangles, flattened a little so that one sees it roll.
world::Mesh make_pebble(float radius, std::uint32_t material) {
    world::Mesh pebble;
    pebble.name = "(pebble)";
    pebble.normals = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    pebble.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                        {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    subdivide(pebble);
    subdivide(pebble);
    const glm::vec3 shape = radius * glm::vec3(1.0f, 0.75f, 0.9f);
    for (glm::vec3& normal : pebble.normals) {
        pebble.positions.push_back(normal * shape);
        normal = glm::normalize(normal / shape);
    }
    pebble.materials.assign(pebble.triangles.size(), material);
    return pebble;
}

// The first mesh at or below the node.
std::uint32_t mesh_node_below(const LevelBuild& build, std::uint32_t root) {
    std::vector<bool> is_below(build.facts.size(), false);
    for (const std::uint32_t id : build.tree.order) {
        const std::uint32_t parent = build.tree.parent[id];
        is_below[id] = id == root || (parent != world::kNoIndex && is_below[parent]);
        if (is_below[id] && build.node(id).mesh >= 0) return id;
    }
    return world::kNoIndex;
}

struct StoneShape {
    std::uint32_t mesh = world::kNoIndex;
    glm::mat4x3 stone_from_mesh{1.0f};
};

// The model, put with the middle of its bounds at the stone's centre; its radius is half its mean size.
Result<StoneShape> read_stone_model(LevelBuild& build, std::uint32_t root) {
    const std::uint32_t id = mesh_node_below(build, root);
    if (id == world::kNoIndex) return Error{"is a stone_model without a mesh"};
    const Result<MeshPieces> pieces = build.meshes.use(build.node(id).mesh, Split::Whole);
    if (!pieces) return pieces.error();
    if (pieces->solid == world::kNoIndex) return Error{"is a stone_model without triangles"};
    glm::dmat4 stone_from_mesh = build.tree.world_from_node[id];
    world::Aabb box = empty_box();
    for (const glm::vec3& p : build.meshes.mesh(pieces->solid).positions)
        grow(box, transform_point(to_affine(stone_from_mesh), p));
    stone_from_mesh[3] -= glm::dvec4(0.5f * (box.min + box.max), 0.0f);
    const glm::vec3 size = box.max - box.min;
    build.level.stone_radius = ((size.x + size.y) + size.z) / 6.0f;
    if (!(build.level.stone_radius >= 0.005f && build.level.stone_radius <= 0.5f)) {
        return Error{fmt::format("is a stone of {} m radius: between 0.005 and 0.5 can be thrown",
                                 build.level.stone_radius)};
    }
    return StoneShape{pieces->solid, to_affine(stone_from_mesh)};
}

}  // namespace

Result<void> build_stones(LevelBuild& build) {
    StoneShape shape;
    for (const std::uint32_t id : build.tree.order) {
        if (build.facts[id].kind != Kind::StoneModel) continue;
        if (shape.mesh != world::kNoIndex) return at_node(build, id, "is a second stone_model");
        Result<StoneShape> read = read_stone_model(build, id);
        if (!read) return at_node(build, id, read.error().sentence);
        shape = *read;
    }
    if (shape.mesh == world::kNoIndex) {
        const auto unpainted = static_cast<std::uint32_t>(build.materials.index_of(-1));
        shape.mesh = build.meshes.add(make_pebble(build.level.stone_radius, unpainted));
    }
    build.level.stone_part_begin = static_cast<std::uint32_t>(build.level.parts.size());
    for (std::uint32_t i = 0; i < world::kMaxStones; ++i) {
        world::Part part;
        part.name = fmt::format("stone {}", i);
        part.mesh = shape.mesh;
        part.mover_from_part = shape.stone_from_mesh;
        part.layers = world::Light;
        part.mover = world::Mover::Stone;
        part.mover_index = i;
        build.level.parts.push_back(std::move(part));
    }
    return {};
}

}  // namespace gh::load
