#include "render/clear_way.h"

#include "render/fresnel.h"
#include "render/path_ray.h"
#include "render/sane.h"
#include "render/shading_point.h"
#include "render/touching_glass.h"
#include "render/transmittance.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr int kCrossingsOfAWay = 32;  // leaves and panes one behind the other; then it is dark

bool is_black(const glm::vec3& c) {
    return !(std::max({c.x, c.y, c.z}) > 0.0f);
}

// A way straight through bodies of glass: what it is in, and since where.
struct Straight {
    MediumStack media;
    const world::Material* began;  // what the way starts in, which no skin was met of
    glm::vec3 since{0.0f};

    void cross(std::uint32_t part, const world::Material& glass, bool enters) {
        if (!enters && &glass == began) {
            media.leave(world::kNoIndex, glass);
            began = nullptr;
        } else {
            media.cross(part, glass, enters);
        }
    }
    [[nodiscard]] glm::vec3 left_at(const glm::vec3& place) const {
        const world::Material* glass = media.top();
        return glass != nullptr ? absorbed(*glass, glm::distance(since, place)) : glm::vec3(1.0f);
    }
};

struct Passage {
    glm::vec3 share{1.0f};
    float gap = 0.0f;  // metres behind the skin in which other skins lie, that are passed as well
};

// Through the skin of a body, and those that touch it there: light notices a border only where what is there changes, as
// paths do (path_ray.h).
Passage pass_skin(const SceneView& view, std::uint32_t part, const Clearness& skin,
                  const glm::vec3& direction, Straight& way) {
    const bool enters = glm::dot(direction, skin.outward) < 0.0f;
    const MediumStack before = way.media;
    Passage passage{.share = way.left_at(skin.surface.position)};
    way.cross(part, *skin.material, enters);
    if (view.prepared.needs.has(Need::NestedGlass)) {
        const Touches touches =
            touches_at(view, {skin.surface, skin.outward, part, skin.material}, direction);
        for (std::size_t i = 0; i < touches.count; ++i)
            way.cross(touches.other[i].part, *touches.other[i].glass, touches.other[i].enters);
        if (touches.count > 0) passage.gap = 2.0f * touches.gap;
    }
    way.since = skin.surface.position;
    const Sides sides = sides_of(before, way.media, *skin.material, enters);
    if (!sides.is_border()) return passage;
    // Straight on there is no total reflection: both ways as from the thinner side.
    const float eta = sides.eta() >= 1.0f ? sides.eta() : 1.0f / sides.eta();
    const float mirrored = fresnel(std::abs(glm::dot(direction, skin.outward)), eta).reflectance;
    const glm::vec3 glass = sane_colour(skin.glass_share);
    passage.share *= glm::max(sane_colour(skin.share) - glass, glm::vec3(0.0f)) + glass * (1.0f - mirrored);
    return passage;
}

// Of a sheet or a hole, or of glass that nothing passes.
glm::vec3 share_of(const Clearness& clear, const glm::vec3& direction, bool passes_glass) {
    const glm::vec3 share = sane_colour(clear.share);
    if (!(clear.glass > 0.0f)) return share;
    const float cosine = std::abs(glm::dot(direction, clear.outward));
    const float mirrored = fresnel(cosine, sane(clear.material->ior, 1.0f, 5.0f)).reflectance;
    const float lost = passes_glass ? thin_sheet_reflectance(mirrored) : 1.0f;
    // Holes let everything through, glass its share; both together only in holed glass.
    const glm::vec3 glass = sane_colour(clear.glass_share);
    return glm::max(share - glass, glm::vec3(0.0f)) + glass * (1.0f - lost);
}

}  // namespace

bool is_smooth_glass(const world::Material& material) {
    constexpr float kSmoothRoughness = 0.01f;  // as bsdf.cpp has it, squared
    return !(material.roughness >= kSmoothRoughness);
}

ClearWay follow(const SceneView& view, const rc::Ray& whole, const rc::Hit& first, const WayRules& rules) {
    ClearWay way;
    way.end = first;
    rc::Ray ray = whole;
    const glm::vec3 direction = glm::normalize(whole.direction);
    Straight straight{.media = {}, .began = rules.inside, .since = rules.start};
    if (rules.inside != nullptr) straight.media.enter(world::kNoIndex, *rules.inside);
    for (int i = 0; !way.end.is_miss(); ++i) {
        const std::uint32_t part = way.end.instance;
        if (part == rules.target || !view.prepared.parts[part].is_clear) break;
        const Clearness clear = clearness(view, way.end);
        const bool is_solid = view.prepared.parts[part].is_solid_glass;
        const bool passes_glass =
            clear.glass > 0.0f && is_smooth_glass(*clear.material) && (!is_solid || rules.passes_solid_glass);
        Passage passage;
        if (passes_glass && is_solid) {
            passage = pass_skin(view, part, clear, direction, straight);
        } else {
            passage.share = share_of(clear, direction, passes_glass);
        }
        way.share *= passage.share;
        if (i == kCrossingsOfAWay) way.share = glm::vec3(0.0f);
        if (is_black(way.share)) break;
        ray = onwards(ray, clear.surface);
        if (passage.gap > 0.0f) {
            const float least = 1e-2f * glm::length(ray.direction);
            ray.t_min = passage.gap / std::max(std::abs(glm::dot(ray.direction, clear.outward)), least);
        }
        way.end = {};
        if (const auto next = rc::closest_hit(*view.snapshot.scene, ray, world::Light)) way.end = *next;
    }
    if (straight.media.top() != nullptr && !is_black(way.share)) {
        const glm::vec3 end = way.end.is_miss() ? ray.origin + ray.direction * ray.t_max
                                                : view.snapshot.scene->surface(way.end).position;
        if (glm::distance(straight.since, end) < rc::kInfinity) way.share *= straight.left_at(end);
    }
    return way;
}

}  // namespace gh::render
