#include "load/mesh_lamps.h"

#include "base/det_math.h"
#include "load/flat_face.h"
#include "load/part_geometry.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::load {
namespace {

bool shines(const world::Material& material) {
    return material.emission != glm::vec3(0.0f);
}

world::Lamp make_ball(const Triangles& shining) {
    const world::Aabb box = bounds_of(shining.positions);
    const glm::vec3 size = box.max - box.min;
    world::Lamp lamp;
    lamp.shape = world::LampShape::Sphere;
    lamp.position = 0.5f * (box.min + box.max);
    lamp.radius = ((size.x + size.y) + size.z) / 6.0f;
    return lamp;
}

// A face that does not fill its rectangle gives a smaller one: what counts is how much light it sends.
world::Lamp make_panel(const FlatFace& face) {
    const float rectangle = 4.0f * glm::length(face.half_u) * glm::length(face.half_v);
    const float shrink = std::sqrt(std::min(face.area / rectangle, 1.0f));
    world::Lamp lamp;
    lamp.shape = world::LampShape::Rect;
    lamp.position = face.centre;
    lamp.direction = face.normal;
    lamp.half_u = face.half_u * shrink;
    lamp.half_v = face.half_v * shrink;
    return lamp;
}

}  // namespace

std::optional<world::Lamp> lamp_of_part(const LevelBuild& build, std::uint32_t part_id, MeshLampShape shape) {
    const world::Part& part = build.level.parts[part_id];
    const glm::mat4x3 world_from_part = world_from_part_at_rest(build.level, part);
    const std::vector<world::Material>& materials = build.materials.materials;
    const Triangles shining =
        part_triangles(build.meshes.mesh(part.mesh), world_from_part,
                       [&](std::uint32_t material) { return shines(materials[material]); });
    const std::optional<FlatFace> face = largest_flat_face(shining.positions, shining.triangles);
    if (!face) return std::nullopt;
    constexpr float kMostlyFlat = 0.9f;
    const bool is_panel = shape == MeshLampShape::Rect ||
                          (shape == MeshLampShape::Either && face->area >= kMostlyFlat * face->whole_area);
    world::Lamp lamp = is_panel ? make_panel(*face) : make_ball(shining);
    lamp.name = part.name;
    lamp.part = part_id;
    lamp.intensity = materials[shining.materials[face->triangle]].emission;
    lamp.range = range_of(lamp);
    return lamp;
}

float range_of(const world::Lamp& lamp) {
    constexpr float kFaintest = 1.0e-3f;  // W/m2
    const float most = std::max({lamp.intensity.x, lamp.intensity.y, lamp.intensity.z});
    float candle_power = most;  // W/sr towards where it is strongest
    switch (lamp.shape) {
        case world::LampShape::Sun:
            return rc::kInfinity;
        case world::LampShape::Point:
        case world::LampShape::Spot:
            break;
        case world::LampShape::Sphere:
            candle_power = most * kPi * lamp.radius * lamp.radius;
            break;
        case world::LampShape::Rect:
            candle_power = most * 4.0f * glm::length(lamp.half_u) * glm::length(lamp.half_v);
            break;
    }
    return std::sqrt(candle_power / kFaintest);
}

}  // namespace gh::load
