// render/emitters.h - what shines in a level, found once: the triangles of every part that are emissive, and in what way
// a path should look for them.
//
//   Rect       the triangles are one flat rectangle: directions are picked evenly over its solid angle
//   Bulb       they fill most of a ball: directions are picked in the ball's cone, whatever its true shape
//   Triangles  anything else, one by one
//
// All three find the light of the triangles themselves, never of a stand-in.
// Same bits a function of the level and its first tick.
#pragma once

#include "world/level.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace gh::render {

enum class EmitterKind : std::uint8_t { Rect, Bulb, Triangles };

struct Emitter {
    std::uint32_t part = 0;
    EmitterKind kind = EmitterKind::Triangles;
    bool is_double_sided = false;           // some of it is
    std::vector<std::uint32_t> primitives;  // rising
    // In the part's own frame. Rect: middle and half edges, front along cross(half_u, half_v). Bulb: middle, radius.
    glm::vec3 centre{0.0f};
    glm::vec3 half_u{0.0f}, half_v{0.0f};
    float radius = 0.0f;
};

// One a part that has emissive triangles which are neither holed nor of zero area, by rising part.
[[nodiscard]] std::vector<Emitter> find_emitters(const world::Level& level);

}  // namespace gh::render
