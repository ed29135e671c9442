// render/guide_point.h - what a pixel of a picture's guide says of the surface it shows.
//
// Same bits pure.
#pragma once

#include "render/film.h"
#include "render/scene_view.h"
#include "world/level.h"

#include "raycore/ray.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>

namespace gh::render {

struct GuidePoint {
    glm::vec3 position{0.0f}, previous{0.0f};
    glm::vec3 geometric{0.0f};  // unit, of the triangle, towards the eye
    glm::vec3 albedo{1.0f};
    std::uint32_t part = FilmPlanes::kSky;
};

void note(const GuidePoint& point, std::size_t pixel, FilmPlanes& planes);

// About what light is multiplied by at a surface; never 0: polish gives back some of it, whatever is beneath.
[[nodiscard]] glm::vec3 guide_albedo(const glm::vec3& base_color, float metallic);

// Where a point that is now at `position` was in the view's last snapshot, if it has one.
[[nodiscard]] glm::vec3 previous_position(const SceneView& view, const rc::Hit& hit,
                                          const glm::vec3& position);

// Whether a surface of this material is what a ray shows that meets it: light does not go through it, nor does it mirror
// more than it scatters, whatever its textures hold.
[[nodiscard]] bool is_plain(const world::Material& material);

// A hit of such a surface, with no more looked up than the guide needs; its emission apart. `direction` unit;
// `cone_width` and `max_taps` as shading_point() has them.
[[nodiscard]] GuidePoint plain_point(const SceneView& view, const rc::Ray& ray, const rc::Hit& hit,
                                     float cone_width, float max_taps, glm::vec3& emission);

}  // namespace gh::render
