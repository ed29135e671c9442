#include "render/guide_gleams.h"

#include "render/colour.h"
#include "render/fresnel.h"
#include "render/light_math.h"
#include "render/polish.h"
#include "render/sky.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kFaintestHighlight = 3e-2f;  // W/m2/sr: highlights below are left to who lights few pixels,
constexpr float kFaintestPolish =
    0.055f;  // and so is what is mirrored where no more of it than that is given back
constexpr float kOutshining =
    0.5f;  // W/m2/sr: what a lit pixel says beneath such a highlight is that one's noise
constexpr float kWideOfLamp = 0.3f;        // of its distance
constexpr glm::vec3 kUnknownAlbedo(0.5f);  // of what is in a mirror or behind glass
constexpr float kGrazing = 0.02f;          // least cosine between a smooth normal and the eye

// Whether a mirrored ray passes a lamp by so much that what highlight there is, is wide and smooth. Never for a sun.
bool lies_aside(const LampReach& reach, const glm::vec3& from, const glm::vec3& direction) {
    const glm::vec3 offset = reach.position - from;
    const float along = glm::dot(offset, direction);
    const float distance2 = glm::dot(offset, offset);
    const float near = reach.extent + kWideOfLamp * std::sqrt(distance2);
    return distance2 - along * std::max(along, 0.0f) > near * near;
}

// Radiance that was baked along `direction`, about.
glm::vec3 baked_reflection(const AmbientLight& ambient, const glm::vec3& position, const glm::vec3& normal,
                           const glm::vec3& direction) {
    glm::vec3 irradiance, reflected;
    ambient.gather(position, normal, direction, irradiance, reflected);
    return reflected;
}

}  // namespace

void GleamTracer::add(const GuideTriangle& triangle, const rc::Ray& ray, const rc::Hit& hit,
                      std::size_t pixel, GuidePlanes& planes) {
    const world::Material& material = *triangle.material;
    const float side = glm::dot(triangle.normal, ray.direction) > 0.0f ? -1.0f : 1.0f;
    const glm::vec3 geometric = triangle.normal * side;
    const glm::vec3 normal =
        side * unit_or(triangle.smooth + triangle.smooth_edge1 * hit.u + triangle.smooth_edge2 * hit.v,
                       triangle.normal);
    const float cos_eye = -glm::dot(normal, ray.direction);
    if (!(cos_eye > kGrazing)) return;
    const glm::vec3 f0 =
        glm::mix(glm::vec3(std::min(reflectance_head_on(material.ior), 1.0f) * material.specular),
                 glm::vec3(material.base_color), material.metallic);
    const Polish polish = polish_of(world_.gloss, f0, material.metallic, material.roughness, cos_eye);
    const rc::SurfacePoint at = world_.view.snapshot.scene->surface(hit);
    const glm::vec3 mirrored = mirrored_direction(ray.direction, normal, geometric);
    const glm::vec3 weight = polish.glossy * polish.ray_share;
    const bool is_metal = material.metallic > 0.0f;
    if (brightest(weight) > kFaintestPolish) {
        rays_.push_back(rc::spawn_ray(at, mirrored));
        gleams_.push_back({weight, 1.0f - polish.highlight_share, pixel, is_metal});
    } else if (!is_metal) {
        planes.part[pixel] |= GuidePlanes::kUnmirrored;
    }
    if (is_metal)
        planes.clean.pixels[pixel] +=
            (polish.glossy - weight) * baked_reflection(world_.light.ambient, at.position, normal, mirrored);
    if (!world_.guides_lamps) return;
    add_highlights(pixel, at, mirrored,
                   {normal, -ray.direction, polish.f0 * polish.shine, polish.f90 * polish.shine,
                    material.roughness * material.roughness},
                   planes.outshone[pixel]);
}

