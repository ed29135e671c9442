#include "sense/faces.h"

#include "world/lookup.h"

#include "raycore/query.h"

#include <array>
#include <cmath>

namespace gh::sense {
namespace {

bool is_known(std::span<const Face> faces, const Face& face) {
    for (std::size_t i = faces.size(); i-- > 0 && face.t - faces[i].t <= kSameFace;) {
        if (faces[i].part == face.part && faces[i].enters == face.enters) return true;
    }
    return false;
}

}  // namespace

Faces faces_between(const world::Level& level, const rc::Scene& scene, const glm::vec3& from,
                    const glm::vec3& to, rc::LayerMask layers, std::span<Face, kMaxFaces> out) {
    if (from == to) return {};  // no way at all, and no ray either
    std::array<rc::Hit, kMaxFaces> hits;
    const std::size_t met = rc::crossings(scene, from, to, layers, hits);
    const glm::vec3 way = to - from;
    const float length = std::sqrt((way.x * way.x + way.y * way.y) + way.z * way.z);
    Faces faces{.count = 0, .is_complete = met < kMaxFaces};
    for (const rc::Hit& hit : std::span(hits).first(met)) {
        const glm::vec3 normal = scene.surface(hit).normal;
        const float along = (normal.x * way.x + normal.y * way.y) + normal.z * way.z;
        const Face face{.material = &world::material_at(level, hit),
                        .part = hit.instance,
                        .t = hit.t,
                        .cosine = std::abs(along) / length,
                        .enters = along < 0.0f};
        if (is_known(out.first(faces.count), face)) continue;
        out[faces.count] = face;
        ++faces.count;
    }
    return faces;
}

}  // namespace gh::sense
