// sense/glass.h - what of a straight beam of light gets through panes.
//
// Every surface crossed takes its Fresnel reflection and its tint (base colour x transmission, or 1 - alpha of a
// blended material); what lies between entering and leaving one part absorbs by Beer's law. A face without a partner
// is a sheet too thin to have an inside: both of its borders reflect, to and fro. The beam is not bent: a pane shifts
// it by a third of its thickness, which no shadow shows.
// Textures of glass are not looked at: its factors speak for it. Threads: pure. Same bits: no libm.
#pragma once

#include "world/level.h"
#include "world/snapshot.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace gh::sense {

[[nodiscard]] bool lets_light_through(const world::Material& material);

// Share of unpolarised light a smooth surface reflects, met at `cosine` to its normal from the thin side.
[[nodiscard]] float fresnel_reflectance(float cosine, float ior);

// Share of the light along `from` -> `to` that arrives, per colour: 0 behind anything opaque.
// A hit on `source_part` (kNoIndex: none) has arrived.
[[nodiscard]] glm::vec3 light_transmittance(const world::Level& level, const rc::Scene& scene,
                                            const glm::vec3& from, const glm::vec3& to,
                                            std::uint32_t source_part = world::kNoIndex);

}  // namespace gh::sense
