// clip.h - the part of a triangle on either side of a plane, in a box that certainly holds it.
#pragma once

#include "kernels/build_abi.h"

#include "raycore/mesh.h"

#include <glm/vec3.hpp>

namespace rc::build {

// Refs of the same triangle that share what `ref` holds of it: up to `plane` and from it on. Cut in double, rounded
// outwards, the slack of the whole triangle around: every point of the triangle that lies in `ref` with its slack lies so
// in one of them (the proof in kernels/README.md needs no more).
// Precondition: the plane passes through the ref's box.
void clip(const BuildRef& ref, const glm::vec3 (&corners)[3], int axis, float plane, BuildRef& left,
          BuildRef& right);

}  // namespace rc::build
