// render/touching_glass.h - bodies of glass that share a wall: a ray meets both skins at one place, and has to leave one
// body and enter the other at once, whichever it is told of. A ray that starts anew would be past the second.
//
// Cost      one query over a few roundings' length, a microsecond; asked in scenes with Need::NestedGlass only.
// Same bits pure.
#pragma once

#include "render/scene_view.h"
#include "render/shading_point.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace gh::render {

struct Touch {
    std::uint32_t part = 0;
    const world::Material* glass = nullptr;
    bool enters = false;

    friend bool operator==(const Touch&, const Touch&) = default;
};

struct Touches {
    static constexpr std::size_t kMost = 3;
    std::array<Touch, kMost> other{};
    std::size_t count = 0;
    float gap = 0.0f;  // metres: skins that lie this near, along the normal, are at one place
};

// A place on the skin of a body.
struct SkinPoint {
    const rc::SurfacePoint& surface;
    glm::vec3 normal{0.0f};  // unit, of the triangle, either way
    std::uint32_t part = 0;
    const world::Material* glass = nullptr;
};

// The other bodies whose skin lies where a ray of this unit direction meets the skin at `at`, in the same plane.
[[nodiscard]] Touches touches_at(const SceneView& view, const SkinPoint& at, const glm::vec3& direction);
[[nodiscard]] inline Touches touches_at(const SceneView& view, const ShadingPoint& at,
                                        const glm::vec3& direction) {
    return touches_at(view, {at.surface, at.geometric, at.part, at.material}, direction);
}

}  // namespace gh::render
