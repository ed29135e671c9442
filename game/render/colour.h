// render/colour.h - what is asked of a colour as a whole.
#pragma once

#include <glm/vec3.hpp>

#include <algorithm>

namespace gh::render {

// Of its three channels.
[[nodiscard]] inline float brightest(const glm::vec3& c) {
    return std::max({c.x, c.y, c.z});
}

}  // namespace gh::render
