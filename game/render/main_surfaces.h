// render/main_surfaces.h - the surface that speaks for each pixel of a tile, kept until all are known; and the light on
// it apart from its own colours, which changes slowly from pixel to pixel even where a texture does not.
#pragma once

#include "render/lamp.h"
#include "render/path_ray.h"
#include "render/pixel_light.h"
#include "render/shading_point.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gh::render {

// An opaque surface on a ray's way, with all that lighting it needs.
struct SeenSurface {
    PathRay path;
    ShadingPoint at;
    glm::vec3 diffuse{0.0f};       // share of the irradiance that leaves again in all directions
    glm::vec3 mirrored{0.0f};      // share of the baked radiance around it that it mirrors
    glm::vec3 polished{0.0f};      // share of what a mirrored ray brings
    float highlight_share = 1.0f;  // of lamps' bulbs, that is in the highlight and not in the mirrored ray
    Gloss gloss;
};

// What arrives if nothing stands in the way, apart from the surface's own colours.
struct SurfaceLight {
    glm::vec3 irradiance{0.0f};  // W/m2
    glm::vec3 shine{0.0f};       // radiance of highlights and of what is mirrored
    glm::vec3 seen{1.0f};        // the share of it that does arrive
    // How the irradiance changes as the normal n turns: E(n + d) = E(n) + turns d to first order (Gershun's light
    // vector, a column a direction). It carries what a normal map does from lit pixels to those between them.
    glm::mat3 turns{0.0f};
    bool is_plain = true;  // everything that was looked for is seen
};

struct MainSurfaces {
    static constexpr std::uint16_t kNone = 0xFFFF;

    std::vector<std::uint16_t> at_pixel;  // index below, or kNone
    std::vector<SeenSurface> surfaces;
    std::vector<SurfaceLight> lights;
    std::vector<SharedLight> found;      // what shadow rays found, in the pixel
    std::vector<glm::vec3> reflections;  // radiance that mirrored rays brought, where they were sent

    void clear(std::size_t pixels) {
        at_pixel.assign(pixels, kNone);
        surfaces.clear();
    }
    void add(const SeenSurface& surface) {
        at_pixel[surface.path.pixel] = static_cast<std::uint16_t>(surfaces.size());
        surfaces.push_back(surface);
    }
    void begin_light() {
        lights.assign(surfaces.size(), {});
        found.assign(surfaces.size(), {});
        reflections.assign(surfaces.size(), glm::vec3(0.0f));
    }
    [[nodiscard]] SharedLight& found_at(std::uint16_t pixel) { return found[at_pixel[pixel]]; }
};

}  // namespace gh::render
