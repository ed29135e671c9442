// render/ambient_looks.h - what one grid point of the baked light sees: rays all around it, and more of them into the lamp
// shades nearby (gleams.h), whose insides the others would find by chance once in fifty times.
//
// Cost      two rays a direction; 64 B a direction and point are kept for the bounces.
// Threads   any number of points at a time: each writes its own slots.
// Same bits directions are fixed, every point is by itself.
#pragma once

#include "render/ambient_bake.h"

#include <glm/vec3.hpp>

#include <array>
#include <bitset>
#include <cstddef>
#include <vector>

namespace gh::render {

inline constexpr std::size_t kMostBakedGroups = world::kMaxLampGroups + 1;

// Where one ray from a grid point ended, and what is needed to light it again for the next bounce.
struct Patch {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
    glm::vec3 albedo{0.0f};  // 0: nothing comes back from here
};

using PerSide = std::array<float, 6>;

// A bake on its way.
struct Bake {
    const SceneView& view;
    BakeSettings settings;
    std::vector<glm::vec3> directions;
    PerSide per_side;
    std::size_t always;  // index of the group that no switch turns off
    AmbientBake result;
    std::vector<Patch> patches;                            // [point][ray]
    std::vector<std::vector<AmbientCube>> first;           // light that came off one wall: [group][point]
    std::vector<std::bitset<kMostBakedGroups>> is_lit_by;  // [point]
};

// Evenly over the sphere (a spherical Fibonacci lattice), in an order in which the first few are even, too.
[[nodiscard]] std::vector<glm::vec3> even_directions(int count);

// pi over the sum of the cosines towards each side: uniform light comes out exactly.
[[nodiscard]] PerSide light_per_side(const std::vector<glm::vec3>& directions);

// One cosine-weighted share of a cube's sides.
void add_light(AmbientCube& cube, const glm::vec3& direction, const glm::vec3& radiance,
               const PerSide& per_side);

// Fills the point's validity, sight, patches and `first`. A point within a wall looks from just outside of it, where that
// is near: else a passage that is narrower than a cell may have no point at all (Majercik et al. 2021).
void look_round(Bake& bake, std::size_t point);

}  // namespace gh::render
