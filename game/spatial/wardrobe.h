// spatial/wardrobe.h - bodies in poses: made anew or, when nobody looks at one any more, taken again.
//
// A PosedBody is written once, between take() and publish(), and never while anybody holds it. The last holder's
// letting go brings it home, on whatever thread that is; so a game that keeps three Snapshots alive keeps four bodies
// a guard and allocates nothing.
// Threads   take() and publish() by one thread each body; letting go on any. pose() of different bodies side by side.
// Same bits whichever body is taken and whatever its tree has been through, it answers alike.
#pragma once

#include "spatial/pose.h"
#include "world/level.h"
#include "world/snapshot.h"

#include "raycore/blas.h"

#include <glm/mat4x3.hpp>

#include <memory>
#include <mutex>
#include <vector>

namespace gh::spatial {

// Refits above this are rebuilt: how much more than in the pose it was built in a random ray costs. Walking and reaching
// bring a guard to 1.4, where a new tree would cost nearly as much; at 2 rays take 1.2 to 1.3 times as long as in a new
// one, and building pays from 60,000 rays a tick on (tools/bench/README.md).
inline constexpr float kWorstDegradation = 2.0f;

struct PosedBody {
    PoseKey key;
    std::vector<glm::mat4x3> skin;
    world::PosedMesh mesh;
    std::shared_ptr<rc::Blas> blas;
};

class Wardrobe : public std::enable_shared_from_this<Wardrobe> {
  public:
    // For the bodies of one model; `model` and `mesh` must outlive it.
    Wardrobe(const world::Model& model, const world::Mesh& mesh);

    [[nodiscard]] std::unique_ptr<PosedBody> take();

    // Gives the body the shape of `key`.
    void pose(const PoseKey& key, PosedBody& body) const;

    [[nodiscard]] std::shared_ptr<const PosedBody> publish(std::unique_ptr<PosedBody> body);

    [[nodiscard]] std::size_t bodies_made() const;

  private:
    void bring_home(std::unique_ptr<PosedBody> body);

    const world::Model& model_;
    const world::Mesh& mesh_;
    std::vector<glm::uvec3>
        triangles_;  // the mesh's, with those that have no area at rest reduced to a point
    std::unique_ptr<const PosedBody> first_;
    mutable std::mutex mutex_;
    std::vector<std::unique_ptr<PosedBody>> idle_;
    std::size_t bodies_made_ = 0;
};

}  // namespace gh::spatial
