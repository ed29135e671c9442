// render/octahedron.h - the sphere of directions folded flat onto a small square (Cigolle et al. 2014).
//
// Same bits pure.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace gh::render {

// The unit direction through the middle of texel (x, y) of a map with `side` texels a side.
[[nodiscard]] inline glm::vec3 octahedral_direction(int x, int y, int side) {
    const float u = (static_cast<float>(x) + 0.5f) * 2.0f / static_cast<float>(side) - 1.0f;
    const float v = (static_cast<float>(y) + 0.5f) * 2.0f / static_cast<float>(side) - 1.0f;
    const float z = 1.0f - std::abs(u) - std::abs(v);
    if (z >= 0.0f) return glm::normalize(glm::vec3(u, v, z));
    return glm::normalize(
        glm::vec3(std::copysign(1.0f - std::abs(v), u), std::copysign(1.0f - std::abs(u), v), z));
}

// The four texels around a direction and their weights, which sum to 1.
struct OctahedralTexels {
    std::array<std::size_t, 4> index{};
    std::array<float, 4> weight{};
};

// Beyond an edge the map goes on at the mirrored place of the same edge.
[[nodiscard]] inline std::size_t octahedral_index(int x, int y, int side) {
    if (x < 0 || x >= side) {
        x = std::clamp(x, 0, side - 1);
        y = side - 1 - y;
    }
    if (y < 0 || y >= side) {
        y = std::clamp(y, 0, side - 1);
        x = side - 1 - x;
    }
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
}

[[nodiscard]] inline OctahedralTexels octahedral_texels(const glm::vec3& direction, int side) {
    const float sum = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
    float u = direction.x / sum, v = direction.y / sum;
    if (direction.z < 0.0f) {
        const float folded_u = std::copysign(1.0f - std::abs(v), u);
        v = std::copysign(1.0f - std::abs(u), v);
        u = folded_u;
    }
    const float x = (u * 0.5f + 0.5f) * static_cast<float>(side) - 0.5f;
    const float y = (v * 0.5f + 0.5f) * static_cast<float>(side) - 0.5f;
    const float x_floor = std::floor(x), y_floor = std::floor(y);
    const int x0 = static_cast<int>(x_floor), y0 = static_cast<int>(y_floor);
    const float fx = x - x_floor, fy = y - y_floor;
    return {{octahedral_index(x0, y0, side), octahedral_index(x0 + 1, y0, side),
             octahedral_index(x0, y0 + 1, side), octahedral_index(x0 + 1, y0 + 1, side)},
            {(1.0f - fx) * (1.0f - fy), fx * (1.0f - fy), (1.0f - fx) * fy, fx * fy}};
}

}  // namespace gh::render
