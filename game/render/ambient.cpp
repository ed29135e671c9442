#include "render/ambient.h"

#include "base/contracts.h"
#include "render/light_math.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

// Looked up a little before the surface: the very wall one stands on must not count as what hides a point.
constexpr float kNormalBias = 0.2f;    // of a cell
constexpr float kHiddenShare = 1e-3f;  // of its weight, that a point keeps though it is hidden

}  // namespace

glm::vec3 AmbientCube::irradiance(const glm::vec3& normal) const {
    const glm::vec3 share = normal * normal;
    return face[normal.x < 0.0f ? 1 : 0] * share.x + face[normal.y < 0.0f ? 3 : 2] * share.y +
           face[normal.z < 0.0f ? 5 : 4] * share.z;
}

GridWeights AmbientBake::weights(const glm::vec3& position, const glm::vec3& normal) const {
    GridWeights result;
    const float bias = kNormalBias * std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z});
    const glm::vec3 from = position + normal * bias;
    const glm::ivec3 cell = grid.cell_at(from);
    const glm::vec3 along = glm::clamp((from - grid.point_position(cell)) / grid.spacing, 0.0f, 1.0f);

    std::array<float, 8> plain{};
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
        const auto point = static_cast<std::uint32_t>(grid.point_index(cell + step));
        const glm::vec3 nearness = glm::mix(glm::vec3(1.0f) - along, along, glm::vec3(step));
        result.point[corner] = point;
        plain[corner] = nearness.x * nearness.y * nearness.z * validity[point];
    }
    const glm::vec3 low = grid.point_position(cell);
    weigh_probes({.moments = &sights[0].moments[0].x,
                  .point = result.point.data(),
                  .plain = plain.data(),
                  .from = {from.x, from.y, from.z},
                  .low = {low.x, low.y, low.z},
                  .spacing = {grid.spacing.x, grid.spacing.y, grid.spacing.z},
                  .normal = {normal.x, normal.y, normal.z}},
                 result.weight.data());
    // Where every point is hidden a rough answer is better than none; it comes in by degrees, without a line on the wall.
    float total = 0.0f;
    for (std::size_t i = 0; i < 8; ++i) {
        result.weight[i] += kHiddenShare * plain[i];
        total += result.weight[i];
    }
    for (float& weight : result.weight) weight = total > 0.0f ? weight / total : 0.0f;
    return result;
}

AmbientLight::AmbientLight(const AmbientBake& bake, const std::vector<std::uint8_t>& group_on) {
    if (bake.sights.empty()) return;
    EXPECTS(group_on.size() + 1 == bake.cubes.size());
    bake_ = &bake;
    cubes_ = bake.cubes.back();
    for (std::size_t group = 0; group < group_on.size(); ++group) {
        if (group_on[group] == 0) continue;
        const std::vector<AmbientCube>& share = bake.cubes[group];
        for (std::size_t i = 0; i < share.size(); ++i) {
            for (std::size_t side = 0; side < 6; ++side) cubes_[i].face[side] += share[i].face[side];
        }
    }
}

glm::vec3 AmbientLight::irradiance(const glm::vec3& position, const glm::vec3& normal) const {
    glm::vec3 irradiance(0.0f), reflected(0.0f);
    gather(position, normal, normal, irradiance, reflected);
    return irradiance;
}

void AmbientLight::gather(const glm::vec3& position, const glm::vec3& normal, const glm::vec3& direction,
                          glm::vec3& irradiance, glm::vec3& reflected) const {
    irradiance = reflected = glm::vec3(0.0f);
    if (bake_ == nullptr) return;
    const GridWeights weights = bake_->weights(position, normal);
    AmbientCube blend;
    for (std::size_t i = 0; i < 8; ++i) {
        if (!(weights.weight[i] > 0.0f)) continue;
        const AmbientCube& cube = cubes_[weights.point[i]];
        for (std::size_t side = 0; side < 6; ++side) blend.face[side] += cube.face[side] * weights.weight[i];
    }
    irradiance = blend.irradiance(normal);
    reflected = blend.irradiance(direction) * kPerPi;
}

}  // namespace gh::render
