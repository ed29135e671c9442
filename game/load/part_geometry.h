// load/part_geometry.h - triangles of parts in one frame, for whatever must be measured from geometry.
#pragma once

#include "load/level_build.h"
#include "world/level.h"

#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace gh::load {

struct Triangles {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    std::vector<std::uint32_t> materials;  // one a triangle
};

// The part's triangles of which `wanted(material)` holds, in its mover's frame (the world's when nothing
// moves it).
[[nodiscard]] Triangles part_triangles(const world::Mesh& mesh, const glm::mat4x3& mover_from_part,
                                       const std::function<bool(std::uint32_t material)>& wanted);

[[nodiscard]] glm::vec3 transform_point(const glm::mat4x3& a_from_b, const glm::vec3& b);
[[nodiscard]] world::Aabb bounds_of(const std::vector<glm::vec3>& positions);  // min > max when empty
void grow(world::Aabb& box, const glm::vec3& point);
[[nodiscard]] world::Aabb empty_box();

// World transform of a part at rest, whatever moves it.
[[nodiscard]] glm::mat4x3 world_from_part_at_rest(const world::Level& level, const world::Part& part);

}  // namespace gh::load
