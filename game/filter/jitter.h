// filter/jitter.h - where in their pixels the pictures of a row are taken, so that together they show more than one.
//
// Same bits pure.
#pragma once

#include <glm/vec2.hpp>

#include <cstdint>

namespace gh::filter {

// Frame `i` of an even sequence of jitters (Halton 2, 3), in [-0.5, 0.5).
[[nodiscard]] glm::vec2 halton_jitter(std::uint32_t i);
// The pixel of every step x step that is lit in frame `i`: all of them in turn, far ones after each other. Step 1 to 4.
[[nodiscard]] glm::ivec2 lit_offset(std::uint32_t i, int step);
// The jitter of a small picture whose pixels look where those of the guide at `offset` do, with a jitter of its own.
[[nodiscard]] glm::vec2 small_jitter(const glm::vec2& jitter, const glm::ivec2& offset, int step);

}  // namespace gh::filter
