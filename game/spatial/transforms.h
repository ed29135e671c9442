// spatial/transforms.h - where everything stands in a State: the glTF node's rest pose and what has moved it since.
//
// Chain     world_from_part = world_from_mover(state) * mover_from_part(level).
// Units     metres, radians, right-handed, +y up.
// Same bits det_math only.
// Bad input a checked Level and a State of it; indices in range (contract).
#pragma once

#include "world/level.h"
#include "world/snapshot.h"
#include "world/state.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>

namespace gh::spatial {

// a_from_c = chain(a_from_b, b_from_c), all affine.
[[nodiscard]] glm::mat4x3 chain(const glm::mat4x3& a_from_b, const glm::mat4x3& b_from_c);
[[nodiscard]] glm::vec3 point_through(const glm::mat4x3& a_from_b, const glm::vec3& p_b);
[[nodiscard]] glm::vec3 vector_through(const glm::mat4x3& a_from_b, const glm::vec3& v_b);
// The way back. Precondition: not singular.
[[nodiscard]] glm::mat4x3 inverse_of(const glm::mat4x3& a_from_b);

// Turned by a unit quaternion, then moved. Counter-clockwise about `axis` (unit) seen from its tip.
[[nodiscard]] glm::mat4x3 rigid(const glm::quat& rotation, const glm::vec3& translation);
[[nodiscard]] glm::quat rotation_about(const glm::vec3& axis, float radians);

[[nodiscard]] glm::mat4x3 world_from_door(const world::Level& level, const world::State& state,
                                          std::size_t door);
[[nodiscard]] glm::mat4x3 world_from_mirror(const world::Level& level, const world::State& state,
                                            std::size_t mirror);
[[nodiscard]] glm::mat4x3 world_from_guard(const world::State& state, std::size_t guard);
[[nodiscard]] glm::mat4x3 world_from_stone(const world::State& state, std::size_t stone);

// Of part `part` as it stands now. A stone that is not there keeps a transform; its layers are empty.
[[nodiscard]] glm::mat4x3 world_from_part(const world::Level& level, const world::State& state,
                                          std::size_t part);

// Who meets the part now: nobody meets a stone that is not there, a lens that is taken, or a
// mirror in a pocket.
[[nodiscard]] rc::LayerMask layers_of_part(const world::Level& level, const world::State& state,
                                           std::size_t part);

// Where a door's handle is now: what a hand reaches for, and where a prompt goes.
[[nodiscard]] glm::vec3 door_handle(const world::Level& level, const world::State& state, std::size_t door);

[[nodiscard]] world::MirrorPane mirror_pane(const world::Level& level, const world::State& state,
                                            std::size_t mirror);

}  // namespace gh::spatial
