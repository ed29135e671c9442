#include "render/light_tree.h"

#include "base/contracts.h"
#include "render/light_angles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

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
