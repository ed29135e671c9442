// comparators/soup.h - a mesh as the comparators keep it: the corners of every triangle a build would keep, in order.
#pragma once

#include "comparators/triangle_tests.h"

#include "raycore/mesh.h"

#include <cstdint>
#include <vector>

namespace comparators {

struct Bounds {
    glm::dvec3 min{0.0}, max{0.0};
};

struct Soup {
    explicit Soup(const rc::MeshView& mesh);

    std::vector<Corners> corners;
    std::vector<std::uint32_t> primitive;  // as given
    Bounds bounds;
    double reach = 0;  // the largest absolute coordinate
};

[[nodiscard]] Bounds bounds_of(const Corners& corners);

// How far the specification's rounding may move a hit away from the ray, in the mesh's frame, five roundings of what
// lies between origin and triangle (raycore/src/kernels/README.md); eight are granted.
[[nodiscard]] double ray_pad(double origin_reach, double soup_reach);
[[nodiscard]] double reach_of(const glm::vec3& p);

}  // namespace comparators
