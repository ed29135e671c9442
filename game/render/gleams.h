// render/gleams.h - what a lamp lights so close by that it shines almost like the lamp: the inside of its shade. A path
// that scatters off a wall finds such a place by chance once in hundreds of times, and then brings hundreds of times
// its light: a picture full of fireflies. So some paths are sent there on purpose, which takes nothing from what they
// estimate, since the density with which they are sent is known.
//
// Found once a level: rays from each small lamp say how much of its light comes back off what is how near; the ball
// that holds the most reflected power for its radius becomes a gleam. Rays between the cells of a grid and the lit
// places in the ball then say what of it each cell gets.
//
// Cost      finding: 256 rays a lamp and 32 a cell, 70 ms of core time for a museum's 29. A guide: at most kMost cones,
//           16 ns on average over the museum, where most places see none. Memory: 8 bytes a cell and gleam that it sees.
// Threads   immutable once found.
// Same bits a function of the level and its first tick; every lamp and cell by itself.
#pragma once

#include "base/jobs.h"
#include "render/directions.h"
#include "render/grid.h"
#include "render/solid_angle.h"
#include "world/level.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gh::render {

struct SceneView;

struct Gleam {
    BallShape ball;                        // around the places that are lit
    std::uint32_t part = world::kNoIndex;  // whose light it is: an emissive part
    std::uint32_t lamp = world::kNoIndex;  // or a lamp without one
};

// What of a gleam reaches a cell.
struct SeenGleam {
    std::uint32_t gleam = 0;
    float weight = 0.0f;  // irradiance across its direction, mean over the cell, W/m2
};

struct Gleams {
    Grid grid;
    std::vector<Gleam> gleams;
    std::vector<std::uint32_t> begin;  // cell c sees seen[begin[c]] .. seen[begin[c + 1]]; empty: no gleams
    std::vector<SeenGleam> seen;

    [[nodiscard]] std::span<const SeenGleam> at(const glm::vec3& position) const;
};

// `view.prepared` needs textures, traits and emitters only.
[[nodiscard]] Gleams find_gleams(const SceneView& view, const Grid& grid, const Jobs& jobs);

// Directions from one place to the gleams that are seen there: one is picked by its weight, a direction evenly in its
// cone.
class GleamGuide {
  public:
    static constexpr std::size_t kMost = 4;  // that a cell keeps

    GleamGuide() = default;
    // `is_on`: one a gleam. A `normal` of 0 takes light from all sides.
    GleamGuide(const Gleams& gleams, std::span<const std::uint8_t> is_on, const glm::vec3& position,
               const glm::vec3& normal);

    [[nodiscard]] bool empty() const { return count_ == 0; }
    // Precondition: not empty.
    [[nodiscard]] glm::vec3 pick(float u_gleam, const glm::vec2& u) const;
    [[nodiscard]] float density(const glm::vec3& direction) const;

  private:
    struct Cone {
        glm::vec3 axis{0.0f};
        float one_minus_cos = 0.0f;
        float probability = 0.0f;
    };
    std::array<Cone, kMost> cones_{};
    std::size_t count_ = 0;
};

}  // namespace gh::render
