// load/flat_face.h - the largest flat face of a handful of triangles: a lamp's panel, a mirror's pane.
//
// Cost      O(triangles x flat faces), for lamps and mirrors, which have few of either.
// Same bits depends on the triangles in their order only; of equal faces the first.
#pragma once

#include <glm/vec3.hpp>

#include <optional>
#include <span>

namespace gh::load {

// The least rectangle around the face, one side along one of its edges. cross(half_u, half_v) points to where
// the triangles face.
struct FlatFace {
    glm::vec3 centre{0.0f};
    glm::vec3 half_u{0.0f};
    glm::vec3 half_v{0.0f};
    glm::vec3 normal{0.0f};    // unit
    float area = 0.0f;         // of the face itself, at most that of the rectangle
    float whole_area = 0.0f;   // of all triangles given
    std::size_t triangle = 0;  // one that lies in it
};

// Nothing when no triangle has an area.
[[nodiscard]] std::optional<FlatFace> largest_flat_face(std::span<const glm::vec3> positions,
                                                        std::span<const glm::uvec3> triangles);

}  // namespace gh::load
