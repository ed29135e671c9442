#include "sim/level_kit.h"

#include "sim/grid_navmesh.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/quaternion.hpp>

namespace gh::test {

using world::Level;

LevelKit::LevelKit() {
    level.name = "kit";
    surface(world::Surface::Marble);
}

LevelKit& LevelKit::surface(world::Surface surface) {
    world::Material material;
    material.surface = surface;
    material_ = static_cast<std::uint32_t>(level.materials.size());
    level.materials.push_back(material);
    return *this;
}

std::uint32_t LevelKit::add_mesh(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles) {
    world::Mesh mesh;
    mesh.normals.assign(positions.size(), glm::vec3(0.0f, 1.0f, 0.0f));
    mesh.materials.assign(triangles.size(), material_);
    mesh.positions = std::move(positions);
    mesh.triangles = std::move(triangles);
    level.meshes.push_back(std::move(mesh));
    return static_cast<std::uint32_t>(level.meshes.size() - 1);
}

world::Part& LevelKit::add_part(std::uint32_t mesh, rc::LayerMask layers) {
    world::Part part;
    part.mesh = mesh;
    part.layers = layers;
    level.parts.push_back(part);
    return level.parts.back();
}

std::uint32_t LevelKit::box_mesh(const glm::vec3& a, const glm::vec3& b) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? b.x : a.x, (i & 2) != 0 ? b.y : a.y, (i & 4) != 0 ? b.z : a.z);
    }
    return add_mesh(corners, {{0, 4, 1}, {1, 4, 5}, {2, 3, 6}, {3, 7, 6}, {0, 1, 2}, {1, 3, 2},
                              {4, 6, 5}, {5, 6, 7}, {0, 2, 4}, {2, 6, 4}, {1, 5, 3}, {3, 5, 7}});
}

LevelKit& LevelKit::room(const glm::vec3& min, const glm::vec3& max) {
    const std::uint32_t mesh = box_mesh(min, max);
    for (glm::uvec3& triangle : level.meshes[mesh].triangles) std::swap(triangle.y, triangle.z);  // faces inwards
    add_part(mesh, kWall).is_shell = true;
    room_ = {min, max};
    return *this;
}

LevelKit& LevelKit::box(const glm::vec3& min, const glm::vec3& max, rc::LayerMask layers) {
    add_part(box_mesh(min, max), layers);
    if ((layers & world::Solid) != 0 && min.y < 1.8f && max.y > 0.3f) boxes_.push_back({min, max});
    return *this;
}

LevelKit& LevelKit::ramp(float x, float z_min, float z_max, float angle_deg, float length) {
    const float angle = angle_deg * 0.017453292f;
    const float run = length * std::cos(angle), rise = length * std::sin(angle);
    const glm::vec3 foot_a{x, 0.0f, z_min}, foot_b{x, 0.0f, z_max};
    const glm::vec3 top_a{x + run, rise, z_min}, top_b{x + run, rise, z_max};
    add_part(add_mesh({foot_a, foot_b, top_a, top_b}, {{0, 1, 2}, {1, 3, 2}}), kWall);
    return *this;
}

LevelKit& LevelKit::door(const glm::vec3& hinge, float width, float height, float open_angle) {
    const std::uint32_t mesh = box_mesh({0.0f, 0.0f, -0.02f}, {width, height, 0.02f});
    world::Part& part = add_part(mesh, kWall);
    part.mover = world::Mover::Door;
    part.mover_index = static_cast<std::uint32_t>(level.doors.size());
    world::Door door;
    door.hinge = hinge;
    door.open_angle = open_angle;
    door.handle = hinge + glm::vec3(width - 0.1f, 1.0f, 0.0f);
    level.doors.push_back(door);
    return *this;
}

LevelKit& LevelKit::glass_lid(const glm::vec3& hinge, float width, float depth) {
    const std::uint32_t mesh = box_mesh({0.0f, -0.005f, -depth}, {width, 0.005f, 0.0f});
    world::Part& part = add_part(mesh, world::Light | world::Sound | world::Solid);
    part.mover = world::Mover::Door;
    part.mover_index = static_cast<std::uint32_t>(level.doors.size());
    world::Door door;
    door.hinge = hinge;
    door.axis = {1.0f, 0.0f, 0.0f};
    door.open_angle = 1.9f;
    door.handle = hinge + glm::vec3(0.5f * width, 0.0f, -depth);
    level.doors.push_back(door);
    return *this;
}

