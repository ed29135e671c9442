// support/small_level.h - little worlds to ask questions of: boxes, panes, sheets, and a jointed doll for a guard.
//
// Header only, so that test_support need not link the game.
#pragma once

#include "world/layers.h"
#include "world/level.h"
#include "world/state.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace gh::test {

class SmallLevel {
  public:
    world::Level level;

    std::uint32_t add_material(const world::Material& material) {
        level.materials.push_back(material);
        return static_cast<std::uint32_t>(level.materials.size() - 1);
    }
    std::uint32_t add_material(world::Surface surface) {
        world::Material material;
        material.surface = surface;
        return add_material(material);
    }

    // A closed box, corners counter-clockwise from outside; with `is_inside_out`, from inside: a room.
    std::uint32_t add_box(const glm::vec3& min, const glm::vec3& max, std::uint32_t material,
                          bool is_inside_out = false) {
        world::Mesh mesh;
        for (unsigned i = 0; i < 8; ++i) {
            mesh.positions.emplace_back((i & 1u) != 0 ? max.x : min.x, (i & 2u) != 0 ? max.y : min.y,
                                        (i & 4u) != 0 ? max.z : min.z);
        }
        constexpr std::array<std::array<unsigned, 4>, 6> kFaces = {
            {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
        for (const auto& f : kFaces) {
            mesh.triangles.emplace_back(f[0], f[1], f[2]);
            mesh.triangles.emplace_back(f[0], f[2], f[3]);
        }
        if (is_inside_out) {
            for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
        }
        return add_part(std::move(mesh), material);
    }

    // A single sheet whose front faces along cross(half_u, half_v).
    std::uint32_t add_sheet(const glm::vec3& centre, const glm::vec3& half_u, const glm::vec3& half_v,
                            std::uint32_t material) {
        world::Mesh mesh;
        mesh.positions = {centre - half_u - half_v, centre + half_u - half_v, centre + half_u + half_v,
                          centre - half_u + half_v};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
        return add_part(std::move(mesh), material);
    }

    std::uint32_t add_part(world::Mesh mesh, std::uint32_t material) {
        mesh.materials.assign(mesh.triangles.size(), material);
        if (mesh.normals.empty()) mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0f, 1.0f, 0.0f));
        level.meshes.push_back(std::move(mesh));
        world::Part part;
        part.mesh = static_cast<std::uint32_t>(level.meshes.size() - 1);
        part.layers = world::kEverything;
        level.parts.push_back(part);
        return static_cast<std::uint32_t>(level.parts.size() - 1);
    }

    world::Part& part(std::uint32_t id) { return level.parts[id]; }

    // Hangs a part on a new door that turns about +y at `hinge`; the part's geometry is given relative to the hinge.
    std::uint32_t hang_door(std::uint32_t door_part, const glm::vec3& hinge) {
        world::Door door;
        door.hinge = hinge;
        level.doors.push_back(door);
        const auto id = static_cast<std::uint32_t>(level.doors.size() - 1);
        part(door_part).mover = world::Mover::Door;
        part(door_part).mover_index = id;
        return id;
    }

    std::uint32_t add_lamp(const world::Lamp& lamp) {
        level.lamps.push_back(lamp);
        return static_cast<std::uint32_t>(level.lamps.size() - 1);
    }
};

// A column of rings round +y, 1.8 m high, on three joints one above the other: hips, chest, head. Vertices between two
// joints belong to both. Facing -z.
inline world::Mesh doll_mesh() {
    constexpr unsigned kRings = 19, kSides = 8;
    world::Mesh mesh;
    for (unsigned ring = 0; ring < kRings; ++ring) {
        const float y = 0.1f * static_cast<float>(ring);
        const float chest = std::clamp((y - 0.9f) / 0.6f, 0.0f, 1.0f);
        const bool is_head = y > 1.5f;
        for (unsigned side = 0; side < kSides; ++side) {
            const float angle = 0.78539816f * static_cast<float>(side);
            const glm::vec3 out(std::cos(angle), 0.0f, std::sin(angle));
            mesh.positions.push_back(out * 0.2f + glm::vec3(0.0f, y, 0.0f));
            mesh.normals.push_back(out);
            mesh.joints.emplace_back(0, 1, 2, 0);
            mesh.weights.push_back(is_head ? glm::vec4(0.0f, 0.0f, 1.0f, 0.0f)
                                           : glm::vec4(1.0f - chest, chest, 0.0f, 0.0f));
        }
    }
    for (unsigned ring = 0; ring + 1 < kRings; ++ring) {
        for (unsigned side = 0; side < kSides; ++side) {
            const unsigned a = ring * kSides + side, b = ring * kSides + (side + 1) % kSides;
            mesh.triangles.emplace_back(a, a + kSides, b);
            mesh.triangles.emplace_back(b, a + kSides, b + kSides);
        }
    }
    return mesh;
}

