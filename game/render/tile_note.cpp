// The part of a tile that notes what its pixels show, for those that put pixels of a frame, or frames, together.
#include "base/random.h"
#include "render/tile.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace gh::render {

void TileTracer::note_surface(const PathRay& path, const ShadingPoint& at, const rc::Hit& hit) {
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
    if (frame_.settings.notes_things) note_thing(path, at, hit, light);
}

void TileTracer::note_thing(const PathRay& path, const ShadingPoint& at, const rc::Hit& hit,
                            PixelLight& light) const {
    light.facing = at.geometric;
    light.part = at.part;
    light.unfolded = light.previous = at.surface.position;
    if (path.chain != 0) {
        for (std::size_t i = path.mirrors; i-- > 0;) {
            const glm::vec3& mirror = path.mirror_normals[i];
            light.facing -= mirror * (2.0f * glm::dot(light.facing, mirror));
        }
        const int x = x_ + path.pixel % columns_, y = y_ + path.pixel / columns_;
        const rc::Ray straight = frame_.lens.ray(pixel_point(x, y));
        light.unfolded = light.previous = straight.origin + straight.direction * path.length;
        light.part = hash_u32(path.chain, at.part) & ~1u;  // never kNone
    } else if (frame_.view.before != nullptr &&
               frame_.view.level.parts[at.part].mover != world::Mover::None) {
        light.previous = frame_.view.before->scene->surface(hit).position;
    }
}

}  // namespace gh::render
