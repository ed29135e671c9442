// The part of a tile that lights surfaces: lamps with their shadows and highlights, what a polished surface mirrors,
// and ambient light.
#include "base/det_math.h"
#include "render/fresnel.h"
#include "render/tile.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kPerPi = 1.0f / kPi;
// Roughness: below the first pair a bulb is seen in the mirrored ray, above it as a highlight; above the second pair
// no ray is sent and the ambient light stands in for what is mirrored.
constexpr float kMirrorBelow = 0.06f, kHighlightAbove = 0.14f;
constexpr float kRayBelow = 0.3f, kNoRayAbove = 0.5f;
constexpr float kDull = 0.6f,
                kDullest = 0.8f;    // highlights of rough dielectrics fade into their diffuse light
constexpr float kFaintest = 4e-4f;  // W/m2/sr in the picture: less than that is not worth a shadow ray

float brightest(const glm::vec3& c) {
    return std::max({c.x, c.y, c.z});
}

float smooth_step(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

// 0 where a weight is not worth following, 1 from twice that on: nothing pops in.
float worth(float weight, float least) {
    if (!(least > 0.0f)) return weight > 0.0f ? 1.0f : 0.0f;
    return std::clamp(weight / least - 1.0f, 0.0f, 1.0f);
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

void TileTracer::shade_opaque(const PathRay& path, const ShadingPoint& at, FrameStats& stats) {
    const glm::vec3 to_eye = -path.ray.direction;
    const float cos_eye = glm::dot(at.normal, to_eye);
    const glm::vec3 f0 =
        glm::mix(glm::vec3(reflectance_head_on(at.material->ior)), at.base_color, at.metallic);
    const float f90 = std::min(1.0f, 50.0f * brightest(f0));  // an index of 1 mirrors nothing at any angle
    const glm::vec3 glossy = frame_.gloss.albedo(f0, f90, cos_eye, at.roughness);
    const glm::vec3 diffuse = at.base_color * ((1.0f - at.metallic) * (1.0f - brightest(glossy)));

    const float ray_share = path.depth < frame_.settings.max_depth
                                ? (1.0f - smooth_step(kRayBelow, kNoRayAbove, at.roughness)) *
                                      worth(brightest(path.weight * glossy), frame_.settings.min_weight)
                                : 0.0f;
    const float highlight_share = smooth_step(kMirrorBelow, kHighlightAbove, at.roughness);
    const bool is_mirror = brightest(glossy) * ray_share > brightest(diffuse);

    PathRay lit = path;
    lit.is_leading = path.is_leading && !is_mirror;
    if (lit.is_leading) note_surface(lit, at);
    const float alpha = at.roughness * at.roughness;
    arrivals_.clear();
    const float shine =
        highlight_share * (1.0f - (1.0f - at.metallic) * smooth_step(kDull, kDullest, at.roughness));
    collect_lamps(lit, at, diffuse, {at.normal, to_eye, f0 * shine, f90 * shine, alpha});
    collect_ambient(lit, at, diffuse, glossy * (1.0f - ray_share));
    ask_for_shadows(lit, at);
    if (!(ray_share > 0.0f)) return;

    PathRay mirrored = path;
    mirrored.ray = rc::spawn_ray(at.surface, mirrored_direction(path.ray.direction, at));
    mirrored.weight *= glossy * ray_share;
    mirrored.bulb_share = 1.0f - highlight_share;
    mirrored.cone_angle += 2.0f * alpha;  // a rough mirror blurs textures at least
    mirrored.depth = static_cast<std::uint8_t>(path.depth + 1);
    mirrored.is_leading = path.is_leading && is_mirror;
    next_.push_back(mirrored);
    ++stats.reflected_rays;
}

void TileTracer::collect_lamps(const PathRay& path, const ShadingPoint& at, const glm::vec3& diffuse,
                               const Gloss& gloss) {
    const glm::vec3& position = at.surface.position;
    for (const std::uint32_t id : frame_.view.prepared.lamp_lists.at(position)) {
        if (frame_.light.lamp_on[id] == 0) continue;
        const world::Lamp& lamp = frame_.view.level.lamps[id];
        const glm::vec3 to_lamp = direction_to(lamp, position);
        glm::vec3 light = diffuse * lamp_irradiance(lamp, position, at.normal) * kPerPi;
        if (gloss.f90 > 0.0f) light += lamp_highlight(lamp, position, gloss);
        light *= path.weight * terminator(at, to_lamp);
        light *= worth(brightest(light), kFaintest);
        if (brightest(light) > 0.0f) arrivals_.push_back({light, id});
    }
}

// Baked light, which shadow rays darken in corners that are smaller than the grid it was baked on.
void TileTracer::collect_ambient(const PathRay& path, const ShadingPoint& at, const glm::vec3& diffuse,
                                 const glm::vec3& mirrored) {
    glm::vec3 irradiance, reflected;
    const glm::vec3 direction =
        path.ray.direction - at.normal * (2.0f * glm::dot(path.ray.direction, at.normal));
    frame_.light.ambient.gather(at.surface.position, at.normal, direction, irradiance, reflected);
    const glm::vec3 light = path.weight * (diffuse * irradiance * kPerPi + mirrored * reflected);
    if (!(brightest(light) > 0.0f)) return;
    const bool looks_round = (path.depth == 0 || path.is_leading) && frame_.settings.ambient_samples > 0;
    if (looks_round) {
        arrivals_.push_back({light, world::kNoIndex});
    } else {
        pixel(path).clean += light;
    }
}

void TileTracer::note_surface(const PathRay& path, const ShadingPoint& at) {
    PixelLight& light = pixel(path);
    if (light.size > 0.0f) return;  // the first sample speaks for the pixel
    light.position = at.surface.position;
    light.normal = at.geometric;
    const float cosine = std::max(0.05f, -glm::dot(path.ray.direction, at.geometric));
    light.size = path.cone_width / cosine;
}

}  // namespace gh::render