inline glm::mat4x3 moved_by(const glm::vec3& offset) {
    return {glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(0.0f, 0.0f, 1.0f), offset};
}

inline constexpr float kDollHips = 0.9f, kDollChest = 1.2f, kDollHead = 1.55f;

// Walk bows the chest forwards and back once in 1 s; Look turns the head a quarter to the left and back in 2 s; Reach
// lifts the hips by 0.2 m in 0.5 s; Stand has no key at all and Run is not there.
inline world::Model doll_model(std::uint32_t mesh) {
    world::Model model;
    model.mesh = mesh;
    model.joints.resize(3);
    const std::array<float, 3> heights = {kDollHips, kDollChest, kDollHead};
    for (std::uint32_t j = 0; j < 3; ++j) {
        world::Joint& joint = model.joints[j];
        joint.parent = j == 0 ? world::kNoIndex : j - 1;
        joint.joint_from_mesh = moved_by(glm::vec3(0.0f, -heights[j], 0.0f));
        joint.rest_translation = glm::vec3(0.0f, heights[j] - (j == 0 ? 0.0f : heights[j - 1]), 0.0f);
    }
    model.head_joint = 2;
    const float s = std::sqrt(0.5f);
    world::Channel bow{
        .joint = 1,
        .path = world::ChannelPath::Rotation,
        .is_step = false,
        .times = {0.0f, 0.5f, 1.0f},
        .values = {{0.0f, 0.0f, 0.0f, 1.0f}, {-0.6f, 0.0f, 0.0f, 0.8f}, {0.0f, 0.0f, 0.0f, 1.0f}}};
    world::Channel turn{.joint = 2,
                        .path = world::ChannelPath::Rotation,
                        .is_step = false,
                        .times = {0.0f, 1.0f, 2.0f},
                        .values = {{0.0f, 0.0f, 0.0f, 1.0f}, {0.0f, s, 0.0f, s}, {0.0f, 0.0f, 0.0f, 1.0f}}};
    world::Channel lift{.joint = 0,
                        .path = world::ChannelPath::Translation,
                        .is_step = false,
                        .times = {0.0f, 0.5f},
                        .values = {{0.0f, kDollHips, 0.0f, 0.0f}, {0.0f, kDollHips + 0.2f, 0.0f, 0.0f}}};
    model.clips = {{.name = "stand", .duration = 0.0f, .channels = {}},
                   {.name = "walk", .duration = 1.0f, .channels = {bow}},
                   {.name = "look", .duration = 2.0f, .channels = {turn}},
                   {.name = "reach", .duration = 0.5f, .channels = {lift}}};
    model.clip[0] = 0;
    model.clip[1] = 1;
    model.clip[2] = 2;
    model.clip[4] = 3;
    return model;
}

// Puts a guard who wears the doll at `position`; the part it became.
inline std::uint32_t add_doll(SmallLevel& small, const glm::vec3& position, std::uint32_t material) {
    if (small.level.models.empty()) {
        const std::uint32_t first = small.add_part(doll_mesh(), material);
        small.level.models.push_back(doll_model(small.level.parts[first].mesh));
        small.level.parts.pop_back();
    }
    world::Guard guard;
    guard.position = position;
    guard.model = 0;
    small.level.guards.push_back(guard);
    world::Part part;
    part.mesh = small.level.models[0].mesh;
    part.layers = world::Light;
    part.mover = world::Mover::Guard;
    part.mover_index = static_cast<std::uint32_t>(small.level.guards.size() - 1);
    small.level.parts.push_back(part);
    return static_cast<std::uint32_t>(small.level.parts.size() - 1);
}

}  // namespace gh::test
