// render/last_picture.h - the picture before, to be looked up by what it showed: most of what a polished floor mirrors now
// was in sight then, with all the light on it.
//
// Same bits pure.
#pragma once

#include "base/image.h"
#include "render/film.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>

namespace gh::render {

// Borrows both, and is of use as long as they stay what they are.
class LastPicture {
  public:
    // `guide` is that of a picture of `size`; `radiance` shows the same in as many pixels or more.
    LastPicture(const Image& radiance, const GuidePlanes& guide, glm::ivec2 size);

    // What was seen, straight on, of the point of a part that was at `position` then; nothing if that was out of sight.
    [[nodiscard]] std::optional<glm::vec3> seen(const glm::vec3& position, std::uint32_t part) const;

  private:
    [[nodiscard]] glm::vec3 radiance_at(const glm::vec2& point) const;

    const Image& radiance_;
    const GuidePlanes& guide_;
    glm::ivec2 size_;
    glm::vec2 per_pixel_;  // pixels of `radiance`
    glm::mat3 picture_from_world_;
};

}  // namespace gh::render
