// render/guide_colors.h - the colours of a guide's surfaces, whose textures are looked up sixteen at a time.
//
// Same bits colours depend on what was asked alone, not on what else was asked with it.
#pragma once

#include "render/guide_point.h"
#include "render/scene_view.h"
#include "render/texture_lookups.h"

#include "raycore/ray.h"

#include <glm/vec3.hpp>

#include <array>

namespace gh::render {

// Where a plain surface's colours belong; both must stay where they are until flush().
struct ColorSums {
    glm::vec3* albedo;
    glm::vec3* clean;        // what is there already stays
    glm::vec3 weight{0.0f};  // of the light that the surface gives by itself
};

class GuideColors {
  public:
    explicit GuideColors(float max_taps) : max_taps_(max_taps) {}
    // Now or by flush() at the latest.
    void add(const SceneView& view, const GuideTriangle& triangle, const rc::Hit& hit, const MetCone& cone,
             const ColorSums& sums);
    void flush();

  private:
    struct Waiting {
        glm::vec3* sum;
        glm::vec3 factor;
    };
    float max_taps_;
    TextureLookUps looks_;
    std::array<Waiting, kPatches> waiting_{};
};

}  // namespace gh::render
