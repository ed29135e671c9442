// sense/exposure.h - how visible light makes a body: the number of the HUD's gem, and the guards' number.
//
// Scale     perceived lightness goes with the logarithm of light: `lit` is 0 up to kDarkIrradiance, 1 from
//           kBrightIrradiance on, and grows by the same step for every doubling in between.
// Cost      about 10 points x lamps in range x 1 to 4 rays.
// Threads   pure. Same bits: see lamp_light.h.
#pragma once

#include "sense/body.h"
#include "world/level.h"
#include "world/snapshot.h"

#include <glm/vec3.hpp>

#include <array>

namespace gh::sense {

// In W/m2, from the Museum of Light: lamps' pools have 1 to 4, rooms 0.3 to 1, moonlit floors about 0.1.
inline constexpr float kDarkIrradiance = 0.02f;
inline constexpr float kBrightIrradiance = 4.0f;

struct Exposure {
    std::array<glm::vec3, kBodyPoints> irradiance;  // W/m2 per colour at each point
    std::array<float, kBodyPoints> lit;             // 0..1 of each point
    float level = 0.0f;                             // 0..1: mean of lit, what the gem shows
};

// Luminance (Rec. 709) of a linear colour.
[[nodiscard]] float luminance(const glm::vec3& rgb);

// 0 dark .. 1 fully lit.
[[nodiscard]] float lightness_of(const glm::vec3& irradiance);

[[nodiscard]] Exposure exposure(const world::Level& level, const world::Snapshot& snapshot,
                                const BodyPoints& body);

}  // namespace gh::sense
