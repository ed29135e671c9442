#include "spatial/transforms.h"

#include "base/contracts.h"
#include "base/det_math.h"
#include "base/vectors.h"
#include "spatial/hand_mirror.h"

#include <cmath>

namespace gh::spatial {
namespace {

// Hamilton product, written out: the order of the sums is part of the answer.
glm::quat after(const glm::quat& a, const glm::quat& b) {
    return {
        ((a.w * b.w - a.x * b.x) - a.y * b.y) - a.z * b.z, ((a.w * b.x + a.x * b.w) + a.y * b.z) - a.z * b.y,
        ((a.w * b.y - a.x * b.z) + a.y * b.w) + a.z * b.x, ((a.w * b.z + a.x * b.y) - a.y * b.x) + a.z * b.w};
}

}  // namespace

glm::vec3 vector_through(const glm::mat4x3& a_from_b, const glm::vec3& v_b) {
    return (a_from_b[0] * v_b.x + a_from_b[1] * v_b.y) + a_from_b[2] * v_b.z;
}

glm::vec3 point_through(const glm::mat4x3& a_from_b, const glm::vec3& p_b) {
    return vector_through(a_from_b, p_b) + a_from_b[3];
}

glm::mat4x3 chain(const glm::mat4x3& a_from_b, const glm::mat4x3& b_from_c) {
    return {vector_through(a_from_b, b_from_c[0]), vector_through(a_from_b, b_from_c[1]),
            vector_through(a_from_b, b_from_c[2]), point_through(a_from_b, b_from_c[3])};
}

glm::mat4x3 inverse_of(const glm::mat4x3& a_from_b) {
    const glm::vec3 x = cross_of(a_from_b[1], a_from_b[2]);
    const glm::vec3 y = cross_of(a_from_b[2], a_from_b[0]);
    const glm::vec3 z = cross_of(a_from_b[0], a_from_b[1]);
    const float determinant = dot_of(a_from_b[0], x);
    EXPECTS(determinant != 0.0f);
    // Rows of the inverse are these cross products over the determinant; columns are wanted.
    const float scale = 1.0f / determinant;
    const glm::mat4x3 linear(glm::vec3(x.x, y.x, z.x) * scale, glm::vec3(x.y, y.y, z.y) * scale,
                             glm::vec3(x.z, y.z, z.z) * scale, glm::vec3(0.0f));
    return {linear[0], linear[1], linear[2], -vector_through(linear, a_from_b[3])};
}

glm::mat4x3 rigid(const glm::quat& rotation, const glm::vec3& translation) {
    const float x = rotation.x, y = rotation.y, z = rotation.z, w = rotation.w;
    return {glm::vec3(1.0f - 2.0f * (y * y + z * z), 2.0f * (x * y + w * z), 2.0f * (x * z - w * y)),
            glm::vec3(2.0f * (x * y - w * z), 1.0f - 2.0f * (x * x + z * z), 2.0f * (y * z + w * x)),
            glm::vec3(2.0f * (x * z + w * y), 2.0f * (y * z - w * x), 1.0f - 2.0f * (x * x + y * y)),
            translation};
}

glm::quat rotation_about(const glm::vec3& axis, float radians) {
    const auto [sine, cosine] = det::sin_cos(radians * 0.5f);
    return {cosine, axis.x * sine, axis.y * sine, axis.z * sine};
}

glm::mat4x3 world_from_door(const world::Level& level, const world::State& state, std::size_t door) {
    EXPECTS(door < level.doors.size());
    const world::Door& rest = level.doors[door];
    return rigid(after(rest.world_from_rest, rotation_about(rest.axis, state.doors[door].angle)), rest.hinge);
}

glm::mat4x3 world_from_mirror(const world::Level& level, const world::State& state, std::size_t mirror) {
    EXPECTS(mirror < level.mirrors.size());
    if (mirror == level.hand_mirror && is_mirror_held(state.player)) {
        return world_from_held_mirror(level, state.player);
    }
    const world::Mirror& rest = level.mirrors[mirror];
    const glm::quat turned =
        after(rest.world_from_rest, rotation_about(rest.axis, state.mirrors[mirror].angle));
    return rigid(turned, rest.pivot);
}

glm::mat4x3 world_from_guard(const world::State& state, std::size_t guard) {
    EXPECTS(guard < state.guards.size());
    return rigid(rotation_about(kUp, state.guards[guard].yaw), state.guards[guard].position);
}

glm::mat4x3 world_from_stone(const world::State& state, std::size_t stone) {
    EXPECTS(stone < state.stones.size());
    return rigid(glm::quat(1.0f, 0.0f, 0.0f, 0.0f), state.stones[stone].position);
}

glm::mat4x3 world_from_part(const world::Level& level, const world::State& state, std::size_t part) {
    EXPECTS(part < level.parts.size());
    const world::Part& p = level.parts[part];
    switch (p.mover) {
        case world::Mover::None:
            return p.mover_from_part;
        case world::Mover::Door:
            return chain(world_from_door(level, state, p.mover_index), p.mover_from_part);
        case world::Mover::Mirror:
            return chain(world_from_mirror(level, state, p.mover_index), p.mover_from_part);
        case world::Mover::Guard:
            return chain(world_from_guard(state, p.mover_index), p.mover_from_part);
        case world::Mover::Stone:
            return chain(world_from_stone(state, p.mover_index), p.mover_from_part);
        case world::Mover::Lens:
            return chain(level.lenses[p.mover_index].world_from_lens, p.mover_from_part);
    }
    return p.mover_from_part;
}

rc::LayerMask layers_of_part(const world::Level& level, const world::State& state, std::size_t part) {
    EXPECTS(part < level.parts.size());
    const world::Part& p = level.parts[part];
    if (p.mover == world::Mover::Stone && state.stones[p.mover_index].is_present == 0) return 0;
    const bool is_in_a_pocket = p.mover == world::Mover::Mirror && p.mover_index == level.hand_mirror &&
                                state.player.has_mirror != 0 && !is_mirror_held(state.player);
    if (is_in_a_pocket) return 0;
    if (p.mover == world::Mover::Lens && state.lens_taken[p.mover_index] != 0) return 0;
    return p.layers;
}

glm::vec3 door_handle(const world::Level& level, const world::State& state, std::size_t door) {
    const world::Door& rest = level.doors[door];
    const glm::mat4x3 world_from_shut = rigid(rest.world_from_rest, rest.hinge);
    const glm::vec3 in_door = point_through(inverse_of(world_from_shut), rest.handle);
    return point_through(world_from_door(level, state, door), in_door);
}

world::MirrorPane mirror_pane(const world::Level& level, const world::State& state, std::size_t mirror) {
    const world::Mirror& rest = level.mirrors[mirror];
    const glm::mat4x3 world_from_mirror_now = world_from_mirror(level, state, mirror);
    world::MirrorPane pane;
    pane.centre = point_through(world_from_mirror_now, rest.pane_centre);
    pane.half_u = vector_through(world_from_mirror_now, rest.pane_half_u);
    pane.half_v = vector_through(world_from_mirror_now, rest.pane_half_v);
    const glm::vec3 across = cross_of(pane.half_u, pane.half_v);
    const float length = std::sqrt(dot_of(across, across));
    pane.normal = length > 0.0f ? across / length : kUp;
    pane.reflectance = rest.reflectance;
    pane.part = rest.pane_part;
    return pane;
}

}  // namespace gh::spatial
