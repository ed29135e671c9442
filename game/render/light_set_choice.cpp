// The part of a light set that says how often each light is picked from a place.
#include "base/det_math.h"
#include "render/environment.h"
#include "render/light_math.h"
#include "render/light_set.h"
#include "render/sane.h"
#include "world/layers.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kListedShare = 0.85f;  // of picks, where the lists know of lamps
constexpr float kLeastFacing = 0.05f;

}  // namespace

float LightSet::sun_weight(std::uint32_t sun, const LightQuery& query) const {
    const world::Lamp& lamp = view_.level.lamps[sun];
    const float cosine = query.normal == glm::vec3(0.0f) ? 1.0f : -glm::dot(query.normal, lamp.direction);
    return mean(sane_light(lamp.intensity)) * std::max(0.0f, cosine);
}

float LightSet::environment_weight() const {
    return environment_ != nullptr ? kPi * environment_->mean_radiance() : 0.0f;
}

float LightSet::far_weight(const LightQuery& query) const {
    float weight = environment_weight();
    for (const std::uint32_t sun : suns_) weight += sun_weight(sun, query);
    return weight;
}

// How often what is far is picked rather than anything near: by what both may give, but neither is ever forgotten.
float LightSet::far_share(const LightQuery& query) const {
    const float far = far_weight(query);
    if (!(far > 0.0f)) return 0.0f;
    const float near = tree_->tree.importance(query);
    if (!(near > 0.0f)) return 1.0f;
    return std::clamp(far / (far + near), 0.1f, 0.9f);
}

float LightSet::environment_density(const LightQuery& query, const glm::vec3& direction) const {
    const float own = environment_weight();
    if (!(own > 0.0f)) return 0.0f;
    return environment_->density(direction) * far_share(query) * own / far_weight(query);
}

float LightSet::listed_weight(std::uint32_t lamp, const LightQuery& query) const {
    const std::uint32_t id = light_of_lamp_[lamp];
    if (id == world::kNoIndex) return 0.0f;
    const Light& light = lights_[id];
    const glm::vec3 centre = light.kind == Kind::Rect   ? light.rect.centre
                             : light.kind == Kind::Ball ? light.ball.centre
                                                        : view_.level.lamps[lamp].position;
    const float extent = light.kind == Kind::Rect
                             ? glm::length(light.rect.half_u) + glm::length(light.rect.half_v)
                             : light.ball.radius;
    const glm::vec3 offset = centre - query.position;
    const float distance2 = glm::dot(offset, offset);
    const float distance = std::sqrt(distance2);
    float share = 1.0f;
    if (query.normal != glm::vec3(0.0f)) {
        const float height = glm::dot(query.normal, offset) + extent;
        if (!(height > 0.0f)) return 0.0f;
        share = distance > 0.0f ? std::clamp(height / distance, kLeastFacing, 1.0f) : 1.0f;
    }
    if (light.kind == Kind::Point) {
        const world::Lamp& own = view_.level.lamps[lamp];
        return share *
               mean(sane_light(lamp_irradiance(own, query.position, direction_to(own, query.position))));
    }
    if (light.kind == Kind::Rect) {
        const float facing = -glm::dot(light.rect.normal, offset);
        if (!light.is_double_sided && !(facing > 0.0f)) return 0.0f;
        share *= distance > 0.0f ? std::clamp(std::abs(facing) / distance, kLeastFacing, 1.0f) : 1.0f;
    }
    return light.power * share / std::max(distance2, extent * extent);
}

LightSet::Listed LightSet::listed_at(const LightQuery& query) const {
    Listed listed;
    std::size_t count = 0, place = 0;
    for (const std::uint32_t lamp : view_.prepared.lamp_lists.at(query.position)) {
        const float own = listed_weight(lamp, query);
        if (place < Listed::kKept) listed.first[place++] = own;
        listed.weight += own;
        count += light_of_lamp_[lamp] != world::kNoIndex;
    }
    if (listed.weight > 0.0f) listed.share = count == lights_.size() ? 1.0f : kListedShare;
    return listed;
}

bool LightSet::is_listed(const Light& light, const LightQuery& query) const {
    if (light.listed_as == world::kNoIndex) return false;
    const auto list = view_.prepared.lamp_lists.at(query.position);
    return std::binary_search(list.begin(), list.end(), light.listed_as);
}

// The lists' lamps by the lists only, all others by the tree only: one way to each, whose probability is known at once.
std::optional<LightTree::Pick> LightSet::pick_near(const LightQuery& query, float u) const {
    const Listed listed = listed_at(query);
    if (u < listed.share) {
        float left = u / listed.share * listed.weight, weight = 0.0f;
        std::uint32_t chosen = world::kNoIndex;
        std::size_t place = 0;
        for (const std::uint32_t lamp : view_.prepared.lamp_lists.at(query.position)) {
            const float own = place < Listed::kKept ? listed.first[place] : listed_weight(lamp, query);
            ++place;
            if (!(own > 0.0f)) continue;
            chosen = light_of_lamp_[lamp];
            weight = own;
            if (left < own) break;
            left -= own;
        }
        return LightTree::Pick{chosen, listed.share * weight / listed.weight};
    }
    const LightTree::Pick pick =
        tree_->tree.pick(query, std::clamp((u - listed.share) / (1.0f - listed.share), 0.0f, 0x1.fffffep-1f));
    if (!(pick.probability > 0.0f) || is_listed(lights_[pick.light], query)) return std::nullopt;
    return LightTree::Pick{pick.light, pick.probability * (1.0f - listed.share)};
}

float LightSet::near_probability(const LightQuery& query, std::uint32_t light) const {
    const Listed listed = listed_at(query);
    if (is_listed(lights_[light], query)) {
        const float own = listed_weight(lights_[light].listed_as, query);
        return own > 0.0f ? listed.share * own / listed.weight : 0.0f;
    }
    return listed.share < 1.0f ? (1.0f - listed.share) * tree_->tree.probability(query, light) : 0.0f;
}

}  // namespace gh::render
