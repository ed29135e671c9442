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

// What is seen in mirrors and through glass is unfolded: it lies straight ahead, at the whole length of the way.
void TileTracer::note_thing(const PathRay& path, const ShadingPoint& at, const rc::Hit& hit) const {
    GuidePoint point{.position = at.surface.position,
                     .previous = at.surface.position,
                     .geometric = at.geometric,
                     .albedo = guide_albedo(at.base_color, at.metallic),
                     .part = at.part};
    if (path.chain == 0) {
        point.previous = previous_position(frame_.view, hit, point.position);
    } else {
        for (std::size_t i = path.mirrors; i-- > 0;) {
            const glm::vec3& mirror = path.mirror_normals[i];
            point.geometric -= mirror * (2.0f * glm::dot(point.geometric, mirror));
        }
        const int x = x_ + path.pixel % columns_, y = y_ + path.pixel / columns_;
        const rc::Ray straight = frame_.lens.ray(pixel_point(x, y));
        point.position = point.previous = straight.origin + straight.direction * path.length;
        point.part = hash_u32(path.chain, at.part) & ~1u;  // never kSky
    }
    note(point, picture_index(path.pixel), *frame_.guide);
}

}  // namespace gh::render
