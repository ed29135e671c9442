#include "sim/planes.h"

#include "sim/geometry.h"

namespace gh::sim {

glm::vec3 along_planes(std::span<const glm::vec3> planes, const glm::vec3& v) {
    const auto is_clear = [planes](const glm::vec3& w) {
        for (const glm::vec3& plane : planes) {
            if (glm::dot(w, plane) < -1e-5f * length_of(w)) return false;
        }
        return true;
    };
    if (is_clear(v)) return v;
    for (const glm::vec3& plane : planes) {
        const glm::vec3 clipped = v - plane * std::min(glm::dot(v, plane), 0.0f);
        if (is_clear(clipped)) return clipped;
    }
    for (std::size_t i = 0; i < planes.size(); ++i) {
        for (std::size_t j = i + 1; j < planes.size(); ++j) {
            const glm::vec3 edge = glm::cross(planes[i], planes[j]);
            const float square = glm::dot(edge, edge);
            if (!(square > 1e-8f)) continue;
            const glm::vec3 clipped = edge * (glm::dot(edge, v) / square);
            if (is_clear(clipped)) return clipped;
        }
    }
    return glm::vec3(0.0f);
}

}  // namespace gh::sim
