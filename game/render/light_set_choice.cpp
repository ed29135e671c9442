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

constexpr float kListedShare = 0.94f;  // of picks, where the lists know of lamps

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

// Of the first kTogether lamps of a list.
void LightSet::weigh_listed(const LightQuery& query, std::span<const std::uint32_t> list,
                            LampWeights::Weights& weights) const {
    const auto lamps = list.first(std::min(list.size(), LampWeights::kTogether));
    lamp_weights_.at(query, lamps, weights);
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        if (is_beam_[lamps[i]] == 0 || !(weights[i] > 0.0f)) continue;
        const world::Lamp& lamp = view_.level.lamps[lamps[i]];
        weights[i] *=
            mean(sane_light(lamp_irradiance(lamp, query.position, direction_to(lamp, query.position))));
    }
}

float LightSet::listed_weight(std::uint32_t lamp, const LightQuery& query) const {
    LampWeights::Weights weights;
    weigh_listed(query, {&lamp, 1}, weights);
    return weights[0];
}

LightSet::Listed LightSet::listed_at(const LightQuery& query) const {
    const auto list = view_.prepared.lamp_lists.at(query.position);
    Listed listed;
    LampWeights::Weights further;
    for (std::size_t first = 0; first < list.size(); first += LampWeights::kTogether) {
        LampWeights::Weights& weights = first == 0 ? listed.first : further;
        weigh_listed(query, list.subspan(first), weights);
        const std::size_t count = std::min(list.size() - first, LampWeights::kTogether);
        for (std::size_t i = 0; i < count; ++i) listed.weight += weights[i];
    }
    if (!(listed.weight > 0.0f)) return listed;
    const auto count =
        list.size() < lights_.size() ? 0 : std::count_if(list.begin(), list.end(), [&](std::uint32_t lamp) {
            return light_of_lamp_[lamp] != world::kNoIndex;
        });
    listed.share = static_cast<std::size_t>(count) == lights_.size() ? 1.0f : kListedShare;
    return listed;
}

bool LightSet::is_listed(const Light& light, const LightQuery& query) const {
    if (light.listed_as == world::kNoIndex) return false;
    const auto list = view_.prepared.lamp_lists.at(query.position);
    return std::binary_search(list.begin(), list.end(), light.listed_as);
}

LightTree::Pick LightSet::pick_listed(const LightQuery& query, const Listed& listed, float u) const {
    const auto list = view_.prepared.lamp_lists.at(query.position);
    float left = u * listed.weight, weight = 0.0f;
    std::uint32_t chosen = world::kNoIndex;
    LampWeights::Weights weights = listed.first;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::size_t place = i % LampWeights::kTogether;
        if (i > 0 && place == 0) weigh_listed(query, list.subspan(i), weights);
        if (!(weights[place] > 0.0f)) continue;
        chosen = list[i];
        weight = weights[place];
        if (left < weight) break;
        left -= weight;
    }
    return {light_of_lamp_[chosen], listed.share * weight / listed.weight};
}

// The lists' lamps by the lists only, all others by the tree only: one way to each, whose probability is known at once.
std::optional<LightTree::Pick> LightSet::pick_near(const LightQuery& query, float u) const {
    const Listed listed = listed_at(query);
    if (u < listed.share) return pick_listed(query, listed, u / listed.share);
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
