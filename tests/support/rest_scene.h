// support/rest_scene.h - the scene of a SmallLevel with every part where its mover_from_part puts it.
#pragma once

#include "world/level.h"

#include "raycore/scene.h"

#include <memory>

namespace gh::test {

// A builder, so that a test can turn a door or take a thing away and commit again.
inline rc::SceneBuilder rest_builder(const world::Level& level) {
    rc::SceneBuilder builder;
    for (const world::Part& part : level.parts) {
        const world::Mesh& mesh = level.meshes[part.mesh];
        builder.add({.blas = rc::build_blas({.positions = mesh.positions, .triangles = mesh.triangles}),
                     .world_from_instance = part.mover_from_part,
                     .layers = part.layers});
    }
    return builder;
}

inline std::shared_ptr<const rc::Scene> rest_scene(const world::Level& level) {
    return rest_builder(level).commit();
}

}  // namespace gh::test