void GleamTracer::add_highlights(std::size_t pixel, const rc::SurfacePoint& at, const glm::vec3& mirrored,
                                 const Gloss& gloss, std::uint8_t& outshone) {
    const Prepared& prepared = world_.view.prepared;
    for (const std::uint32_t id : prepared.lamp_lists.at(at.position)) {
        if (world_.light.lamp_on[id] == 0) continue;
        const LampReach& reach = world_.light.reaches[id];
        if (lies_aside(reach, at.position, mirrored)) continue;
        const IrradianceBound bound = irradiance_bound(reach, at.position, gloss.normal);
        if (!(bound.any > 0.0f && highlight_bound(reach, bound.any, at.position, gloss) > kFaintestHighlight))
            continue;
        const world::Lamp& lamp = world_.view.level.lamps[id];
        const glm::vec3 light = lamp_highlight(lamp, at.position, gloss);
        if (!(brightest(light) > kFaintestHighlight)) continue;
        const auto ray =
            shadow_ray(lamp, prepared.bulbs[id], at, lamp_point(lamp, at.position, glm::vec2(0.5f)));
        if (!ray) continue;
        shadow_rays_.push_back(*ray);
        highlights_.push_back({light, pixel});
        if (brightest(light) > kOutshining) outshone = 1;
    }
}

bool GleamTracer::add_shining(const Gleam& gleam, const rc::Ray& ray, const rc::Hit& hit,
                              GuidePlanes& planes) {
    if (world_.light.emission_on[hit.instance] == 0) return false;
    const GuideTriangle& triangle = triangles_.of(world_.view, hit);
    if (!triangle.is_plain || triangle.material->emission == glm::vec3(0.0f)) return false;
    const bool is_bulb = world_.view.prepared.parts[hit.instance].lamp != world::kNoIndex;
    if (is_bulb && !world_.guides_lamps) return true;
    const float share = is_bulb ? gleam.bulb_share : 1.0f;
    colors_.add(world_.view, triangle, hit, {ray.direction, triangle.normal, 0.0f},
                {&unused_, &planes.clean.pixels[gleam.pixel], gleam.weight * share});
    return true;
}

void GleamTracer::add_mirrored(const Gleam& gleam, const rc::Ray& ray, const rc::Hit& hit,
                               GuidePlanes& planes) {
    glm::vec3& clean = planes.clean.pixels[gleam.pixel];
    if (hit.is_miss()) {
        clean += gleam.weight * sky_radiance(world_.light.sun, ray.direction);
        return;
    }
    if (add_shining(gleam, ray, hit, planes)) return;
    const glm::vec3 before = previous_position(world_.view, hit, ray.origin + ray.direction * hit.t);
    if (const auto seen = world_.view.last->seen(before, hit.instance)) {
        clean += gleam.weight * *seen;
    } else if (gleam.is_of_metal) {
        guess(gleam, ray, hit);
    } else {
        planes.part[gleam.pixel] |= GuidePlanes::kUnmirrored;
    }
}

void GleamTracer::guess(const Gleam& gleam, const rc::Ray& ray, const rc::Hit& hit) {
    const GuideTriangle& triangle = triangles_.of(world_.view, hit);
    const bool is_known = triangle.is_plain || triangle.is_polished;
    const glm::vec3 normal = is_known ? triangle.normal : ray.direction;
    const glm::vec3 facing = glm::dot(normal, ray.direction) > 0.0f ? -normal : normal;
    const glm::vec3 position = ray.origin + ray.direction * hit.t;
    const glm::vec3 radiance = world_.light.ambient.irradiance(position, facing) * kPerPi;
    guesses_.push_back({gleam.weight * radiance, kUnknownAlbedo, gleam.pixel});
    if (is_known)
        colors_.add(world_.view, triangle, hit, {ray.direction, triangle.normal, 0.0f},
                    {&guesses_.back().albedo, &unused_, glm::vec3(0.0f)});
}

void GleamTracer::trace(GuidePlanes& planes) {
    hits_.resize(rays_.size());
    rc::closest_hits(*world_.view.snapshot.scene, rays_, world::Light, hits_);
    guesses_.reserve(gleams_.size());  // colours wait for their places in it
    for (std::size_t i = 0; i < gleams_.size(); ++i) add_mirrored(gleams_[i], rays_[i], hits_[i], planes);
    colors_.flush();
    for (const Guess& guess : guesses_) planes.clean.pixels[guess.pixel] += guess.light * guess.albedo;
    guesses_.clear();
    shares_.resize(shadow_rays_.size());
    shadows_.answer(world_.view, shadow_rays_, shares_);
    for (std::size_t i = 0; i < highlights_.size(); ++i)
        planes.clean.pixels[highlights_[i].pixel] += highlights_[i].light * shares_[i];
    rays_.clear();
    gleams_.clear();
    shadow_rays_.clear();
    highlights_.clear();
}

}  // namespace gh::render
