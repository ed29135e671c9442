// render/transmittance.h - what of a lamp's light gets through glass, tinted panes and cut-out leaves on its way.
//
// Straight on: glass takes its share by Fresnel and its colour by Beer's law, but does not bend shadow rays.
// Same bits pure.
#pragma once

#include "render/scene_view.h"

#include "raycore/counters.h"
#include "raycore/ray.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace gh::render {

// The ray that goes on behind a surface to where `ray` would end.
[[nodiscard]] rc::Ray onwards(const rc::Ray& ray, const rc::SurfacePoint& point);

// Along the whole ray; 0 as soon as something opaque is met.
[[nodiscard]] glm::vec3 transmittance(const SceneView& view, const rc::Ray& ray);

// Beer's law over `length` metres of a glass.
[[nodiscard]] glm::vec3 absorbed(const world::Material& glass, float length);

// The same for many: one batch finds what opaque parts block, one what meets glass at all; few must look through it.
// Keeps its memory for the next call.
class ShadowBatch {
  public:
    void answer(const SceneView& view, std::span<const rc::Ray> rays, std::span<glm::vec3> shares);
    [[nodiscard]] std::size_t looked_through() const {
        return looked_through_;
    }  // rays of the last call sent twice

  private:
    void look_through_what_is_blocked(const SceneView& view, std::span<const rc::Ray> rays,
                                      std::span<glm::vec3> shares);
    void look_through_what_is_left(const SceneView& view, std::span<const rc::Ray> rays,
                                   std::span<glm::vec3> shares);

    std::vector<std::uint8_t> is_blocked_;
    std::vector<std::uint8_t> meets_glass_;
    std::vector<rc::Ray> left_;
    std::vector<std::size_t> left_index_;
    std::size_t looked_through_ = 0;
};

}  // namespace gh::render
