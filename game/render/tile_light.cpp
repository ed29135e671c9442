// The part of a tile that finds what light reaches a surface if nothing is in its way: from lamps, and baked, from all
// around.
#include "base/det_math.h"
#include "render/colour.h"
#include "render/lamp_bounds.h"
#include "render/light_math.h"
#include "render/tile.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace gh::render {

namespace {

constexpr float kFaintestSeen = 4e-4f;  // W/m2/sr in the picture: less than that is not worth a shadow ray
constexpr float kNothing = 0.25f * kFaintestSeen;  // a part of a lamp's light that is not worked out
constexpr float kLeastTurning =
    0.05f;  // a lamp nearer the horizon does not tell how its light turns with the normal

constexpr float kAmbientOpen = 0.9f;  // of what is baked, past what stands in corners

// 0 where light is too faint to matter, 1 from twice that on: nothing pops in.
float worth(float light) {
    return std::clamp(light / kFaintestSeen - 1.0f, 0.0f, 1.0f);
}

// Takes light away smoothly where the smooth surface still faces a lamp that its triangles turn away from, which
// would otherwise show them one by one (Chiang, Li and Burley 2019).
float terminator(const ShadingPoint& at, const glm::vec3& to_lamp) {
    const float cos_bend = glm::dot(at.geometric, at.normal);
    if (cos_bend > 0.99999f) return 1.0f;
    const float cos_geometric = glm::dot(at.geometric, to_lamp);
    const float cos_smooth = glm::dot(at.normal, to_lamp);
    if (!(cos_smooth > 0.0f)) return 1.0f;
    const float g = std::clamp(cos_geometric / (cos_smooth * std::max(cos_bend, 0.05f)), 0.0f, 1.0f);
    return g * (1.0f + g - g * g);
}

}  // namespace

SurfaceLight TileTracer::collect_light(const SeenSurface& surface) {
    arrivals_.clear();
    SurfaceLight light;
    collect_lamps(surface, light);
    collect_ambient(surface, light);
    return light;
}

void TileTracer::collect_lamps(const SeenSurface& surface, SurfaceLight& out) {
    const ShadingPoint& at = surface.at;
    const glm::vec3& position = at.surface.position;
    const glm::vec3 diffuse = surface.path.weight * surface.diffuse * kPerPi;
    const float most_diffuse = brightest(diffuse), most_shine = brightest(surface.path.weight);
    const LampLists::Near near = frame_.view.prepared.lamp_lists.near(position);
    for (std::size_t i = 0; i < near.lamps.size(); ++i) {
        const std::uint32_t id = near.lamps[i];
        if (frame_.light.lamp_on[id] == 0) continue;
        const LampReach& reach = frame_.light.reaches[id];
        const IrradianceBound bound = irradiance_bound(reach, position, at.normal);
        const bool scatters = bound.facing * most_diffuse > kNothing;
        const bool shines =
            surface.gloss.f90 > 0.0f && bound.any > 0.0f &&
            highlight_bound(reach, bound.any, position, surface.gloss) * most_shine > kNothing;
        if (!scatters && !shines) continue;
        const world::Lamp& lamp = frame_.view.level.lamps[id];
        const glm::vec3 to_lamp = direction_to(lamp, position);
        const float share = terminator(at, to_lamp);
        glm::vec3 irradiance(0.0f), shine(0.0f);
        if (scatters) irradiance = lamp_irradiance(lamp, position, at.normal) * share;
        if (shines) shine = lamp_highlight(lamp, position, surface.gloss) * share;
        const glm::vec3 light = diffuse * irradiance + surface.path.weight * shine;
        const float counts = worth(brightest(light));
        if (!(counts > 0.0f)) continue;
        arrivals_.push_back({light * counts, id, looks_.open(id, near.open[i])});
        irradiance *= counts;
        out.irradiance += irradiance;
        out.shine += shine * counts;
        const float cosine = glm::dot(to_lamp, at.normal);
        if (cosine > kLeastTurning) out.turns += glm::outerProduct(irradiance / cosine, to_lamp);
    }
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
