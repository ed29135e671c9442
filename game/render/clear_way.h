// render/clear_way.h - what a path's shadow ray meets behind holes and clear glass.
//
// Same bits pure.
#pragma once

#include "render/scene_view.h"

#include "raycore/ray.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace gh::render {

struct ClearWay {
    glm::vec3 share{1.0f};  // of the light that what was passed lets through
    rc::Hit end;            // the first thing that is not passed, or a miss
};

struct WayRules {
    bool passes_solid_glass =
        false;  // unbent; otherwise only holes and thin sheets, which do not bend light, are passed
    std::uint32_t target = 0xFFFFFFFFu;       // a part that ends the way whatever it is made of
    const world::Material* inside = nullptr;  // the glass the ray starts in
    glm::vec3 start{0.0f};                    // where
};

// A smooth enough sheet for light to go straight through it.
[[nodiscard]] bool is_smooth_glass(const world::Material& material);

// `first` is what the ray itself hits.
[[nodiscard]] ClearWay follow(const SceneView& view, const rc::Ray& ray, const rc::Hit& first,
                              const WayRules& rules);

}  // namespace gh::render
