// filter/lit_light.h - the light that a lit pixel says is on its surface.
//
// It is what the pixel shows, less what is clean there, by its colour. Where a highlight outshines all else, that is a small
// difference of large numbers, and lit pixels know highlights by chance: there the light beside it is taken.
//
// Same bits pure.
#pragma once

#include "filter/temporal_upscale.h"

namespace gh::filter {

// Of lit pixel `lit`, of the mean of the nearest on the same surface if it is outshone: `reach` is how far one surface
// leaves its own plane, a metre from the eye. With none within three lit pixels it is its own, not less than none. Not
// finite where the pixel is not.
[[nodiscard]] glm::vec3 light_of_lit(const GuidedFrame& frame, glm::ivec2 lit, float reach);

}  // namespace gh::filter
