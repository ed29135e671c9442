#include "render/touching_glass.h"

#include "world/layers.h"

#include "raycore/query.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kErrors = 8.0f;  // bounds on rounding that two skins may lie apart: twice where rays start
constexpr float kSameNormal = 0.9999f;  // cosine between their normals
constexpr float kLeastCosine = 0.01f;

}  // namespace

Touches touches_at(const SceneView& view, const SkinPoint& at, const glm::vec3& direction) {
    Touches touches;
    touches.gap = kErrors * glm::dot(glm::abs(at.normal), at.surface.position_error);
    const float cosine = std::max(std::abs(glm::dot(direction, at.normal)), kLeastCosine);
    const glm::vec3 reach = direction * (touches.gap / cosine);
    std::array<rc::Hit, 2 * Touches::kMost + 2> hits;
    const std::size_t met = rc::crossings(*view.snapshot.scene, at.surface.position - reach,
                                          at.surface.position + reach, world::Light, hits);
    for (std::size_t i = 0; i < met && touches.count < Touches::kMost; ++i) {
        const std::uint32_t part = hits[i].instance;
        if (!view.prepared.parts[part].is_solid_glass) continue;
        const Clearness clear = clearness(view, hits[i]);
        if (part == at.part && clear.material == at.glass) continue;
        if (!(clear.glass > 0.0f) || std::abs(glm::dot(clear.outward, at.normal)) < kSameNormal) continue;
        const Touch touch{part, clear.material, glm::dot(direction, clear.outward) < 0.0f};
        // On an edge a skin is met twice.
        const auto known = touches.other.begin() + static_cast<std::ptrdiff_t>(touches.count);
        if (std::find(touches.other.begin(), known, touch) == known) touches.other[touches.count++] = touch;
    }
    return touches;
}

}  // namespace gh::render
