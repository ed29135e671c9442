#include "comparators/soup.h"

#include <glm/common.hpp>

#include <algorithm>
#include <span>

namespace comparators {

Bounds bounds_of(const Corners& p) {
    const glm::vec3 low = glm::min(p[0], glm::min(p[1], p[2])), high = glm::max(p[0], glm::max(p[1], p[2]));
    return {glm::dvec3(low), glm::dvec3(high)};
}

double reach_of(const glm::vec3& p) {
    return static_cast<double>(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
}

double ray_pad(double origin_reach, double soup_reach) {
    return 0x1p-21 * (origin_reach + soup_reach) + 0x1p-100;
}

Soup::Soup(const rc::MeshView& mesh) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        if (rc::check_mesh({mesh.positions, std::span(&t, 1)}).kept() == 0) continue;
        corners.push_back({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
        primitive.push_back(static_cast<std::uint32_t>(i));
        const Bounds b = bounds_of(corners.back());
        bounds.min = corners.size() == 1 ? b.min : glm::min(bounds.min, b.min);
        bounds.max = corners.size() == 1 ? b.max : glm::max(bounds.max, b.max);
        for (const glm::vec3& p : corners.back()) reach = std::max(reach, reach_of(p));
    }
}

}  // namespace comparators
