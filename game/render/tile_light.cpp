// The part of a tile that finds what light reaches a surface if nothing is in its way: from lamps, and baked, from all
// around.
#include "base/det_math.h"
#include "render/colour.h"
#include "render/light_math.h"
#include "render/tile.h"
#include "render/tile_blend.h"

#include <glm/geometric.hpp>

namespace gh::render {

namespace {

constexpr float kAmbientOpen = 0.9f;  // of what is baked, past what stands in corners

}  // namespace

// Of a pixel that several rays bring light to, in the order in which they came.
void TileTracer::shine(const PathRay& path, const glm::vec3& light) {
    glows_.push_back({light, path.pixel, visible_share(path), glimmers_.size()});
}

// What is seen beside the main surfaces, in mirrors and through glass.
void TileTracer::light_glimmers() {
    lit_.clear();
    for (const SeenSurface& surface : glimmers_) lit_.push_back(&surface);
    std::size_t glow = 0;
    const auto add_glows = [&](std::size_t surfaces) {
        for (; glow < glows_.size() && glows_[glow].after <= surfaces; ++glow)
            light_of(glows_[glow].pixel, glows_[glow].share) += glows_[glow].light;
    };
    visit_lit([&](std::size_t number, std::size_t i) {
        const SeenSurface& surface = glimmers_[number];
        add_glows(number);
        (void)collect_light(surface, i);
        if (frame_.settings.shares_samples) {
            ask_for_brightest(surface);
        } else {
            ask_for_all(surface);
        }
    });
    add_glows(glimmers_.size());
    glows_.clear();
    glimmers_.clear();
}

// What reaches the i-th of those that lamps_ was asked for.
SurfaceLight TileTracer::collect_light(const SeenSurface& surface, std::size_t i) {
    arrivals_.clear();
    lamps_.visit(i, [&](const LampsTogether::Arrived& arrived) {
        arrivals_.push_back({arrived.light, arrived.lamp, looks_.open(arrived.lamp, arrived.open)});
    });
    SurfaceLight light = lamps_.light(i);
    collect_ambient(surface, light);
    return light;
}

// Baked light, which shadow rays darken in corners that are smaller than the grid it was baked on.
void TileTracer::collect_ambient(const SeenSurface& surface, SurfaceLight& out) {
    const PathRay& path = surface.path;
    const ShadingPoint& at = surface.at;
    glm::vec3 irradiance, reflected;
    const glm::vec3 direction =
        path.ray.direction - at.normal * (2.0f * glm::dot(path.ray.direction, at.normal));
    frame_.light.ambient.gather(at.surface.position, at.normal, direction, irradiance, reflected);
    const glm::vec3 mirrored = surface.mirrored * reflected;
    const glm::vec3 light = path.weight * (surface.diffuse * irradiance * kPerPi + mirrored);
    if (!(brightest(light) > 0.0f)) return;
    out.irradiance += irradiance;
    out.shine += mirrored;
    const bool looks_round = (path.depth == 0 || path.is_leading) && frame_.settings.ambient_samples > 0;
    if (looks_round || share_of(path) == Share::Neighbours) {
        arrivals_.push_back({light, world::kNoIndex, kAmbientOpen});
    } else {
        light_of(path.pixel, visible_share(path)) += light;
    }
}

}  // namespace gh::render
