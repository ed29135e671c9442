// render/sky.h - what a ray sees that leaves the level: a sky lit by the level's suns (or moons), else darkness.
//
// A clear sky gives a level ground about an eighth of what the sun gives a surface facing it, brightest near the
// horizon, bluer than the sun. Proportional to the suns, so that one that is off takes its sky along.
#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

// `sun`: W/m2 across the sun's direction, summed over suns. `direction` unit.
[[nodiscard]] inline glm::vec3 sky_radiance(const glm::vec3& sun, const glm::vec3& direction) {
    const glm::vec3 zenith(0.026f, 0.036f, 0.056f), horizon(0.048f, 0.052f, 0.060f),
        ground(0.010f, 0.010f, 0.011f);
    if (direction.y <= 0.0f) {
        const float depth = std::min(1.0f, -8.0f * direction.y);  // haze hides the edge of the world
        return sun * (horizon * (1.0f - depth) + ground * depth);
    }
    const float height = std::sqrt(std::min(1.0f, direction.y));
    return sun * (horizon * (1.0f - height) + zenith * height);
}

}  // namespace gh::render
