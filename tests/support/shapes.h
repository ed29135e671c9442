// support/shapes.h - meshes that tests and benchmarks share. Metres, y up; every closed shape is watertight by
// shared indices.
#pragma once

#include "support/random.h"

#include "raycore/mesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace test {

struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;

    [[nodiscard]] rc::MeshView view() const { return {positions, triangles}; }
};

// A closed ball: an octahedron whose faces are cut into n * n and pushed onto the sphere. 8 n^2 triangles.
[[nodiscard]] Mesh make_ball(const glm::vec3& centre, float radius, std::uint32_t n);

// A flat sheet in the plane y = height, n * n cells of two triangles over [-half, half]^2.
[[nodiscard]] Mesh make_sheet(float half, float height, std::uint32_t n);

// The six walls of a box, seen from inside or outside alike. 12 triangles.
[[nodiscard]] Mesh make_box(const glm::vec3& low, const glm::vec3& high);

// n unconnected triangles about `size` large in a cube of half width `half`.
[[nodiscard]] Mesh make_soup(Random& random, std::uint32_t n, float half, float size);

// The same triangles, each with vertices of its own.
[[nodiscard]] Mesh parted(const Mesh& mesh);

// Adds b to a.
void append(Mesh& a, const Mesh& b);

}  // namespace test
