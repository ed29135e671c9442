// sense/sight.h - how much of a body a watcher can see, directly and in mirrors.
//
// Layers    what stops a look carries Sight. Glass does not, nor do characters: nobody's own head is in the way.
// Cost      at most one ray a body point and eye; in mirrors two a point, eye and pane, after tests without rays.
// Threads   pure: reads its arguments only. Same bits: no libm.
#pragma once

#include "sense/body.h"
#include "world/snapshot.h"

#include "raycore/scene.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace gh::sense {

struct Eye {
    glm::vec3 position{0.0f};   // metres, world frame
    glm::vec3 forward{0.0f};    // unit
    float cos_half_fov = 0.0f;  // cosine of half the opening angle of the view cone
    float range = 0.0f;         // metres, closed
};

struct Body {
    BodyPoints point{};                    // metres, world frame
    std::array<float, kBodyPoints> lit{};  // 0 in darkness, 1 in full light: Exposure::lit
};

// What one eye makes of the body.
struct Sighting {
    float seen = 0.0f;      // mean over all body points of lit where seen and 0 elsewhere, in [0, 1]
    float clear = 0.0f;     // share of the body points in plain view, lit or not
    float distance = 0.0f;  // metres along the light to the nearest point seen; 0 when none is
    std::uint32_t pane = world::kNoIndex;  // in mirrors: the pane that shows most
};

// out[e] is what eyes[e] sees along straight lines.
void sight(const rc::Scene& scene, std::span<const Eye> eyes, const Body& body, std::span<Sighting> out);

// out[e] is what eyes[e] sees in one pane after another: the view cone is judged towards the pane, the range
// along both stretches, and a point counts with the reflectance's luminance, once, in the pane that shows it
// best. Mirrors seen in mirrors are not followed. A pane shows nothing unless its part carries the Sight
// layer.
void mirror_sight(const rc::Scene& scene, std::span<const world::MirrorPane> panes, std::span<const Eye> eyes,
                  const Body& body, std::span<Sighting> out);

}  // namespace gh::sense
