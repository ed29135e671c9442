// render/shading_corners.h - the triangle that a ray hit, as shading needs it: its edges in the world, its place in
// textures, and the patch of texture under a pixel.
#pragma once

#include "render/light_math.h"
#include "render/scene_view.h"
#include "render/texture.h"

#include "raycore/ray.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
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

// How a texture's u and v change along a world vector in the triangle's plane; 0 where the triangle has no area.
struct UvGradients {
    glm::vec3 u{0.0f}, v{0.0f};
};

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

// The ellipse that the ray's cone cuts out of the triangle's plane.
inline Footprint footprint_of(const UvGradients& gradients, const glm::vec3& direction,
                              const glm::vec3& geometric, float cone_width) {
    const auto uv_along = [&](const glm::vec3& way) {
        return glm::vec2(glm::dot(way, gradients.u), glm::dot(way, gradients.v));
    };
    const float cosine = std::max(std::abs(glm::dot(direction, geometric)), 0.02f);
    const glm::vec3 slant = direction - geometric * glm::dot(direction, geometric);
    const glm::vec3 any =
        std::abs(geometric.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
    const float slant2 = glm::dot(slant, slant);
    const glm::vec3 along =
        slant2 > 0.0f ? slant / std::sqrt(slant2) : glm::normalize(glm::cross(geometric, any));
    const glm::vec3 across = glm::cross(geometric, along);
    return {.major = uv_along(along * (cone_width / cosine)), .minor = uv_along(across * cone_width)};
}

inline glm::vec2 uv_of(const world::Material& material, world::TextureSlot slot, const glm::vec2& uv) {
    if (material.uv_transforms.empty()) return uv;
    return material.uv_transforms[static_cast<std::size_t>(slot)] * glm::vec3(uv, 1.0f);
}

// The footprint of a texture that is looked up elsewhere.
inline Footprint footprint_of(const world::Material& material, world::TextureSlot slot,
                              const Footprint& footprint) {
    if (material.uv_transforms.empty()) return footprint;
    const glm::mat3x2& m = material.uv_transforms[static_cast<std::size_t>(slot)];
    return {m * glm::vec3(footprint.major, 0.0f), m * glm::vec3(footprint.minor, 0.0f)};
}

}  // namespace gh::render
