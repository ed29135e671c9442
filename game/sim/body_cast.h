// sim/body_cast.h - when a small ball on its way first meets somebody. Characters are no triangles: to stones they are
// upright capsules, as they are to doors and to one another, but with a foot as wide as the hips, so that what rolls
// along the floor is turned away and not pressed into it.
//
// Cost      three quadratics. Threads: pure. Same bits: sqrt only.
// Inside    a ball that starts in the body and moves on inwards hits at t = 0; on its way out it hits nothing.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "sim/motion.h"

namespace gh::sim {

struct BodyHit {
    float t = 0.0f;          // share of the displacement travelled, in [0, 1]
    glm::vec3 point{0.0f};   // on the body's skin
    glm::vec3 normal{0.0f};  // unit, out of the body
};

[[nodiscard]] std::optional<BodyHit> cast_at_body(const Body& body, const glm::vec3& centre, float radius,
                                                  const glm::vec3& displacement);

}  // namespace gh::sim
