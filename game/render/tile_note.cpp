// The part of a tile that notes what its pixels show, for those that put pixels of a frame, or frames, together.
#include "base/random.h"
#include "render/guide_point.h"
#include "render/tile.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace gh::render {

void TileTracer::note_surface(const PathRay& path, const ShadingPoint& at) {
    PixelLight& light = pixels_[path.pixel];
    const float cosine = std::max(0.05f, -glm::dot(path.ray.direction, at.geometric));
    PixelLight here;
    here.position = at.surface.position;
    here.normal = at.geometric;
    here.size = path.cone_width / cosine;
    if (light.size > 0.0f) {  // the first sample speaks for the pixel, if the others agree
        light.is_mixed = light.is_mixed || !are_together(light, here);
        return;
    }
    light.position = here.position;
    light.normal = here.normal;
    light.size = here.size;
}

// False, and nothing done, for what is not plain. As shade() has it, but for what a guide does without.
bool TileTracer::note_plain(const PathRay& path, const rc::Hit& hit) {
    const GuideTriangle& triangle = triangles_.of(frame_.view, hit);
    if (!triangle.is_plain) return false;
    const GuidePoint point = plain_point(frame_.view, triangle, path.ray, hit);
    note_thing(path, point);
    glm::vec3 weight(0.0f);
    if (frame_.light.emission_on[hit.instance] != 0) {
        const bool is_bulb = frame_.view.prepared.parts[hit.instance].lamp != world::kNoIndex;
        weight = path.weight * (is_bulb ? path.bulb_share : 1.0f);
        if (const world::Material* glass = path.media.top(); glass != nullptr)
            weight *= absorbed(*glass, glm::distance(path.from, point.position));
    }
    colors_.add(frame_.view, triangle, hit,
                {path.ray.direction, point.geometric, path.cone_width * frame_.settings.texture_blur},
                {&frame_.guide->albedo[picture_index(path.pixel)], &pixels_[path.pixel].clean, weight});
    return true;
}

// What is seen in mirrors and through glass is unfolded: it lies straight ahead, at the whole length of the way.
void TileTracer::note_thing(const PathRay& path, GuidePoint point) const {
    if (path.chain != 0) {
        for (std::size_t i = path.mirrors; i-- > 0;) {
            const glm::vec3& mirror = path.mirror_normals[i];
            point.geometric -= mirror * (2.0f * glm::dot(point.geometric, mirror));
        }
        const int x = x_ + path.pixel % columns_, y = y_ + path.pixel / columns_;
        const rc::Ray straight = frame_.lens.ray(pixel_point(x, y));
        point.position = point.previous = straight.origin + straight.direction * path.length;
        point.part = hash_u32(path.chain, point.part) & ~1u;  // never kSky
    }
    note(point, picture_index(path.pixel), *frame_.guide);
}

}  // namespace gh::render
