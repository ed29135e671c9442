// sim/motion.h - how an upright body moves through the solid world: collide and slide, steps, slopes, floors.
//
// Cost      3-15 casts a call. Threads: pure, any number.
// Same bits a function of (scene, arguments).
// Never     through a surface, at any speed: every change of place is a cast that met nothing on its way.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "raycore/query.h"
#include "raycore/scene.h"

namespace gh::sim {

inline constexpr float kGravity = 9.81f;        // m/s2
inline constexpr float kPadding = 0.02f;        // metres kept free around a body, so that casts start clear
inline constexpr float kStepHeight = 0.35f;     // metres walked up without jumping
inline constexpr float kMinGroundY = 0.6427876f;  // of the normal: cos 50 degrees, the steepest floor

// An upright capsule standing on `feet`.
struct Body {
    glm::vec3 feet{0.0f};
    float radius = 0.3f;
    float height = 1.75f;
};

// The capsule's axis; a body lower than twice its radius is a ball.
[[nodiscard]] rc::Segment axis_of(const Body& body);

struct Ground {
    bool is_there = false;  // and flat enough to stand on
    float height = 0.0f;    // of the place that is touched
    std::uint32_t instance = rc::kNone;
    std::uint32_t primitive = rc::kNone;
};

// Carries `body` along `displacement`, sliding along what it meets. With `is_walking` steep surfaces are walls and
// floors keep the horizontal speed. `velocity` loses what runs into surfaces.
void slide(const rc::Scene& scene, Body& body, glm::vec3 displacement, bool is_walking, glm::vec3& velocity);

// As slide, but climbs steps of up to kStepHeight.
void walk(const rc::Scene& scene, Body& body, const glm::vec3& displacement, glm::vec3& velocity);

// The floor within `reach` below the feet. When there is one the body is set down on it.
Ground stand(const rc::Scene& scene, Body& body, float reach);

// Moves the body out of whatever overlaps it (a door that has swung), never through anything else.
void push_out(const rc::Scene& scene, Body& body);

// Whether a body of this height would fit where it stands.
[[nodiscard]] bool has_room(const rc::Scene& scene, const Body& body);

}  // namespace gh::sim
