// render/ambient_bake.h - how the ambient light is found: rays from every grid point, what lamps do where they end,
// and again with what came of that, once for every bounce.
#pragma once

#include "base/jobs.h"
#include "render/ambient.h"
#include "render/scene_view.h"

namespace gh::render {

struct BakeSettings {
    int rays = 96;        // from each point
    int bounces = 3;      // 1: light that one wall gave back
    int gleam_rays = 12;  // more to each lamp shade whose inside the point may see
};

// view.prepared needs all but `ambient`.
[[nodiscard]] AmbientBake bake_ambient(const SceneView& view, const Grid& grid, const BakeSettings& settings,
                                       const Jobs& jobs);

}  // namespace gh::render
