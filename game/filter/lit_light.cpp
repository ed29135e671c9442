#include "filter/lit_light.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <optional>

namespace gh::filter {

namespace {

constexpr int kRings = 3;
constexpr glm::ivec2 kWays[] = {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};

glm::vec3 own_light(const GuidedFrame& frame, glm::ivec2 lit) {
    const std::size_t at = frame.index_of_lit(lit.x, lit.y);
    const glm::vec3& radiance = frame.radiance.pixels[frame.radiance.index(lit.x, lit.y)];
    return (radiance - frame.guide.clean[at]) / frame.guide.albedo[at];
}

bool is_outshone(const Guide& guide, std::size_t at) {
    return !guide.outshone.empty() && guide.outshone[at] != 0;
}

// Nothing where a lit pixel is none, is outshone itself, or shows another surface.
std::optional<glm::vec3> light_beside(const GuidedFrame& frame, std::size_t here, glm::ivec2 there,
                                      float most_off) {
    const Guide& guide = frame.guide;
    if (there.x < 0 || there.y < 0 || there.x >= frame.radiance.width || there.y >= frame.radiance.height)
        return std::nullopt;
    const std::size_t at = frame.index_of_lit(there.x, there.y);
    if (is_outshone(guide, at) || guide.part[at] != guide.part[here]) return std::nullopt;
    const float off = glm::dot(guide.position[at] - guide.position[here], guide.geometric[here]);
    const glm::vec3 light = own_light(frame, there);
    if (!(std::abs(off) <= most_off && std::isfinite(light.x + light.y + light.z))) return std::nullopt;
    return light;
}

}  // namespace

glm::vec3 light_of_lit(const GuidedFrame& frame, glm::ivec2 lit, float reach) {
    const std::size_t here = frame.index_of_lit(lit.x, lit.y);
    const glm::vec3 own = own_light(frame, lit);
    if (!is_outshone(frame.guide, here)) return own;
    const float most_off = reach * glm::distance(frame.guide.lens.eye, frame.guide.position[here]);
    for (int ring = 1; ring <= kRings; ++ring) {
        glm::vec3 sum(0.0f);
        float count = 0.0f;
        for (const glm::ivec2 way : kWays) {
            const auto light = light_beside(frame, here, lit + ring * way, most_off);
            if (!light) continue;
            sum += *light;
            count += 1.0f;
        }
        if (count > 0.0f) return sum / count;
    }
    return glm::max(own, glm::vec3(0.0f));
}

}  // namespace gh::filter
