#include "spatial/wardrobe.h"

#include "spatial/skinning.h"

#include <utility>

namespace gh::spatial {
namespace {

// A build drops triangles without area, a refit never brings them back: so that both leave out the same ones in every
// pose, those that have none in the first pose are made pointlike in all.
std::vector<glm::uvec3> lasting_triangles(const world::Mesh& mesh, std::span<const glm::vec3> positions) {
    std::vector<glm::uvec3> triangles = mesh.triangles;
    for (glm::uvec3& triangle : triangles) {
        const rc::MeshView alone{.positions = positions, .triangles = {&triangle, 1}};
        if (rc::check_mesh(alone).dropped() != 0) triangle = glm::uvec3(0);
    }
    return triangles;
}

}  // namespace

Wardrobe::Wardrobe(const world::Model& model, const world::Mesh& mesh) : model_(model), mesh_(mesh) {
    auto first = std::make_unique<PosedBody>();
    first->skin.resize(model.joints.size());
    pose_body(model, first->key, first->skin);
    skin_mesh(mesh, first->skin, first->mesh);
    triangles_ = lasting_triangles(mesh, first->mesh.positions);
    first->blas = rc::build_blas({.positions = first->mesh.positions, .triangles = triangles_});
    first_ = std::move(first);
}

std::unique_ptr<PosedBody> Wardrobe::take() {
    {
        const std::lock_guard lock(mutex_);
        if (!idle_.empty()) {
            std::unique_ptr<PosedBody> body = std::move(idle_.back());
            idle_.pop_back();
            return body;
        }
        ++bodies_made_;
    }
    auto body = std::make_unique<PosedBody>(*first_);
    body->blas = std::make_shared<rc::Blas>(*first_->blas);
    return body;
}

void Wardrobe::pose(const PoseKey& key, PosedBody& body) const {
    body.key = key;
    pose_body(model_, key, body.skin);
    skin_mesh(mesh_, body.skin, body.mesh);
    rc::refit_blas(*body.blas, body.mesh.positions);
    if (!(body.blas->refit_degradation() > kWorstDegradation)) return;

    std::shared_ptr<rc::Blas> fresh =
        rc::build_blas({.positions = body.mesh.positions, .triangles = triangles_});
    // A pose that flattens a triangle would make the fresh tree leave it out for good: then the old one serves on.
    if (fresh->report().kept() == first_->blas->report().kept()) body.blas = std::move(fresh);
}

std::shared_ptr<const PosedBody> Wardrobe::publish(std::unique_ptr<PosedBody> body) {
    return std::shared_ptr<PosedBody>(body.release(), [home = weak_from_this()](PosedBody* returned) {
        std::unique_ptr<PosedBody> owned(returned);
        if (const std::shared_ptr<Wardrobe> wardrobe = home.lock()) wardrobe->bring_home(std::move(owned));
    });
}

std::size_t Wardrobe::bodies_made() const {
    const std::lock_guard lock(mutex_);
    return bodies_made_;
}

void Wardrobe::bring_home(std::unique_ptr<PosedBody> body) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(body));
}

}  // namespace gh::spatial
