// The part of a tile that looks through glass: each border splits a ray into a mirrored and a bent one.
#include "base/random.h"
#include "render/colour.h"
#include "render/fresnel.h"
#include "render/tile.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace gh::render {

namespace {}  // namespace

void TileTracer::shade_glass(const PathRay& path, const ShadingPoint& at, FrameStats& stats) {
    if (path.depth >= frame_.settings.max_depth) return;
    const bool is_solid = frame_.view.prepared.parts[at.part].is_solid_glass;
    const glm::vec3& direction = path.ray.direction;
    const float cosine = std::min(1.0f, -glm::dot(direction, at.normal));

    PathRay bent = path;
    float eta = at.material->ior;
    if (is_solid) {
        bent.media.cross(at.part, *at.material, at.is_entering);
        const Sides sides = sides_of(path.media, bent.media, *at.material, at.is_entering);
        if (!sides.is_border()) {
            if (bent.passes >= kMostPasses) return;
            ++bent.passes;
            bent.ray = rc::spawn_ray(at.surface, direction);
            next_.push_back(bent);
            ++stats.refracted_rays;
            return;
        }
        eta = sides.eta();
    }
    const Interface border = fresnel(cosine, eta);
    const float mirrored_share = is_solid ? border.reflectance : thin_sheet_reflectance(border.reflectance);

    bent.weight *= at.base_color * (1.0f - mirrored_share);
    bent.depth = static_cast<std::uint8_t>(path.depth + 1);
    bent.chain = hash_u32(path.chain, at.part, 0);
    PathRay mirrored = path;
    mirrored.chain = hash_u32(path.chain, at.part, 1);
    mirrored.weight *= mirrored_share;
    mirrored.depth = bent.depth;
    mirrored.note_mirror(at.normal);
    bent.is_leading = path.is_leading && mirrored_share <= 0.5f;
    mirrored.is_leading = path.is_leading && mirrored_share > 0.5f;

    if (brightest(bent.weight) > frame_.settings.min_weight) {
        const glm::vec3 onward =
            is_solid ? refracted(direction, at.normal, eta, cosine, border.cos_transmitted) : direction;
        // A bent normal must not send the ray back to the side it came from.
        if (glm::dot(onward, at.geometric) < 0.0f) {
            bent.ray = rc::spawn_ray(at.surface, onward);
            next_.push_back(bent);
            ++stats.refracted_rays;
        }
    }
    if (brightest(mirrored.weight) > frame_.settings.min_weight) {
        mirrored.ray = rc::spawn_ray(at.surface, mirrored_direction(direction, at));
        next_.push_back(mirrored);
        ++stats.reflected_rays;
    }
}

}  // namespace gh::render
