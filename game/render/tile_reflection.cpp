// The part of a tile that sends mirrored rays off polished surfaces: from all of their pixels, or from a few and, where
// what those bring differs beside the surface's own light, from more in between.
#include "render/colour.h"
#include "render/tile.h"
#include "render/tile_blend.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace gh::render {

namespace {

constexpr float kSameMirror = 0.99995f;  // least cosine between normals: a mirrored ray turns twice as far

}  // namespace

void TileTracer::reflect_main_surfaces(FrameStats& stats) {
    for (int pass = 0; pass < kLatticePasses; ++pass) reflect_pass(pass, stats);
}

void TileTracer::reflect_pass(int pass, FrameStats& stats) {
    visit_pass(pass, [this](const Corners& corners) { return is_reflection_blended(corners); });
    now_.clear();
    for (const std::uint16_t i : not_blended_) {
        const SeenSurface& surface = main_.surfaces[i];
        if (!(brightest(surface.polished) > 0.0f)) continue;
        now_.push_back(mirrored_ray(surface));
        now_.back().is_glimmer = true;
    }
    stats.reflected_rays += now_.size();
    trace_all(stats);
    for (const std::uint16_t i : not_blended_) {
        const SeenSurface& surface = main_.surfaces[i];
        main_.reflections[i] = ratio(main_.reflections[i], surface.path.weight * surface.polished, 0.0f);
    }
}

bool TileTracer::is_reflection_blended(const Corners& corners) {
    const SeenSurface& here = main_.surfaces[corners.centre];
    if (!(brightest(here.polished) > 0.0f)) return true;
    glm::vec3 blend(0.0f);
    const glm::vec3 weight = here.path.weight * here.polished;
    float least = rc::kInfinity, most = 0.0f;
    for (std::size_t i = 0; i < corners.count; ++i) {
        if (glm::dot(here.at.normal, main_.surfaces[corners.surface[i]].at.normal) < kSameMirror)
            return false;
        if (!(brightest(main_.surfaces[corners.surface[i]].polished) > 0.0f)) return false;
        const glm::vec3& reflection = main_.reflections[corners.surface[i]];
        const float shown = brightest(weight * reflection);
        least = std::min(least, shown);
        most = std::max(most, shown);
        blend += reflection * corners.weight[i];
    }
    if (!is_alike(least, most, light_so_far(corners.centre), frame_.settings.contrast)) return false;
    main_.reflections[corners.centre] = blend;
    return true;
}

}  // namespace gh::render
