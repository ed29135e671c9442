#include "render/ambient.h"

#include "base/contracts.h"
#include "render/octahedron.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

// Looked up a little before the surface: the very wall one stands on must not count as what hides a point.
constexpr float kNormalBias = 0.2f;  // of a cell

constexpr float kUnlikely = 0.2f;

// Chebyshev's bound on the share of directions nearby that reach as far as `distance`.
float share_that_reaches(const glm::vec2& moments, float distance) {
    if (!(distance > moments.x)) return 1.0f;
    const float variance = std::max(moments.y - moments.x * moments.x, 1e-4f * moments.y);
    const float beyond = distance - moments.x;
    // A bound is never quite 0; what is this unlikely is behind a wall.
    const float share =
        std::max(0.0f, variance / (variance + beyond * beyond) - kUnlikely) / (1.0f - kUnlikely);
    return share * share * share;
}

glm::vec2 sight_towards(const SightMap& sight, const glm::vec3& direction) {
    const OctahedralTexels texels = octahedral_texels(direction, kSightSide);
    glm::vec2 sum(0.0f);
    for (std::size_t i = 0; i < 4; ++i) sum += sight.moments[texels.index[i]] * texels.weight[i];
    return sum;
}

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
    float total = 0.0f, plain_total = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::ivec3 at = cell + step;
        const auto i = static_cast<std::size_t>(corner);
        const auto point = static_cast<std::uint32_t>(grid.point_index(at));
        result.point[i] = point;

        const glm::vec3 nearness = glm::mix(glm::vec3(1.0f) - along, along, glm::vec3(step));
        const SightMap& sight = sights[point];
        plain[i] = nearness.x * nearness.y * nearness.z * sight.validity;
        plain_total += plain[i];
        if (!(plain[i] > 0.0f)) continue;

        const glm::vec3 offset = from - grid.point_position(at);
        const float distance = glm::length(offset);
        const glm::vec3 direction = distance > 0.0f ? offset / distance : normal;
        const float before = 0.5f - 0.5f * glm::dot(direction, normal);  // 0: the point is behind the surface
        const float facing = before * before + 0.05f;
        const float weight =
            plain[i] * facing * share_that_reaches(sight_towards(sight, direction), distance);
        result.weight[i] = weight;
        total += weight;
    }
    // Where every point is hidden a rough answer is better than none.
    const bool is_hidden = !(total > 1e-4f * plain_total);
    const float sum = is_hidden ? plain_total : total;
    for (std::size_t i = 0; i < 8; ++i) {
        const float weight = is_hidden ? plain[i] : result.weight[i];
        result.weight[i] = sum > 0.0f ? weight / sum : 0.0f;
    }
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
    constexpr float kPerPi = 0.318309886f;
    irradiance = blend.irradiance(normal);
    reflected = blend.irradiance(direction) * kPerPi;
}

}  // namespace gh::render
