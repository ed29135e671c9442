// render/guide.h - what every pixel of a picture shows, without the light that falls on it: by this a picture of few
// pixels is made into one of many (filter/temporal_upscale.h).
//
// Mirrors and clear glass are looked through as Film::planes say; `clean` holds what shines by itself, sky and bulbs,
// exactly as a Whitted picture of the same pixel has it.
//
// Cost      one ray a pixel, and one more for every mirror and pane on its way. .1 to .2 us a pixel on one core, .3 in a
//           hall of mirrors.
// Threads, same bits, bad input   as render/whitted.h.
#pragma once

#include "render/whitted.h"

namespace gh::render {

// Fills `planes` for a picture of this size. Of the settings those count that say where rays go (jitter, max_depth,
// min_weight), how textures are looked up, and whether lamps are mirrored. The size must not be 0. Where the scene has a last picture `clean` holds what
// polished surfaces mirror as well (guide_gleams.h).
void render_guide(const SceneView& scene, const Camera& camera, const WhittedSettings& settings,
                  glm::ivec2 size, const Jobs& jobs, GuidePlanes& planes);

}  // namespace gh::render
