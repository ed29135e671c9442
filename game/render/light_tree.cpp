#include "render/light_tree.h"

#include "base/contracts.h"
#include "base/det_math.h"

#include "raycore/ray.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gh::render {

namespace {

constexpr int kBins = 8;
constexpr int kDeepest = 62;  // turns fit into a trail

float sine_of(float cosine) {
    return std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
}

// Of max(0, a - b), the angles given by cosine and sine, within [0, pi].
struct Angle {
    float cos, sin;
};
Angle difference(const Angle& a, const Angle& b) {
    if (a.cos > b.cos) return {1.0f, 0.0f};
    return {a.cos * b.cos + a.sin * b.sin, a.sin * b.cos - a.cos * b.sin};
}

float area(const glm::vec3& size) {
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

// The narrowest cone around both cones of normals.
void merge_cones(LightBounds& a, const LightBounds& b) {
    if (a.cos_normals <= -1.0f || b.cos_normals <= -1.0f) {
        a.cos_normals = -1.0f;
        return;
    }
    const float between = det::acos(std::clamp(glm::dot(a.axis, b.axis), -1.0f, 1.0f));
    const float half_a = det::acos(std::min(a.cos_normals, 1.0f)),
                half_b = det::acos(std::min(b.cos_normals, 1.0f));
    if (std::min(between + half_b, kPi) <= half_a) return;
    if (std::min(between + half_a, kPi) <= half_b) {
        a.axis = b.axis;
        a.cos_normals = b.cos_normals;
        return;
    }
    const float half = 0.5f * (half_a + half_b + between);
    const glm::vec3 across = b.axis - a.axis * glm::dot(a.axis, b.axis);
    const float length = glm::length(across);
    if (half >= kPi || !(length > 0.0f)) {
        a.cos_normals = -1.0f;
        return;
    }
    const auto [sine, cosine] = det::sin_cos(half - half_a);
    a.axis = glm::normalize(a.axis * cosine + across * (sine / length));
    a.cos_normals = det::cos(half);
}

LightBounds merged(const LightBounds& a, const LightBounds& b) {
    if (!(a.power > 0.0f)) return b;
    if (!(b.power > 0.0f)) return a;
    LightBounds both = a;
    both.min = glm::min(a.min, b.min);
    both.max = glm::max(a.max, b.max);
    both.cos_emission = std::min(a.cos_emission, b.cos_emission);
    both.power = a.power + b.power;
    merge_cones(both, b);
    return both;
}

// How much of the sphere the group shines into, as Conty and Kulla weigh it.
float spread(const LightBounds& bounds) {
    const float normals = det::acos(std::clamp(bounds.cos_normals, -1.0f, 1.0f));
    const float emission = det::acos(std::clamp(bounds.cos_emission, -1.0f, 1.0f));
    const float whole = std::min(normals + emission, kPi);
    const float sine = det::sin(normals);
    return kTwoPi * (1.0f - bounds.cos_normals) +
           0.5f * kPi *
               (2.0f * whole * sine - det::cos(normals - 2.0f * whole) - 2.0f * normals * sine +
                bounds.cos_normals);
}

float cost(const LightBounds& bounds) {
    return bounds.power > 0.0f ? bounds.power * spread(bounds) * area(bounds.max - bounds.min) : 0.0f;
}

}  // namespace

struct LightTree::Item {
    LightBounds bounds;
    glm::vec3 centre{0.0f};
    std::uint32_t light = 0;
};

LightTree::LightTree(std::span<const LightBounds> lights) {
    std::vector<Item> items;
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
        if (lights[i].power > 0.0f) items.push_back({lights[i], 0.5f * (lights[i].min + lights[i].max), i});
    }
    trails_.assign(lights.size(), 0);
    if (items.empty()) return;
    nodes_.reserve(2 * items.size());
    build(items, 0, 0);
}

