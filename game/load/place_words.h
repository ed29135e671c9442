// load/place_words.h - how a sentence about a level says where something is.
#pragma once

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include <string>

namespace gh::load {

// To the centimetre: "(1.20, 0.00, -3.45)".
[[nodiscard]] inline std::string at(const glm::vec3& p) {
    return fmt::format("({:.2f}, {:.2f}, {:.2f})", p.x, p.y, p.z);
}

}  // namespace gh::load
