// support/brute_force.h - the oracle: the specification of a ray meeting a triangle, applied to every triangle of a
// scene with no tree at all. Slow, short, and written apart from the kernels.
#pragma once

#include "support/shapes.h"

#include "raycore/query.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace test {

// Meshes, where they stand, and the scene committed from them.
class TestScene {
  public:
    explicit TestScene(rc::BuildQuality quality = rc::BuildQuality::Default) : quality_(quality) {}

    // Instances are numbered in the order of add.
    void add(const Mesh& mesh, const glm::mat4x3& world_from_mesh = glm::mat4x3(1.0f),
             rc::LayerMask layers = rc::kAllLayers);
    void add_instance_of_last(const glm::mat4x3& world_from_mesh, rc::LayerMask layers = rc::kAllLayers);
    void commit();

    [[nodiscard]] const rc::Scene& scene() const { return *scene_; }

    // Every hit on the ray in order: by t, then instance, then primitive.
    [[nodiscard]] std::vector<rc::Hit> all_hits(const rc::Ray& ray,
                                                rc::LayerMask layers = rc::kAllLayers) const;
    [[nodiscard]] std::optional<rc::Hit> closest(const rc::Ray& ray,
                                                 rc::LayerMask layers = rc::kAllLayers) const;

  private:
    struct Placed {
        std::size_t mesh;
        rc::Instance instance;
    };
    rc::BuildQuality quality_;
    std::vector<Mesh> meshes_;
    std::vector<Placed> placed_;
    std::shared_ptr<const rc::Scene> scene_;
};

// The specification itself, in a triangle's own frame; nothing when missed. Ids are left to the caller.
[[nodiscard]] std::optional<rc::Hit> meet_triangle(const glm::vec3& origin, const glm::vec3& direction,
                                                   const glm::vec3 (&corners)[3]);

[[nodiscard]] bool same_bits(const rc::Hit& a, const rc::Hit& b);

}  // namespace test
