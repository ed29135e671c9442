// render/ambient_gleams.h - the lamp shades (gleams.h) that a grid point of the baked light looks into on purpose.
//
// The light that a lamp leaves on the inside of its shade, and the glow of the shade, is looked for by rays of its own; the
// rays all around leave it out. One of those would find it by chance once in fifty times, and then light its point, and no
// other, as brightly as fifty. The two share what there is: nothing is counted twice, nothing is missed.
//
// Same bits pure.
#pragma once

#include "render/gleams.h"
#include "render/scene_view.h"
#include "render/solid_angle.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace gh::render {

// The inside of one lamp's shade as a grid point sees it.
struct AimedAt {
    BallShape ball;
    std::uint32_t lamp = world::kNoIndex;
    glm::vec3 axis{0.0f};        // unit, towards its middle
    float one_minus_cos = 0.0f;  // of the cone that holds it

    [[nodiscard]] bool holds(const glm::vec3& position) const {
        const glm::vec3 off = position - ball.centre;
        return glm::dot(off, off) <= ball.radius * ball.radius;
    }
};
struct AimedAtAll {
    std::array<AimedAt, GleamGuide::kMost> gleam{};
    std::size_t count = 0;

    [[nodiscard]] std::span<const AimedAt> all() const { return std::span(gleam).first(count); }
};

// The gleams near the point, all of them: which lamps are on is not known yet. Those it is in, or all but, are left to the
// rays all around.
[[nodiscard]] AimedAtAll gleams_around(const SceneView& view, const glm::vec3& eye);

// Whether what the lamp does there is looked for on purpose.
[[nodiscard]] bool is_left_out(std::span<const AimedAt> gleams, std::uint32_t lamp,
                               const glm::vec3& position);
[[nodiscard]] bool is_within_any(std::span<const AimedAt> gleams, const glm::vec3& position);

}  // namespace gh::render
