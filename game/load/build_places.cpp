// Places: where one starts, stands, leaves and looks from, and the switches on the walls.
#include "base/det_math.h"
#include "load/gltf_extras.h"
#include "load/gltf_numbers.h"
#include "load/level_build.h"
#include "load/part_geometry.h"

#include <fmt/format.h>

#include <algorithm>

namespace gh::load {
namespace {

glm::vec3 position_of(const LevelBuild& build, std::uint32_t id) {
    return glm::vec3(build.tree.world_from_node[id][3]);
}

Result<world::Aabb> box_of(const LevelBuild& build, std::uint32_t id) {
    const Result<glm::vec3> size = vector_or(build.extras(id), "size", glm::vec3(0.0f));
    if (!size) return size.error();
    if (!(size->x > 0.0f && size->y > 0.0f && size->z > 0.0f))
        return Error{"needs a size of three positive numbers"};
    const glm::vec3 centre = position_of(build, id);
    return world::Aabb{centre - 0.5f * *size, centre + 0.5f * *size};
}

Result<void> add_room(LevelBuild& build, std::uint32_t id) {
    const Result<world::Aabb> box = box_of(build, id);
    if (!box) return box.error();
    const Result<std::string> title = text_or(build.extras(id), "title", build.node(id).name);
    if (!title) return title.error();
    build.level.rooms.push_back({build.node(id).name, *title, *box});
    return {};
}

Result<void> add_exit(LevelBuild& build, std::uint32_t id) {
    const Result<world::Aabb> box = box_of(build, id);
    if (!box) return box.error();
    build.level.exits.push_back(*box);
    return {};
}

Result<void> add_switch(LevelBuild& build, std::uint32_t id) {
    std::vector<world::Switch>& switches = build.level.switches;
    if (switches.size() == world::kMaxSwitches)
        return Error{fmt::format("is one switch more than {}", switches.size())};
    const Result<std::string> title = text_or(build.extras(id), "title", "");
    if (!title) return title.error();
    const Result<std::string> group_name = text_or(build.extras(id), "group", "");
    if (!group_name) return group_name.error();
    if (group_name->empty()) return Error{"a switch needs the group of lamps it turns on and off"};
    const Result<std::uint32_t> group = group_by_name(build, *group_name);
    if (!group) return group.error();
    world::Aabb box = empty_box();
    for (std::uint32_t part = build.facts[id].part_begin; part < build.facts[id].part_end; ++part) {
        const world::Part& drawn = build.level.parts[part];
        const glm::mat4x3 world_from_part = world_from_part_at_rest(build.level, drawn);
        for (const glm::vec3& p : build.meshes.mesh(drawn.mesh).positions)
            grow(box, transform_point(world_from_part, p));
    }
    const glm::vec3 position = box.min.x <= box.max.x ? 0.5f * (box.min + box.max) : position_of(build, id);
    switches.push_back({build.node(id).name, *title, position, *group});
    return {};
}

Result<void> add_viewpoint(LevelBuild& build, std::uint32_t id, int camera_id) {
    if (static_cast<std::size_t>(camera_id) >= build.model.cameras.size()) {
        return Error{fmt::format("camera {} does not exist", camera_id)};
    }
    const tinygltf::Camera& camera = build.model.cameras[static_cast<std::size_t>(camera_id)];
    const glm::dmat4& world_from_camera = build.tree.world_from_node[id];
    world::Viewpoint view;
    view.name = build.node(id).name.empty() ? camera.name : build.node(id).name;
    view.position = position_of(build, id);
    view.yaw = yaw_of(world_from_camera);
    view.pitch = pitch_of(world_from_camera);
    view.roll = roll_of(world_from_camera);
    const NumberReader numbers(fmt::format("camera '{}'", view.name), build.level.remarks);
    if (camera.type == "perspective") {
        view.fov_y = numbers.within("yfov", camera.perspective.yfov, {0.01, 3.0});
    } else {
        numbers.remark("is orthographic, and shown in perspective");
    }
    build.level.viewpoints.push_back(std::move(view));
    return {};
}

Result<void> read_place(LevelBuild& build, std::uint32_t id) {
    switch (build.facts[id].kind) {
        case Kind::Room:
            return add_room(build, id);
        case Kind::Exit:
            return add_exit(build, id);
        case Kind::Switch:
            return add_switch(build, id);
        case Kind::Spawn:
            build.level.spawn = {position_of(build, id), yaw_of(build.tree.world_from_node[id])};
            return {};
        default:
            break;
    }
    const int camera = build.node(id).camera;
    return camera >= 0 ? add_viewpoint(build, id, camera) : Result<void>{};
}

}  // namespace

Result<void> build_places(LevelBuild& build) {
    bool has_spawn = false;
    for (const std::uint32_t id : build.tree.order) {
        const bool is_spawn = build.facts[id].kind == Kind::Spawn;
        if (is_spawn && has_spawn) return at_node(build, id, "is a second spawn");
        has_spawn = has_spawn || is_spawn;
        if (Result<void> read = read_place(build, id); !read)
            return at_node(build, id, read.error().sentence);
    }
    return {};
}

}  // namespace gh::load
