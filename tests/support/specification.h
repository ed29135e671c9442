// support/specification.h - the specification of a ray meeting a triangle in the shape that the comparators' structures
// want (tools/bench/comparators/closest.h).
#pragma once

#include "support/brute_force.h"

#include <array>

namespace test {

class Specification {
  public:
    explicit Specification(const rc::Ray& ray) : origin_(ray.origin), direction_(ray.direction) {}

    bool operator()(const std::array<glm::vec3, 3>& corners, rc::Hit& hit) const {
        const glm::vec3 p[3] = {corners[0], corners[1], corners[2]};
        const std::optional<rc::Hit> met = meet_triangle(origin_, direction_, p);
        if (met) hit = *met;
        return met.has_value();
    }

  private:
    glm::vec3 origin_, direction_;
};

}  // namespace test