std::uint32_t LightTree::build(std::span<Item> items, std::uint64_t trail, int depth) {
    const auto id = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    LightBounds all;
    glm::vec3 low = items[0].centre, high = items[0].centre;
    for (const Item& item : items) {
        all = merged(all, item.bounds);
        low = glm::min(low, item.centre);
        high = glm::max(high, item.centre);
    }
    Node node;
    node.centre = 0.5f * (all.min + all.max);
    const glm::vec3 half = 0.5f * (all.max - all.min);
    node.radius2 = glm::dot(half, half);
    node.axis = all.axis;
    node.power = all.power;
    node.cos_normals = all.cos_normals;
    node.sin_normals = sine_of(all.cos_normals);
    node.cos_emission = all.cos_emission;
    if (items.size() == 1) {
        node.is_leaf = true;
        node.next = items[0].light;
        trails_[items[0].light] = trail;
        nodes_[id] = node;
        return id;
    }
    // The cheapest of the planes between bins; half and half where none parts them or the tree gets too deep.
    float best = rc::kInfinity;
    std::size_t best_axis = 0;
    int best_plane = 0;
    const glm::vec3 size = high - low;
    const float widest = std::max({size.x, size.y, size.z});
    for (std::size_t axis = 0; axis < 3 && depth < kDeepest / 2; ++axis) {
        if (!(size[axis] > 0.0f)) continue;
        std::array<LightBounds, kBins> bins{};
        for (const Item& item : items) {
            const int bin =
                std::min(kBins - 1, static_cast<int>((item.centre[axis] - low[axis]) / size[axis] * kBins));
            bins[static_cast<std::size_t>(bin)] = merged(bins[static_cast<std::size_t>(bin)], item.bounds);
        }
        std::array<LightBounds, kBins> behind{};
        behind[kBins - 1] = bins[kBins - 1];
        for (std::size_t b = kBins - 1; b-- > 0;) behind[b] = merged(behind[b + 1], bins[b]);
        LightBounds before;
        for (std::size_t b = 0; b + 1 < kBins; ++b) {
            before = merged(before, bins[b]);
            if (!(before.power > 0.0f) || !(behind[b + 1].power > 0.0f)) continue;
            const float price = (cost(before) + cost(behind[b + 1])) * (widest / size[axis]);
            if (price < best) {
                best = price;
                best_axis = axis;
                best_plane = static_cast<int>(b);
            }
        }
    }
    auto middle = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
    if (best < rc::kInfinity) {
        middle = std::stable_partition(items.begin(), items.end(), [&](const Item& item) {
            const float at = (item.centre[best_axis] - low[best_axis]) / size[best_axis] * kBins;
            return std::min(kBins - 1, static_cast<int>(at)) <= best_plane;
        });
    }
    const auto first = static_cast<std::size_t>(middle - items.begin());
    build(items.subspan(0, first), trail, depth + 1);
    node.next = build(items.subspan(first), trail | (std::uint64_t{1} << depth), depth + 1);
    nodes_[id] = node;
    return id;
}

// Power over squared distance, times the best cosines that any of the group's lights can have on both ends.
float LightTree::importance(const Node& node, const LightQuery& query) {
    const glm::vec3 offset = node.centre - query.position;
    const float distance2 = glm::dot(offset, offset);
    const float kept_off2 = std::max(distance2, node.radius2);
    if (!(kept_off2 > 0.0f)) return node.power;
    // Inside the ball every direction may hold a light.
    if (!(distance2 > node.radius2)) return node.power / kept_off2;
    const float per_distance = 1.0f / std::sqrt(distance2);
    const float sin2_ball = node.radius2 / distance2;
    const Angle ball{std::sqrt(1.0f - sin2_ball), std::sqrt(sin2_ball)};
    float cos_lamp = 1.0f;
    if (node.cos_normals > -1.0f) {
        const float cosine = std::clamp(-glm::dot(node.axis, offset) * per_distance, -1.0f, 1.0f);
        const Angle off = difference({cosine, sine_of(cosine)}, {node.cos_normals, node.sin_normals});
        cos_lamp = difference(off, ball).cos;
        if (!(cos_lamp > node.cos_emission - 1e-4f)) return 0.0f;
        cos_lamp = std::max(cos_lamp, 1e-3f);
    }
    float cos_here = 1.0f;
    if (query.normal != glm::vec3(0.0f)) {
        const float cosine = std::clamp(glm::dot(query.normal, offset) * per_distance, -1.0f, 1.0f);
        cos_here = difference({cosine, sine_of(cosine)}, ball).cos;
        if (!(cos_here > -1e-4f)) return 0.0f;
        cos_here = std::max(cos_here, 1e-3f);
    }
    return node.power * cos_lamp * cos_here / kept_off2;
}

float LightTree::importance(const LightQuery& query) const {
    return nodes_.empty() ? 0.0f : importance(nodes_[0], query);
}

LightTree::Pick LightTree::pick(const LightQuery& query, float u) const {
    if (nodes_.empty() || !(importance(nodes_[0], query) > 0.0f)) return {};
    float probability = 1.0f;
    std::size_t at = 0;
    while (!nodes_[at].is_leaf) {
        const std::size_t second = nodes_[at].next;
        const float a = importance(nodes_[at + 1], query), b = importance(nodes_[second], query);
        if (!(a + b > 0.0f)) return {};
        const float share = a / (a + b);
        if (u < share) {
            u = std::min(u / share, 0x1.fffffep-1f);
            probability *= share;
            at = at + 1;
        } else {
            u = std::clamp((u - share) / (1.0f - share), 0.0f, 0x1.fffffep-1f);
            probability *= 1.0f - share;
            at = second;
        }
    }
    return {nodes_[at].next, probability};
}

float LightTree::probability(const LightQuery& query, std::uint32_t light) const {
    EXPECTS(light < trails_.size());
    if (nodes_.empty() || !(importance(nodes_[0], query) > 0.0f)) return 0.0f;
    float probability = 1.0f;
    std::size_t at = 0;
    for (std::uint64_t trail = trails_[light]; !nodes_[at].is_leaf; trail >>= 1) {
        const std::size_t second = nodes_[at].next;
        const float a = importance(nodes_[at + 1], query), b = importance(nodes_[second], query);
        if (!(a + b > 0.0f)) return 0.0f;
        const float share = a / (a + b);
        probability *= (trail & 1u) != 0 ? 1.0f - share : share;
        at = (trail & 1u) != 0 ? second : at + 1;
    }
    return nodes_[at].next == light ? probability : 0.0f;
}

}  // namespace gh::render
