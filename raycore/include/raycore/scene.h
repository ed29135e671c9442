// raycore/scene.h - instances of meshes under a top-level tree, frozen for everybody to ask.
//
// Cost      commit O(instances log instances), every tick.
// Threads   a SceneBuilder belongs to one thread; a committed Scene never changes and is read by any number.
// Same bits the Scene depends on the instances in their order only.
// Bad input an instance with a singular or non-finite transform (stretched by more than 1e7:1, or reaching beyond 2^60
//           counts as such), or without triangles, is kept under its id but never met; dropped_instances() counts them.
#pragma once

#include "raycore/blas.h"
#include "raycore/ray.h"

#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace rc {

struct Instance {
    std::shared_ptr<const Blas> blas;
    glm::mat4x3 world_from_instance{
        1.0f};  // affine: columns x, y, z, translation; mirrored and sheared are fine
    LayerMask layers = kAllLayers;
};

class Scene {
  public:
    struct Data;  // private to raycore

    explicit Scene(std::unique_ptr<Data> data);
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene();

    [[nodiscard]] std::size_t instance_count() const;
    [[nodiscard]] std::size_t dropped_instances() const;
    [[nodiscard]] const Instance& instance(std::uint32_t id) const;
    [[nodiscard]] Box bounds() const;  // world frame, of what can be met, padded; min > max when nothing can
    [[nodiscard]] const Data& data() const { return *data_; }

    // Corners of a triangle in its instance's own frame, as given to the builder (or to the last refit).
    [[nodiscard]] std::array<glm::vec3, 3> triangle(std::uint32_t instance, std::uint32_t primitive) const;

    // Where a hit of this scene lies, in the world frame. Precondition: not a miss. A mirroring transform turns the order
    // of the corners, and with it the normal: outwards becomes inwards.
    [[nodiscard]] SurfacePoint surface(const Hit& hit) const;

  private:
    std::unique_ptr<Data> data_;
};

class SceneBuilder {
  public:
    // Ids count up from 0 in the order of add; they name instances in hits and break ties.
    std::uint32_t add(Instance instance);
    void set_transform(std::uint32_t id, const glm::mat4x3& world_from_instance);
    void set_blas(std::uint32_t id, std::shared_ptr<const Blas> blas);
    void set_layers(std::uint32_t id, LayerMask layers);
    [[nodiscard]] std::size_t size() const { return instances_.size(); }

    // Freezes the instances as they stand. The builder can go on to change and commit again.
    [[nodiscard]] std::shared_ptr<const Scene> commit() const;

  private:
    std::vector<Instance> instances_;
};

}  // namespace rc
