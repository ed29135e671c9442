// cast_query.h - what casts and overlaps share: bodies checked and prepared for cast_math. Private to
// raycore.
#pragma once

#include "cast_math.h"

#include "raycore/bodies.h"

#include <glm/vec3.hpp>

#include <array>
#include <optional>

namespace rc::cast {

// A body in the frame cast_math wants, and where that frame's origin lies in the world.
struct PlacedBody {
    Body body;
    glm::dvec3 origin;

    // The corners of a triangle of the world, seen from the body.
    [[nodiscard]] Corners relative(const std::array<glm::vec3, 3>& corners) const;
    // A box that holds, a little beyond rounding, all that the body sweeps through between two times.
    [[nodiscard]] Box swept_box(double from, double to) const;
    // In how many pieces to sweep: the box of a long way aslant holds much that is nowhere near.
    [[nodiscard]] int pieces() const;
    // The contact in the world's frame. t is rounded down: a body moved by it is never beyond the contact.
    [[nodiscard]] CastHit hit(const Contact& contact, std::uint32_t instance, std::uint32_t primitive) const;
};

// Nothing when a number is not finite or the radius is negative.
[[nodiscard]] std::optional<PlacedBody> place(const Segment& axis, float radius,
                                              const glm::vec3& displacement);

}  // namespace rc::cast