LevelKit& LevelKit::mirror(const glm::vec3& centre, float half_width, float half_height, float yaw,
                           float turn_step) {
    const std::uint32_t mesh = add_mesh({{-half_width, -half_height, 0.0f},
                                         {half_width, -half_height, 0.0f},
                                         {-half_width, half_height, 0.0f},
                                         {half_width, half_height, 0.0f}},
                                        {{0, 1, 2}, {1, 3, 2}});
    world::Part& part = add_part(mesh, kWall);
    part.mover = world::Mover::Mirror;
    part.mover_index = static_cast<std::uint32_t>(level.mirrors.size());
    world::Mirror mirror;
    mirror.pivot = centre;
    mirror.world_from_rest = glm::angleAxis(yaw, glm::vec3(0.0f, 1.0f, 0.0f));
    mirror.turn_step = turn_step;
    mirror.pane_half_u = {half_width, 0.0f, 0.0f};
    mirror.pane_half_v = {0.0f, half_height, 0.0f};
    mirror.pane_part = static_cast<std::uint32_t>(level.parts.size() - 1);
    level.mirrors.push_back(mirror);
    return *this;
}

std::uint32_t LevelKit::group_named(const std::string& name) {
    if (name.empty()) return world::kNoIndex;
    const auto at = std::find(level.lamp_groups.begin(), level.lamp_groups.end(), name);
    if (at != level.lamp_groups.end()) return static_cast<std::uint32_t>(at - level.lamp_groups.begin());
    level.lamp_groups.push_back(name);
    return static_cast<std::uint32_t>(level.lamp_groups.size() - 1);
}

LevelKit& LevelKit::lamp(const glm::vec3& position, float watts_per_sr, const std::string& group) {
    world::Lamp lamp;
    lamp.position = position;
    lamp.intensity = glm::vec3(watts_per_sr);
    lamp.group = group_named(group);
    level.lamps.push_back(lamp);
    return *this;
}

LevelKit& LevelKit::light_switch(const glm::vec3& position, const std::string& group) {
    level.switches.push_back({.name = "switch", .title = "", .position = position, .group = group_named(group)});
    return *this;
}

LevelKit& LevelKit::lens(const glm::vec3& centre) {
    const std::uint32_t mesh = box_mesh(glm::vec3(-0.05f), glm::vec3(0.05f));
    world::Part& part = add_part(mesh, kWall);
    part.mover = world::Mover::Lens;
    part.mover_index = static_cast<std::uint32_t>(level.lenses.size());
    world::Lens lens;
    lens.world_from_lens[3] = centre;
    lens.centre = centre;
    level.lenses.push_back(lens);
    return *this;
}

LevelKit& LevelKit::exit(const glm::vec3& min, const glm::vec3& max) {
    level.exits.push_back({min, max});
    return *this;
}

LevelKit& LevelKit::spawn(const glm::vec3& feet, float yaw) {
    level.spawn = {feet, yaw};
    return *this;
}

LevelKit& LevelKit::guard(const glm::vec3& feet, float yaw, std::vector<world::PatrolPoint> patrol) {
    world::Guard guard;
    guard.position = feet;
    guard.yaw = yaw;
    guard.patrol = std::move(patrol);
    level.guards.push_back(std::move(guard));
    return *this;
}

bool LevelKit::is_walkable(float x, float z) const {
    constexpr float kKeep = 0.3f;
    const auto is_in = [x, z](const world::Aabb& box, float grown) {
        return box.min.x - grown < x && x < box.max.x + grown && box.min.z - grown < z && z < box.max.z + grown;
    };
    if (!is_in(room_, -kKeep)) return false;
    return std::none_of(boxes_.begin(), boxes_.end(),
                        [&](const world::Aabb& box) { return is_in(box, kKeep); });
}

std::shared_ptr<const Level> LevelKit::finish(bool with_navmesh) {
    const float r = level.stone_radius;
    const std::uint32_t stone = box_mesh(glm::vec3(-r), glm::vec3(r));
    level.stone_part_begin = static_cast<std::uint32_t>(level.parts.size());
    for (std::uint32_t i = 0; i < world::kMaxStones; ++i) {
        world::Part& part = add_part(stone, world::Light);
        part.mover = world::Mover::Stone;
        part.mover_index = i;
    }
    level.bounds = {glm::vec3(1e9f), glm::vec3(-1e9f)};
    for (const world::Part& part : level.parts) {
        if (part.mover != world::Mover::None) continue;
        for (const glm::vec3& p : level.meshes[part.mesh].positions) {
            level.bounds.min = glm::min(level.bounds.min, p);
            level.bounds.max = glm::max(level.bounds.max, p);
        }
    }
    if (with_navmesh) {
        Grid grid{.min_x = room_.min.x, .min_z = room_.min.z, .is_free = {}};
        grid.columns = static_cast<int>((room_.max.x - room_.min.x) / grid.cell);
        grid.rows = static_cast<int>((room_.max.z - room_.min.z) / grid.cell);
        grid.is_free = [&](int column, int row) {
            return is_walkable(grid.min_x + (static_cast<float>(column) + 0.5f) * grid.cell,
                               grid.min_z + (static_cast<float>(row) + 0.5f) * grid.cell);
        };
        level.navmesh = grid_navmesh(grid);
    }
    return std::make_shared<const Level>(level);
}

}  // namespace gh::test
