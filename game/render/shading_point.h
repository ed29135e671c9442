// render/shading_point.h - a hit made ready for shading: where, which way it faces, and what it is made of there.
//
// Same bits pure.
#pragma once

#include "render/scene_view.h"

#include "raycore/ray.h"

#include <glm/vec3.hpp>

#include <span>

namespace gh::render {

struct ShadingPoint {
    rc::SurfacePoint surface;
    const world::Material* material = nullptr;
    std::uint32_t part = 0;
    bool is_entering = true;    // the ray comes from the side the mesh's normals point to
    glm::vec3 geometric{0.0f};  // unit, of the triangle, towards where the ray came from
    glm::vec3 normal{0.0f};     // unit, smooth and from the normal map, never facing away from the ray
    glm::vec3 smooth{0.0f};     // the same without the normal map
    // Textures times factors, averaged over the pixel's footprint.
    glm::vec3 base_color{0.0f};
    float alpha = 1.0f;
    float metallic = 0.0f;
    float roughness = 1.0f;
    float transmission = 0.0f;
    glm::vec3 emission{0.0f};
    // KHR_materials_specular, _clearcoat, _sheen, _anisotropy; as if there was none unless the material has layers.
    float specular = 1.0f;
    glm::vec3 specular_color{1.0f};
    float coat = 0.0f, coat_roughness = 0.0f;
    glm::vec3 coat_normal{0.0f};  // unit, as `normal`; only if there is a coat
    glm::vec3 sheen_color{0.0f};
    float sheen_roughness = 0.0f;
    float anisotropy = 0.0f;
    glm::vec3 drawn_out{
        0.0f};  // unit, along the surface: the way highlights are drawn out; only if anisotropic
};

// `cone_width`: of the pixel's cone where the ray ends, metres; `max_taps`: of each texture. Precondition: `hit` is a hit
// of the snapshot's scene.
[[nodiscard]] ShadingPoint shading_point(const SceneView& view, const rc::Ray& ray, const rc::Hit& hit,
                                         float cone_width, float max_taps = static_cast<float>(kMostTaps));

// Several at once, whose textures are looked up side by side: points[i] is shading_point() of asked[i].
struct PointAsked {
    const rc::Ray* ray;
    const rc::Hit* hit;
    float cone_width, max_taps;
};
void shading_points(const SceneView& view, std::span<const PointAsked> asked, std::span<ShadingPoint> points);

// Tells the processor which memory shading_point() is going to read for this hit: in a scene of a million triangles each
// of half a dozen arrays is a wait of its own. First for a hit that is dealt with some hits later, second a little before
// its turn. Changes nothing but time.
void fetch_indices(const SceneView& view, const rc::Hit& hit);
void fetch_corners(const SceneView& view, const rc::Hit& hit);

// The direction a mirror sends the ray on. Where a bent normal would send it into the surface it just grazes it.
[[nodiscard]] glm::vec3 mirrored_direction(const glm::vec3& direction, const ShadingPoint& at);

// Only what a shadow ray needs to know: what share of the light the material lets pass in its colour, before
// reflection at its surface.
struct Clearness {
    rc::SurfacePoint surface;
    glm::vec3 share{0.0f};        // 0: opaque
    float glass = 0.0f;           // how much of it is glass, whose surface reflects, rather than holes
    glm::vec3 glass_share{0.0f};  // of `share`, what passes the glass
    glm::vec3 outward{0.0f};      // unit
    const world::Material* material = nullptr;
};
[[nodiscard]] Clearness clearness(const SceneView& view, const rc::Hit& hit);

}  // namespace gh::render
