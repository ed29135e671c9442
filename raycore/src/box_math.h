// box_math.h - one resting box against one triangle, exactly. Private to raycore.
//
// Method    separating axes (Gottschalk, Lin, Manocha 1996; Akenine-Moeller 2001) in the box's own frame and in double:
//           two convex bodies overlap when no face of either and no pair of edges has a plane between them, and the
//           least depth over those planes is the shortest way out. The contact is found by clipping the triangle to
//           the box (Sutherland and Hodgman 1974).
#pragma once

#include "cast_math.h"

#include "raycore/bodies.h"

#include <array>
#include <optional>

namespace rc::cast {

struct PlacedBox {
    glm::dvec3 centre;
    std::array<glm::dvec3, 3> axes;  // orthonormal
    glm::dvec3 half;
    double touch;  // an overlap up to this is rounding
    Box around;    // in the world, a little beyond rounding
};

// Nothing when a number is not finite, a side is negative or the axes lie in a plane.
[[nodiscard]] std::optional<PlacedBox> place(const OrientedBox& box);

// How the box overlaps a triangle of the world; `point` in the world.
[[nodiscard]] std::optional<Contact> resting_contact(const PlacedBox& box,
                                                     const std::array<glm::vec3, 3>& corners);

}  // namespace rc::cast
