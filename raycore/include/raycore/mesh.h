// raycore/mesh.h - triangles as they come in, and what is wrong with them.
//
// Bad input  a triangle with an index out of range, a vertex that is NaN, infinite or beyond 2^60, or no area is dropped
//            and counted; queries never meet it and primitive ids of the others do not change.
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>

namespace rc {

// More triangles than this are a contract violation, and an empty Blas in release.
inline constexpr std::size_t kMaxTriangles = std::size_t{1} << 25;

// Borrowed: valid while the caller's arrays are.
struct MeshView {
    std::span<const glm::vec3> positions;
    std::span<const glm::uvec3> triangles;
};

struct MeshReport {
    std::size_t triangles = 0;  // given
    std::size_t index_out_of_range = 0;
    std::size_t not_finite = 0;
    std::size_t zero_area = 0;

    [[nodiscard]] std::size_t dropped() const { return index_out_of_range + not_finite + zero_area; }
    [[nodiscard]] std::size_t kept() const { return triangles - dropped(); }
};

// Counts what a build would drop, each triangle under the first reason that applies, in the order above.
[[nodiscard]] MeshReport check_mesh(const MeshView& mesh);

}  // namespace rc
