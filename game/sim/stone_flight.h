// sim/stone_flight.h - one tick of a thrown stone: fly, bounce, roll, rest.
//
// Between bounces a stone flies the exact parabola; the time it meets a surface is solved on that parabola, and
// the rest of the tick is flown from there, so heights after bounces are e^2 h, whatever the tick (dropping the
// remaining time loses 6 % at the first bounce and 37 % at the fourth).
//
// Cost      1-2 sphere casts in free flight, about 3 a bounce, 1 at rest.
// Threads   pure. Same bits: a function of (Level, Scene, StoneState).
// Never     through a surface, at any speed: each change of place is a cast that met nothing. Energy never grows.
//           Guards are met as they stand now; one who walks into a stone that lies still walks over it.
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "sim/motion.h"
#include "world/level.h"
#include "world/state.h"
#include "world/surface.h"

#include "raycore/scene.h"

namespace gh::sim {

// Metres kept between a stone and what it lies on. A bounce lower than that is the end of bouncing.
inline constexpr float kStoneSkin = 2e-4f;

struct Impact {
    bool is_there = false;
    glm::vec3 position{0.0f};  // of the stone
    float speed = 0.0f;        // m/s into the surface
    world::Surface surface = world::Surface::Marble;
    std::uint32_t guard = world::kNoIndex;  // who felt it on the way, if anybody
};

// Share of the speed into a surface that comes back.
[[nodiscard]] float restitution(world::Surface surface);

// Carries a stone that is present through one tick; the hardest impact on the way. `guards` in their own order.
Impact fly(const world::Level& level, const rc::Scene& scene, world::StoneState& stone,
           std::span<const Body> guards = {});

}  // namespace gh::sim
