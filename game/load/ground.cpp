#include "load/ground.h"

#include "base/hash.h"
#include "load/part_geometry.h"
#include "world/layers.h"

#include <fmt/format.h>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace gh::load {
namespace {

constexpr std::size_t kMostTriangles = 8'000'000;

bool is_ground(const world::Part& part) {
    const bool stays = part.mover == world::Mover::None || part.mover == world::Mover::Mirror;
    return stays && (part.layers & world::Solid) != 0;
}

void add_part(const world::Mesh& mesh, const glm::mat4x3& world_from_part, Ground& ground) {
    const auto first = static_cast<int>(ground.vertices.size());
    for (const glm::vec3& p : mesh.positions) ground.vertices.push_back(transform_point(world_from_part, p));
    const bool is_mirrored = glm::determinant(glm::mat3(world_from_part)) < 0.0f;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const glm::ivec3 t = glm::ivec3(triangle) + first;
        ground.triangles.push_back(is_mirrored ? glm::ivec3(t.x, t.z, t.y) : t);
    }
}

}  // namespace

std::uint64_t Ground::hash() const {
    Hasher hasher;
    hasher.add(std::uint64_t{vertices.size()});
    for (const glm::vec3& vertex : vertices) hasher.add(vertex);
    hasher.add(std::uint64_t{triangles.size()});
    for (const glm::ivec3& t : triangles) {
        for (glm::length_t c = 0; c < 3; ++c) hasher.add(t[c]);
    }
    for (const glm::vec3& place : places) hasher.add(place);
    return hasher.digest();
}

Result<Ground> collect_ground(const world::Level& level) {
    std::size_t vertices = 0, triangles = 0;
    for (const world::Part& part : level.parts) {
        if (!is_ground(part)) continue;
        vertices += level.meshes[part.mesh].positions.size();
        triangles += level.meshes[part.mesh].triangles.size();
    }
    if (triangles > kMostTriangles || vertices > 3 * kMostTriangles) {
        return Error{
            fmt::format("has {} solid triangles, ways are found over at most {}", triangles, kMostTriangles)};
    }
    Ground ground;
    ground.vertices.reserve(vertices);
    ground.triangles.reserve(triangles);
    for (const world::Part& part : level.parts) {
        if (is_ground(part)) add_part(level.meshes[part.mesh], world_from_part_at_rest(level, part), ground);
    }
    ground.places.push_back(level.spawn.position);
    for (const world::Guard& guard : level.guards) {
        ground.places.push_back(guard.position);
        for (const world::PatrolPoint& point : guard.patrol) ground.places.push_back(point.position);
    }
    return ground;
}

}  // namespace gh::load
