// sense/lamp_light.h - how much light each lamp sends to a point: the light of exposure, without any renderer.
//
// Units     metres; irradiance in W/m2 per colour.
// Estimate  point, spot, sun: one ray, exact. Sphere: four rays spread over the disc one sees, exact where all of it is
//           seen. Rect: one ray a quarter, and the unshadowed integral by 4 x 4 Gauss points. Fixed samples: no noise,
//           hence no flicker, for a light gem to show. Four rays to bulbs far away as well: a shade beside a bulb hides
//           part of it from any distance.
// Glass     takes its share: glass.h.
// Its bulb  never shadows a lamp: a ray that meets the lamp's own part has arrived.
// Cost      1 to 4 rays a probe and lamp in range.
// Threads   pure. Same bits: no libm, sums in index order.
#pragma once

#include "world/level.h"
#include "world/snapshot.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>

namespace gh::sense {

// Something small to be lit. With a unit normal it is a flat patch facing there; with none (zero) a small
// ball that turns a side to every lamp, as points of a body do: what it receives is the scalar irradiance.
struct Probe {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
};

// What lamp `lamp`, if it shone, would give at each probe, through glass, with shadows. out[i] answers
// probes[i].
void irradiance_from_lamp(const world::Level& level, const rc::Scene& scene, std::size_t lamp,
                          std::span<const Probe> probes, std::span<glm::vec3> out);

// The sum over all lamps that shine now.
void irradiance(const world::Level& level, const world::Snapshot& snapshot, std::span<const Probe> probes,
                std::span<glm::vec3> out);

}  // namespace gh::sense
