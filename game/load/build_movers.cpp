// Things that turn or go away: doors, mirrors and lenses. First where they turn, which their parts hang on;
// then, from the parts, where one takes hold of them and what they show.
#include "base/det_math.h"
#include "load/flat_face.h"
#include "load/gltf_extras.h"
#include "load/level_build.h"
#include "load/part_geometry.h"
#include "world/layers.h"
#include "world/state.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::load {
namespace {

constexpr float kRadiansPerDegree = kPi / 180.0f;

Result<glm::vec3> axis_from_name(const std::string& name) {
    if (name == "x") return glm::vec3(1.0f, 0.0f, 0.0f);
    if (name == "y") return glm::vec3(0.0f, 1.0f, 0.0f);
    if (name == "z") return glm::vec3(0.0f, 0.0f, 1.0f);
    return Error{fmt::format("there is no axis '{}'", name)};
}

Error too_many(std::string_view what, std::size_t most) {
    return Error{fmt::format("is one {} more than {}", what, most)};
}

Result<void> add_door(LevelBuild& build, std::uint32_t id) {
    if (build.level.doors.size() == world::kMaxDoors) return too_many("door", world::kMaxDoors);
    const tinygltf::Value& extras = build.extras(id);
    const Result<std::string> title = text_or(extras, "title", "");
    if (!title) return title.error();
    const Result<float> angle_deg = number_or(extras, "open_angle_deg", 95.0f);
    if (!angle_deg) return angle_deg.error();
    const Result<float> time_s = number_or(extras, "open_time_s", 0.8f);
    if (!time_s) return time_s.error();
    const Result<std::string> axis_name = text_or(extras, "axis", "y");
    if (!axis_name) return axis_name.error();
    const Result<glm::vec3> axis = axis_from_name(*axis_name);
    if (!axis) return axis.error();
    if (!(std::abs(*angle_deg) <= 360.0f)) return Error{"open_angle_deg must lie within -360 and 360"};
    if (!(*time_s >= 0.05f && *time_s <= 60.0f)) return Error{"open_time_s must lie within 0.05 and 60"};

    const Pose pose = pose_of(build.tree.world_from_node[id]);
    world::Door door;
    door.name = build.node(id).name;
    door.title = *title;
    door.hinge = glm::vec3(pose.position);
    door.world_from_rest = glm::quat(pose.rotation);
    door.axis = *axis;
    door.open_angle = *angle_deg * kRadiansPerDegree;
    door.open_ticks = *time_s * static_cast<float>(world::kTicksPerSecond);
    build.facts[id].mover = world::Mover::Door;
    build.facts[id].mover_index = static_cast<std::uint32_t>(build.level.doors.size());
    build.level.doors.push_back(std::move(door));
    return {};
}

Result<void> add_mirror(LevelBuild& build, std::uint32_t id) {
    if (build.level.mirrors.size() == world::kMaxMirrors) return too_many("mirror", world::kMaxMirrors);
    const tinygltf::Value& extras = build.extras(id);
    const Result<std::string> title = text_or(extras, "title", "");
    if (!title) return title.error();
    const Result<float> step_deg = number_or(extras, "turn_step_deg", 0.0f);
    if (!step_deg) return step_deg.error();
    if (!(std::abs(*step_deg) <= 360.0f)) return Error{"turn_step_deg must lie within -360 and 360"};
    const Result<bool> is_carried = flag_or(extras, "carry", false);
    if (!is_carried) return is_carried.error();
    if (*is_carried && *step_deg != 0.0f) return Error{"is a mirror both to carry and to turn"};
    if (*is_carried && build.level.hand_mirror != world::kNoIndex) return too_many("mirror to carry", 1);

    const Pose pose = pose_of(build.tree.world_from_node[id]);
    world::Mirror mirror;
    mirror.name = build.node(id).name;
    mirror.title = *title;
    mirror.pivot = glm::vec3(pose.position);
    mirror.world_from_rest = glm::quat(pose.rotation);
    mirror.turn_step = *step_deg * kRadiansPerDegree;
    if (*is_carried) build.level.hand_mirror = static_cast<std::uint32_t>(build.level.mirrors.size());
    build.facts[id].mover = world::Mover::Mirror;
    build.facts[id].mover_index = static_cast<std::uint32_t>(build.level.mirrors.size());
    build.level.mirrors.push_back(std::move(mirror));
    return {};
}

Result<void> add_lens(LevelBuild& build, std::uint32_t id) {
    if (build.level.lenses.size() == world::kMaxLenses) return too_many("lens", world::kMaxLenses);
    const Result<std::string> title = text_or(build.extras(id), "title", "");
    if (!title) return title.error();
    world::Lens lens;
    lens.name = build.node(id).name;
    lens.title = *title;
    lens.world_from_lens = to_affine(pose_of(build.tree.world_from_node[id]).matrix());
    build.facts[id].mover = world::Mover::Lens;
    build.facts[id].mover_index = static_cast<std::uint32_t>(build.level.lenses.size());
    build.level.lenses.push_back(std::move(lens));
    return {};
}

// Bounds, in the mover's own frame, of everything that moves with it; min > max when nothing does.
world::Aabb bounds_in_mover(const LevelBuild& build, world::Mover mover, std::uint32_t index) {
    world::Aabb box = empty_box();
    for (const world::Part& part : build.level.parts) {
        if (part.mover != mover || part.mover_index != index) continue;
        for (const glm::vec3& p : build.meshes.mesh(part.mesh).positions)
            grow(box, transform_point(part.mover_from_part, p));
    }
    return box;
}

bool is_empty(const world::Aabb& box) {
    return box.min.x > box.max.x;
}

// A hand goes to the middle of the edge that lies farthest from the hinge.
Result<void> finish_door(LevelBuild& build, std::uint32_t index) {
    world::Door& door = build.level.doors[index];
    const world::Aabb box = bounds_in_mover(build, world::Mover::Door, index);
    if (is_empty(box)) return Error{"is a door without a mesh"};
    glm::vec3 handle = 0.5f * (box.min + box.max);
    glm::length_t farthest = 0;
    float reach = -1.0f;
    for (glm::length_t side = 0; side < 3; ++side) {
        const float most = std::max(std::abs(box.min[side]), std::abs(box.max[side]));
        if (door.axis[side] != 0.0f || most <= reach) continue;
        reach = most;
        farthest = side;
    }
    constexpr float kFromTheEdge = 0.9f;
    const bool is_beyond = std::abs(box.max[farthest]) >= std::abs(box.min[farthest]);
    handle[farthest] = kFromTheEdge * (is_beyond ? box.max[farthest] : box.min[farthest]);
    door.handle = door.hinge + door.world_from_rest * handle;
    return {};
}

bool is_mirror_material(const world::Material& material) {
    return material.metallic >= 0.999f && material.roughness <= 0.05f && material.transmission == 0.0f;
}

// What is carried is seen and lit; nobody runs into it, and no wall of sound is made of it.
void make_weightless(LevelBuild& build, std::uint32_t index) {
    if (index != build.level.hand_mirror) return;
    for (world::Part& part : build.level.parts) {
        if (part.mover != world::Mover::Mirror || part.mover_index != index) continue;
        part.layers &= ~rc::LayerMask{world::Sound | world::Solid};
    }
}

// The pane is the largest flat face that mirrors.
Result<void> finish_mirror(LevelBuild& build, std::uint32_t index) {
    world::Mirror& mirror = build.level.mirrors[index];
    const std::vector<world::Material>& materials = build.materials.materials;
    float largest = 0.0f;
    for (std::uint32_t i = 0; i < build.level.parts.size(); ++i) {
        const world::Part& part = build.level.parts[i];
        if (part.mover != world::Mover::Mirror || part.mover_index != index) continue;
        const Triangles mirroring =
            part_triangles(build.meshes.mesh(part.mesh), part.mover_from_part,
                           [&](std::uint32_t material) { return is_mirror_material(materials[material]); });
        const std::optional<FlatFace> face = largest_flat_face(mirroring.positions, mirroring.triangles);
        if (!face || face->area <= largest) continue;
        largest = face->area;
        mirror.pane_centre = face->centre;
        mirror.pane_half_u = face->half_u;
        mirror.pane_half_v = face->half_v;
        mirror.reflectance = glm::vec3(materials[mirroring.materials[face->triangle]].base_color);
        mirror.pane_part = i;
    }
    make_weightless(build, index);
    if (largest > 0.0f) return {};
    return Error{"is a mirror without a mirror material (metallic 1, roughness at most 0.05)"};
}

Result<void> finish_lens(LevelBuild& build, std::uint32_t index) {
    world::Lens& lens = build.level.lenses[index];
    const world::Aabb box = bounds_in_mover(build, world::Mover::Lens, index);
    if (is_empty(box)) return Error{"is a lens without a mesh"};
    lens.centre = transform_point(lens.world_from_lens, 0.5f * (box.min + box.max));
    return {};
}

}  // namespace

Result<void> build_movers(LevelBuild& build) {
    for (const std::uint32_t id : build.tree.order) {
        Result<void> added;
        switch (build.facts[id].kind) {
            case Kind::Door:
                added = add_door(build, id);
                break;
            case Kind::Mirror:
                added = add_mirror(build, id);
                break;
            case Kind::Lens:
                added = add_lens(build, id);
                break;
            default:
                break;
        }
        if (!added) return at_node(build, id, added.error().sentence);
    }
    return {};
}

Result<void> finish_movers(LevelBuild& build) {
    for (const std::uint32_t id : build.tree.order) {
        Result<void> finished;
        switch (build.facts[id].kind) {
            case Kind::Door:
                finished = finish_door(build, build.facts[id].mover_index);
                break;
            case Kind::Mirror:
                finished = finish_mirror(build, build.facts[id].mover_index);
                break;
            case Kind::Lens:
                finished = finish_lens(build, build.facts[id].mover_index);
                break;
            default:
                break;
        }
        if (!finished) return at_node(build, id, finished.error().sentence);
    }
    return {};
}

}  // namespace gh::load
