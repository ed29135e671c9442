#include "sim/doors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "raycore/query.h"

#include "sim/geometry.h"
#include "sim/guards.h"
#include "sim/noises.h"
#include "sim/player.h"
#include "spatial/transforms.h"
#include "world/layers.h"

namespace gh::sim {

namespace {

constexpr float kDoorOpenDb = 52.0f;  // of oak
constexpr float kDoorCloseDb = 56.0f;
constexpr float kGlassDb = -9.0f;  // a vitrine's lid is lifted, not slammed
constexpr float kMetalDb = 5.0f;
constexpr float kMirrorDb = 44.0f;
constexpr float kTurnTicks = 30.0f;   // a mirror's step

float angle_wanted(const world::Door& door, const world::DoorState& state) {
    return state.wants_open != 0 ? door.open_angle : 0.0f;
}

bool touches_somebody(const world::Level& level, const DoorBodies& bodies, const world::State& state,
                      std::size_t door) {
    if (bodies.overlaps(level, state, door, body_of(state.player))) return true;
    if (state.doors[door].held_until_tick != 0) return false;  // the guard's own hand is on it
    for (std::size_t g = 0; g < level.guards.size(); ++g) {
        if (bodies.overlaps(level, state, door, body_of(state.guards[g]))) return true;
    }
    return false;
}

float loudness_by(world::Surface surface) {
    if (surface == world::Surface::Glass || surface == world::Surface::Pane) return kGlassDb;
    return surface == world::Surface::Metal ? kMetalDb : 0.0f;
}

void close_when_due(const world::Level& level, world::State& state, std::size_t door) {
    world::DoorState& it = state.doors[door];
    if (it.held_until_tick == 0 || state.tick < it.held_until_tick) return;
    it.held_until_tick = 0;
    if (it.wants_open != 0) toggle_door(level, state, door, kSomeGuard);
}

}  // namespace

DoorBodies::DoorBodies(const world::Level& level) {
    for (std::uint32_t d = 0; d < level.doors.size(); ++d) {
        rc::SceneBuilder builder;
        for (const world::Part& part : level.parts) {
            const bool is_leaf = part.mover == world::Mover::Door && part.mover_index == d;
            if (!is_leaf || (part.layers & world::Solid) == 0) continue;
            const world::Mesh& mesh = level.meshes[part.mesh];
            builder.add({.blas = rc::build_blas({mesh.positions, mesh.triangles}),
                         .world_from_instance = part.mover_from_part});
        }
        closed_.push_back(builder.commit());
    }
}

bool DoorBodies::overlaps(const world::Level& level, const world::State& state, std::size_t door,
                          const Body& body) const {
    const glm::mat4x3 door_from_world = spatial::inverse_of(spatial::world_from_door(level, state, door));
    const rc::Segment axis = axis_of(body);
    const rc::Segment axis_door{spatial::point_through(door_from_world, axis.from),
                                spatial::point_through(door_from_world, axis.to)};
    std::array<rc::CastHit, 1> contact;
    constexpr float kMargin = 0.005f;  // metres: rounding of another frame must not let a leaf touch
    return rc::capsule_overlaps(*closed_[door], axis_door, body.radius + kMargin, rc::kAllLayers, contact) != 0;
}

world::Surface door_surface(const world::Level& level, std::size_t door) {
    std::array<float, world::kSurfaceCount> area{};
    for (std::uint32_t p = 0; p < level.parts.size(); ++p) {
        const world::Part& part = level.parts[p];
        if (part.mover != world::Mover::Door || part.mover_index != door) continue;
        const world::Mesh& mesh = level.meshes[part.mesh];
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            const glm::uvec3& corner = mesh.triangles[i];
            const glm::vec3 a = mesh.positions[corner.x];
            const glm::vec3 across = glm::cross(mesh.positions[corner.y] - a, mesh.positions[corner.z] - a);
            area[static_cast<std::size_t>(surface_at(level, p, i))] += length_of(across);
        }
    }
    const auto most = std::max_element(area.begin(), area.end());
    return static_cast<world::Surface>(most - area.begin());
}

void toggle_door(const world::Level& level, world::State& state, std::size_t door, std::uint8_t by_guard) {
    world::DoorState& it = state.doors[door];
    it.wants_open = it.wants_open != 0 ? 0 : 1;
    const world::Surface surface = door_surface(level, door);
    emit(state, {.position = spatial::door_handle(level, state, door),
                 .loudness_db = (it.wants_open != 0 ? kDoorOpenDb : kDoorCloseDb) + loudness_by(surface),
                 .kind = it.wants_open != 0 ? world::NoiseKind::DoorOpen : world::NoiseKind::DoorClose,
                 .surface = static_cast<std::uint8_t>(surface),
                 .by_guard = by_guard});
}

void hold_door_open(const world::Level& level, world::State& state, std::size_t door, std::uint32_t until_tick) {
    world::DoorState& it = state.doors[door];
    const bool stands_open = it.wants_open != 0 && it.held_until_tick == 0;
    if (stands_open) return;  // somebody else left it open: it stays
    if (it.wants_open == 0) toggle_door(level, state, door, kSomeGuard);
    it.held_until_tick = until_tick;
}

float openness(const world::Level& level, const world::State& state, std::size_t door) {
    return state.doors[door].angle / level.doors[door].open_angle;
}

void move_doors(const world::Level& level, const DoorBodies& bodies, world::State& state) {
    for (std::size_t d = 0; d < level.doors.size(); ++d) {
        close_when_due(level, state, d);
        const world::Door& door = level.doors[d];
        world::DoorState& it = state.doors[d];
        const float wanted = angle_wanted(door, it);
        if (it.angle == wanted) continue;
        const float angle = it.angle;
        it.angle = towards(angle, wanted, std::abs(door.open_angle) / door.open_ticks);
        if (touches_somebody(level, bodies, state, d)) it.angle = angle;
    }
}

void move_mirrors(const world::Level& level, world::State& state) {
    for (std::size_t m = 0; m < level.mirrors.size(); ++m) {
        world::MirrorState& it = state.mirrors[m];
        it.angle = towards(it.angle, it.target, std::abs(level.mirrors[m].turn_step) / kTurnTicks);
    }
}

void turn_mirror(const world::Level& level, world::State& state, std::size_t mirror) {
    state.mirrors[mirror].target += level.mirrors[mirror].turn_step;
    emit(state, {.position = level.mirrors[mirror].pivot,
                 .loudness_db = kMirrorDb,
                 .kind = world::NoiseKind::MirrorTurn,
                 .surface = static_cast<std::uint8_t>(world::Surface::Metal)});
}

}  // namespace gh::sim
