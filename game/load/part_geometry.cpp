#include "load/part_geometry.h"

#include "base/det_math.h"

#include <glm/common.hpp>

#include <limits>

namespace gh::load {
namespace {

glm::dmat4 mover_matrix(const glm::vec3& position, const glm::quat& rotation) {
    return Pose{glm::dvec3(position), glm::dquat(rotation)}.matrix();
}

}  // namespace

Triangles part_triangles(const world::Mesh& mesh, const glm::mat4x3& mover_from_part,
                         const std::function<bool(std::uint32_t material)>& wanted) {
    Triangles result;
    std::vector<std::uint32_t> new_id(mesh.positions.size(), world::kNoIndex);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!wanted(mesh.materials[t])) continue;
        glm::uvec3 triangle = mesh.triangles[t];
        for (glm::length_t c = 0; c < 3; ++c) {
            std::uint32_t& id = new_id[triangle[c]];
            if (id == world::kNoIndex) {
                id = static_cast<std::uint32_t>(result.positions.size());
                result.positions.push_back(transform_point(mover_from_part, mesh.positions[triangle[c]]));
            }
            triangle[c] = id;
        }
        result.triangles.push_back(triangle);
        result.materials.push_back(mesh.materials[t]);
    }
    return result;
}

glm::vec3 transform_point(const glm::mat4x3& a_from_b, const glm::vec3& b) {
    return a_from_b * glm::vec4(b, 1.0f);
}

world::Aabb empty_box() {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    return {glm::vec3(kFar), glm::vec3(-kFar)};
}

void grow(world::Aabb& box, const glm::vec3& point) {
    box.min = glm::min(box.min, point);
    box.max = glm::max(box.max, point);
}

world::Aabb bounds_of(const std::vector<glm::vec3>& positions) {
    world::Aabb box = empty_box();
    for (const glm::vec3& position : positions) grow(box, position);
    return box;
}

glm::mat4x3 world_from_part_at_rest(const world::Level& level, const world::Part& part) {
    glm::dmat4 world_from_mover(1.0);
    switch (part.mover) {
        case world::Mover::Door: {
            const world::Door& door = level.doors[part.mover_index];
            world_from_mover = mover_matrix(door.hinge, door.world_from_rest);
            break;
        }
        case world::Mover::Mirror: {
            const world::Mirror& mirror = level.mirrors[part.mover_index];
            world_from_mover = mover_matrix(mirror.pivot, mirror.world_from_rest);
            break;
        }
        case world::Mover::Lens:
            world_from_mover = from_affine(level.lenses[part.mover_index].world_from_lens);
            break;
        case world::Mover::Guard: {
            const world::Guard& guard = level.guards[part.mover_index];
            const det::SinCos half = det::sin_cos(0.5f * guard.yaw);
            world_from_mover = mover_matrix(guard.position, glm::quat(half.cos, 0.0f, half.sin, 0.0f));
            break;
        }
        case world::Mover::None:
        case world::Mover::Stone:
            break;
    }
    return to_affine(world_from_mover * from_affine(part.mover_from_part));
}

}  // namespace gh::load
