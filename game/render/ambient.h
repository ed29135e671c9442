// render/ambient.h - the light that comes off walls: irradiance baked once a level at the points of a grid, apart for
// every lamp group, so that a switch takes its share away in the same frame.
//
// Each point keeps the irradiance on the six sides of a small cube (McTaggart 2004) and how far it sees in every
// direction (Majercik et al. 2019), so that a point behind a wall does not light this side of it.
//
// Cost      baking: 1.8 s of one core for a museum of 7700 points. A look-up: eight points, ~0.15 us.
// Same bits the directions are fixed, every point is baked by itself, sums run in index order.
#pragma once

#include "render/grid.h"
#include "render/probe_weights.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace gh::render {

// Irradiance on faces that look along +x, -x, +y, -y, +z, -z.
struct AmbientCube {
    std::array<glm::vec3, 6> face{};

    [[nodiscard]] glm::vec3 irradiance(const glm::vec3& normal) const;
};

// How far a grid point sees: octahedral map of mean distance and mean squared distance, metres.
struct SightMap {
    std::array<glm::vec2, kSightMoments / 2> moments{};
};
static_assert(sizeof(SightMap) == kSightMoments * sizeof(float));

// Up to eight grid points and their weights, which sum to 1 (or all 0 where no point is valid).
struct GridWeights {
    std::array<std::uint32_t, 8> point{};
    std::array<float, 8> weight{};
};

// What the bake leaves.
struct AmbientBake {
    Grid grid;
    std::vector<SightMap> sights;  // one a grid point; empty: no ambient light
    std::vector<float> validity;   // one a grid point: 0 inside walls
    std::vector<std::vector<AmbientCube>>
        cubes;  // [lamp group; the last: light no switch turns off][grid point]

    [[nodiscard]] GridWeights weights(const glm::vec3& position, const glm::vec3& normal) const;
};

// One frame's light: the sum over the groups that are on.
class AmbientLight {
  public:
    AmbientLight() = default;
    // `group_on` holds one entry a group, besides the last, which is always on.
    AmbientLight(const AmbientBake& bake, const std::vector<std::uint8_t>& group_on);

    // On a surface at `position` that faces `normal`; black where nothing was baked.
    [[nodiscard]] glm::vec3 irradiance(const glm::vec3& position, const glm::vec3& normal) const;
    // The same with the radiance (irradiance / pi) that a rough reflection along `direction` gathers.
    void gather(const glm::vec3& position, const glm::vec3& normal, const glm::vec3& direction,
                glm::vec3& irradiance, glm::vec3& reflected) const;

  private:
    const AmbientBake* bake_ = nullptr;
    std::vector<AmbientCube> cubes_;
};

}  // namespace gh::render
