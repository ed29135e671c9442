#include "spatial/skinning.h"

#include "base/contracts.h"
#include "base/vectors.h"

#include <cmath>

namespace gh::spatial {
namespace {

// Weighted sum of the four matrices that own a vertex, in their written order.
glm::mat4x3 blend(std::span<const glm::mat4x3> skin, const glm::u16vec4& joints, const glm::vec4& weights) {
    glm::mat4x3 sum(0.0f);
    for (glm::length_t k = 0; k < 4; ++k) {
        if (weights[k] == 0.0f) continue;
        const glm::mat4x3& owner = skin[joints[k]];
        for (glm::length_t column = 0; column < 4; ++column) sum[column] += owner[column] * weights[k];
    }
    return sum;
}

// What carries normals is the matrix of cofactors, up to a length: exact for any invertible blend.
glm::vec3 normal_through(const glm::mat4x3& m, const glm::vec3& n) {
    const glm::vec3 carried =
        (cross_of(m[1], m[2]) * n.x + cross_of(m[2], m[0]) * n.y) + cross_of(m[0], m[1]) * n.z;
    const float squared = dot_of(carried, carried);
    return squared > 0.0f ? carried / std::sqrt(squared) : n;
}

}  // namespace

void skin_mesh(const world::Mesh& mesh, std::span<const glm::mat4x3> skin, world::PosedMesh& out) {
    EXPECTS(mesh.joints.size() == mesh.positions.size() && mesh.weights.size() == mesh.positions.size());
    out.positions.resize(mesh.positions.size());
    out.normals.resize(mesh.normals.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::mat4x3 m = blend(skin, mesh.joints[i], mesh.weights[i]);
        const glm::vec3& p = mesh.positions[i];
        out.positions[i] = ((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3];
        if (!out.normals.empty()) out.normals[i] = normal_through(m, mesh.normals[i]);
    }
}

}  // namespace gh::spatial
