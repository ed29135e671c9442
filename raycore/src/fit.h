// fit.h - boxes and triangle blocks brought to where the vertices are: the last step of a build, and all of a refit.
#pragma once

#include "data.h"

#include <glm/vec3.hpp>

#include <span>

namespace rc {

// Fills every block from `positions` and fits every box around its triangles, leaves first. The blocks' primitive
// rows must stand. A triangle that is not usable where it is now gets NaN corners and no box: nothing meets it.
void fit(Blas::Data& blas, std::span<const glm::vec3> positions);

// -0 becomes +0, so that a box has one representation; one of nothing is met by nothing.
[[nodiscard]] Box box_of(const GrowingBox& box);

// Expected cost of a random ray: 1 per node, 1 per triangle.
[[nodiscard]] float cost_of(const Blas::Data& blas);

}  // namespace rc
