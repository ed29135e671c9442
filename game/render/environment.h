// render/environment.h - light from all around as a picture of all directions (longitude across, latitude down, +y at the
// top, +x in the middle and -z left of it, as Blender has it), and directions picked in proportion to how bright it is.
//
// Memory    16 bytes a texel. Cost: made in O(texels); a look-up 0.1 us, picking 0.2 us.
// Threads   immutable once made.
// Same bits base/det_math; sums in index order.
// Bad input texels that are NaN or negative are black, infinite ones merely bright; an empty picture is black.
#pragma once

#include "base/image.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace gh::render {

class Environment {
  public:
    explicit Environment(Image picture);

    // Of unit directions: radiance, constant within a texel.
    [[nodiscard]] glm::vec3 radiance(const glm::vec3& direction) const;

    struct Pick {
        glm::vec3 direction{0.0f, 1.0f, 0.0f};
        glm::vec3 radiance{0.0f};
        float density = 0.0f;  // 1/sr; 0: all is black
    };
    [[nodiscard]] Pick pick(const glm::vec2& u) const;
    [[nodiscard]] float density(const glm::vec3& direction) const;

    // Averaged over all directions, mean of the colours.
    [[nodiscard]] float mean_radiance() const { return mean_; }

  private:
    struct Texel {
        std::size_t x, y;
    };
    [[nodiscard]] Texel texel(const glm::vec3& direction) const;
    [[nodiscard]] float texel_density(std::size_t x, std::size_t y) const;

    Image picture_;
    std::vector<float> columns_;      // sums of weights to the left of and including each texel, row by row
    std::vector<float> rows_;         // sums over rows up to and including each
    std::vector<float> solid_angle_;  // of a texel, by row
    float mean_ = 0.0f;
};

}  // namespace gh::render
