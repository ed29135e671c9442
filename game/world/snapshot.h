// world/snapshot.h - one tick of the world as it stands, frozen: the same for the renderer, guards, ears and
// feet.
//
// Made      by spatial from (Level, State), once a tick. Instance i of the scene is Level::parts[i].
// Units     metres, world frame unless said otherwise, +y up.
// Threads   immutable; the renderer may draw it while the next tick is computed.
// Same bits a pure function of (Level, State): rewind the State and the same Snapshot answers again.
#pragma once

#include "world/state.h"

#include "raycore/scene.h"

#include <glm/vec3.hpp>

#include <memory>
#include <vector>

namespace gh::world {

// The skinned vertices of one guard in this tick, in its part's frame.
struct PosedMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  // unit; empty where the mesh has none
};

// A mirror pane as it stands now, world frame.
struct MirrorPane {
    glm::vec3 centre{0.0f};
    glm::vec3 half_u{0.0f};
    glm::vec3 half_v{0.0f};
    glm::vec3 normal{0.0f};  // unit, along cross(half_u, half_v): the reflecting side
    glm::vec3 reflectance{0.9f};
    std::uint32_t part = kNoIndex;
};

struct Snapshot {
    std::shared_ptr<const rc::Scene> scene;
    State state;
    std::vector<std::shared_ptr<const PosedMesh>> posed;  // one a part; null where the mesh does not bend
    std::vector<MirrorPane> panes;                        // one a Level::mirrors
    std::vector<glm::vec3> guard_eyes;                    // one a guard: where it looks from
    std::vector<glm::vec3> guard_looks;                   // unit: where it looks to
};

}  // namespace gh::world
