// The part of a tile that splits light at an opaque surface: what it scatters, shines back and mirrors.
#include "base/random.h"
#include "render/colour.h"
#include "render/fresnel.h"
#include "render/polish.h"
#include "render/tile.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace gh::render {

namespace {

// 0 where a weight is not worth following, 1 from twice that on: nothing pops in.
float worth(float weight, float least) {
    if (!(least > 0.0f)) return weight > 0.0f ? 1.0f : 0.0f;
    return std::clamp(weight / least - 1.0f, 0.0f, 1.0f);
}

// What paint gives back of what its gloss lets in. Half a metal is metal on half of the surface: paint is dimmed by its own
// gloss alone.
float paint_share(const GlossTable& gloss, const ShadingPoint& at, const glm::vec3& paint_f0,
                  const Polish& polish, float cos_eye) {
    if (!(at.metallic < 1.0f)) return 0.0f;
    const glm::vec3 mirrored = at.metallic > 0.0f
                                   ? gloss.albedo(paint_f0, grazing_share(paint_f0), cos_eye, at.roughness)
                                   : polish.glossy;
    return (1.0f - at.metallic) * (1.0f - brightest(mirrored));
}

}  // namespace

void TileTracer::shade_opaque(const PathRay& path, const ShadingPoint& at, const rc::Hit& hit,
                              FrameStats& stats) {
    const glm::vec3 to_eye = -path.ray.direction;
    const float cos_eye = glm::dot(at.normal, to_eye);
    const glm::vec3 paint_f0 =
        glm::min(at.specular_color * reflectance_head_on(at.material->ior), glm::vec3(1.0f)) * at.specular;
    const glm::vec3 f0 = glm::mix(paint_f0, at.base_color, at.metallic);
    const Polish polish = polish_of(frame_.gloss, f0, at.metallic, at.roughness, cos_eye);
    const glm::vec3& glossy = polish.glossy;
    const glm::vec3 diffuse = at.base_color * paint_share(frame_.gloss, at, paint_f0, polish, cos_eye);

    const float ray_share =
        path.depth < frame_.settings.max_depth
            ? polish.ray_share * worth(brightest(path.weight * glossy), frame_.settings.min_weight)
            : 0.0f;
    const bool is_mirror = brightest(glossy) * ray_share > brightest(diffuse);
    const float alpha = at.roughness * at.roughness;

    SeenSurface surface{.path = path,
                        .at = at,
                        .diffuse = diffuse,
                        .mirrored = glossy * (1.0f - ray_share),
                        .polished = glossy * ray_share,
                        .highlight_share = polish.highlight_share,
                        .gloss = {at.normal, to_eye, f0 * polish.shine, polish.f90 * polish.shine, alpha}};
    surface.path.is_leading = path.is_leading && !is_mirror;
    if (share_of(surface.path) == Share::Neighbours) {
        if (frame_.guide != nullptr) {
            note_thing(path, {.position = at.surface.position,
                              .previous = previous_position(frame_.view, hit, at.surface.position),
                              .geometric = at.geometric,
                              .albedo = guide_albedo(at.base_color, at.metallic),
                              .part = at.part});
            return;
        }
        note_surface(path, at);
        main_.add(surface);
        return;  // lit, and its mirrored ray sent, once its neighbours are known
    }
    if (frame_.guide == nullptr) glimmers_.push_back(surface);
    if (ray_share > 0.0f) {
        next_.push_back(mirrored_ray(surface));
        next_.back().is_leading = path.is_leading && is_mirror;
        ++stats.reflected_rays;
    }
}

PathRay TileTracer::mirrored_ray(const SeenSurface& surface) const {
    PathRay mirrored = surface.path;
    mirrored.ray =
        rc::spawn_ray(surface.at.surface, mirrored_direction(surface.path.ray.direction, surface.at));
    mirrored.weight *= surface.polished;
    mirrored.bulb_share = 1.0f - surface.highlight_share;
    mirrored.cone_angle += 2.0f * surface.gloss.alpha;  // a rough mirror blurs textures at least
    mirrored.depth = static_cast<std::uint8_t>(surface.path.depth + 1);
    mirrored.chain = hash_u32(surface.path.chain, surface.at.part, 1);
    mirrored.note_mirror(surface.at.normal);
    mirrored.is_leading = false;
    return mirrored;
}

}  // namespace gh::render
