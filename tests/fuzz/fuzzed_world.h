// fuzz/fuzzed_world.h - any bytes at all become meshes, instances, rays and bodies: small whole numbers as often as
// arbitrary bit patterns, rays at vertices as often as anywhere, so that edges, ties and degeneracies are common.
//
// Coordinates between 1e15 and 2^60 are brought down, so that no instance is dropped for reaching too far, which the oracle
// does not know about; transforms are either well conditioned or exactly singular for the same reason.
#pragma once

#include "support/shapes.h"

#include "raycore/bodies.h"
#include "raycore/query.h"

#include <cstdint>
#include <span>
#include <vector>

namespace fuzz {

struct Placed {
    std::size_t mesh;
    glm::mat4x3 world_from_mesh;
    rc::LayerMask layers;
};

struct World {
    std::vector<test::Mesh> meshes;
    std::vector<std::vector<glm::vec3>> moved;  // other positions for each mesh, to refit to
    std::vector<Placed> placed;
    std::vector<rc::Ray> rays;  // good ones only where contracts would trap
    std::vector<rc::SphereCast> balls;
    rc::LayerMask layers = rc::kAllLayers;
};

[[nodiscard]] World world_from(std::span<const std::uint8_t> bytes);

}  // namespace fuzz
