// render/shading_corners.h - the triangle that a ray hit, as shading needs it: its edges in the world and its place in
// textures.
#pragma once

#include "render/light_math.h"
#include "render/scene_view.h"
#include "render/texture_lookups.h"

#include "raycore/ray.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <array>
#include <cmath>

namespace gh::render {

// The triangle that was hit, in the world frame where that matters.
struct HitTriangle {
    glm::uvec3 index{0};
    std::array<float, 3> share{};        // barycentric
    glm::vec3 edge1{0.0f}, edge2{0.0f};  // world
    glm::vec2 uv{0.0f}, uv_edge1{0.0f}, uv_edge2{0.0f};
};

inline glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& fallback) {
    const float length2 = glm::dot(v, v);
    return length2 > 0.0f && length2 < rc::kInfinity ? v / std::sqrt(length2) : fallback;
}

// Turns normals: the transpose of the inverse, but for a positive factor.
inline glm::mat3 normal_matrix(const glm::mat3& m) {
    const glm::mat3 cofactor(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return glm::dot(m[0], cofactor[0]) < 0.0f ? -cofactor : cofactor;
}

// `has_uvs`: or they are left 0.
inline HitTriangle corners_of(const SceneView& view, const world::Mesh& mesh, const rc::Hit& hit,
                              const glm::mat3& to_world, bool has_uvs) {
    HitTriangle corners;
    corners.index = mesh.triangles[hit.primitive];
    corners.share = {1.0f - hit.u - hit.v, hit.u, hit.v};
    const std::array<glm::vec3, 3> local = view.snapshot.scene->triangle(hit.instance, hit.primitive);
    corners.edge1 = to_world * (local[1] - local[0]);
    corners.edge2 = to_world * (local[2] - local[0]);
    if (has_uvs) {
        const glm::vec2 uv0 = mesh.uvs[corners.index.x];
        corners.uv_edge1 = mesh.uvs[corners.index.y] - uv0;
        corners.uv_edge2 = mesh.uvs[corners.index.z] - uv0;
        corners.uv = uv0 + corners.uv_edge1 * hit.u + corners.uv_edge2 * hit.v;
    }
    return corners;
}

// 0 where the triangle has no area.
inline UvGradients uv_gradients(const HitTriangle& corners) {
    const glm::vec3 n = glm::cross(corners.edge1, corners.edge2);
    const float area2 = glm::dot(n, n);
    if (!(area2 > 0.0f)) return {};
    // The same for the barycentrics.
    const glm::vec3 of_edge1 = glm::cross(corners.edge2, n) / area2;
    const glm::vec3 of_edge2 = glm::cross(n, corners.edge1) / area2;
    return {of_edge1 * corners.uv_edge1.x + of_edge2 * corners.uv_edge2.x,
            of_edge1 * corners.uv_edge1.y + of_edge2 * corners.uv_edge2.y};
}

}  // namespace gh::render
