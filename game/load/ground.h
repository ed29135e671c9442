// load/ground.h - what guards walk on: everything solid that does not move, as one set of world triangles,
// and the places from which walking has to be possible.
//
// Left out  doors (guards open them), guards, stones and lenses. Mirrors stand where they rest.
// Same bits the hash depends on the level's geometry and places only.
#pragma once

#include "base/result.h"
#include "world/level.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace gh::load {

struct Ground {
    std::vector<glm::vec3> vertices;    // world, metres
    std::vector<glm::ivec3> triangles;  // facing as drawn, mirrored parts turned round
    std::vector<glm::vec3> places;      // spawn, guards, patrol points

    [[nodiscard]] std::uint64_t hash() const;
};

// Refused when instances multiply to more than can be baked.
[[nodiscard]] Result<Ground> collect_ground(const world::Level& level);

}  // namespace gh::load
