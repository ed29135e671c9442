// render/guide_point.h - what a pixel of a picture's guide says of the surface it shows.
//
// Same bits pure.
#pragma once

#include "render/film.h"
#include "render/scene_view.h"
#include "render/shading_corners.h"
#include "world/level.h"

#include "raycore/ray.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace gh::render {

struct GuidePoint {
    glm::vec3 position{0.0f}, previous{0.0f};
    glm::vec3 geometric{0.0f};  // unit, of the triangle, towards the eye
    glm::vec3 albedo{1.0f};
    std::uint32_t part = GuidePlanes::kSky;
};

void note(const GuidePoint& point, std::size_t pixel, GuidePlanes& planes);

// About what light is multiplied by at a surface; never 0: polish gives back some of it, whatever is beneath.
[[nodiscard]] glm::vec3 guide_albedo(const glm::vec3& base_color, float metallic);

// Where a point that is now at `position` was in the view's last snapshot, if it has one.
[[nodiscard]] glm::vec3 previous_position(const SceneView& view, const rc::Hit& hit,
                                          const glm::vec3& position);

// Whether a surface of this material is what a ray shows that meets it: light does not go through it, nor does it mirror
// more than it scatters, whatever its textures hold.
[[nodiscard]] bool is_plain(const world::Material& material);

// What all pixels have in common that show the same triangle: neighbours mostly do.
struct GuideTriangle {
    std::uint32_t instance = rc::kNone, primitive = rc::kNone;  // kNone: of no pixel yet
    bool is_plain = false;
    bool is_polished = false;  // it mirrors, the same all over it, but is no clear mirror
    // What is below counts if it is either.
    bool is_textured = false;
    const world::Material* material = nullptr;
    glm::vec3 normal{0.0f};  // unit; 0: it has no area
    glm::vec2 uv{0.0f}, uv_edge1{0.0f}, uv_edge2{0.0f};
    UvGradients gradients;
    glm::vec3 smooth{0.0f}, smooth_edge1{0.0f},
        smooth_edge2{0.0f};  // normals at its corners, if it is polished
};

// The triangles of the last pixels.
class GuideTriangles {
  public:
    // Valid until the next one is asked for. Precondition: `hit` is a hit of the view's snapshot.
    [[nodiscard]] const GuideTriangle& of(const SceneView& view, const rc::Hit& hit);

  private:
    static constexpr std::size_t kKept = 16;  // eight triangles a tile are usual
    std::array<GuideTriangle, kKept> kept_{};
};

// A hit of a plain surface, but for its colours (guide_colors.h). The ray's direction is unit.
[[nodiscard]] GuidePoint plain_point(const SceneView& view, const GuideTriangle& triangle, const rc::Ray& ray,
                                     const rc::Hit& hit);

}  // namespace gh::render
