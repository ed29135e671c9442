// The part of a tile that decides for which pixels light is worked out: for all of them, or for a few and, where those
// differ, for more in between. The rest blend what their neighbours on the same surface found.
#include "base/det_math.h"
#include "render/colour.h"
#include "render/light_math.h"
#include "render/tile.h"
#include "render/tile_blend.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kShineTurns = 0.995f;  // least cosine between normals where what shines counts
constexpr float kShineCounts = 0.1f;

}  // namespace

void TileTracer::light_main_surfaces(FrameStats& stats) {
    for (int pass = 0; pass < kLatticePasses; ++pass) light_pass(pass, stats);
}

void TileTracer::light_pass(int pass, FrameStats& stats) {
    visit_pass(pass, [this](const Corners& corners) { return is_blended(corners); });
    const bool speaks_for_many = pass + 1 < kLatticePasses;
    lit_.clear();
    for (const std::uint16_t i : not_blended_) lit_.push_back(&main_.surfaces[i]);
    visit_lit([&](std::size_t number, std::size_t i) {
        main_.lights[not_blended_[number]] = collect_light(*lit_[number], i);
        ask_for_shares(*lit_[number], speaks_for_many);
    });
    stats.lit_pixels += not_blended_.size();
    trace_shadows(stats);
    for (const std::uint16_t i : not_blended_) {
        SurfaceLight& light = main_.lights[i];
        const SharedLight& found = main_.found[i];
        light.is_plain = arrives_whole(found);
        if (!light.is_plain) light.seen = ratio(found.arrived, found.unshadowed, 1.0f);
    }
}

// Blends the light of the pixels around it; false where they are too different.
bool TileTracer::is_blended(const Corners& corners) {
    const SeenSurface& here = main_.surfaces[corners.centre];
    SurfaceLight blend;
    glm::vec3 seen_irradiance(0.0f), seen_shine(0.0f);
    float least = rc::kInfinity, most = 0.0f;
    for (std::size_t i = 0; i < corners.count; ++i) {
        const SurfaceLight& light = main_.lights[corners.surface[i]];
        const glm::vec3 turn = here.at.normal - main_.surfaces[corners.surface[i]].at.normal;
        const glm::vec3 irradiance = glm::max(light.irradiance + light.turns * turn, 0.0f);
        const glm::vec3 seen = light.seen * irradiance;
        const float shine = brightest(light.shine * light.seen);
        const float shown = brightest(here.diffuse * seen * kPerPi + light.shine * light.seen);
        // |a - b|^2 = 2 - 2 cos for unit vectors
        if (shine > kShineCounts * shown && glm::dot(turn, turn) > 2.0f * (1.0f - kShineTurns)) return false;
        least = std::min(least, shown);
        most = std::max(most, shown);
        const float weight = corners.weight[i];
        blend.irradiance += irradiance * weight;
        blend.shine += light.shine * weight;
        blend.turns += light.turns * weight;
        blend.is_plain = blend.is_plain && light.is_plain;
        seen_irradiance += seen * weight;
        seen_shine += light.shine * light.seen * weight;
    }
    const float weighs = brightest(here.path.weight);
    if (!is_alike(least * weighs, most * weighs, 0.0f, frame_.settings.contrast)) return false;

    const auto leaving = [&](const glm::vec3& irradiance, const glm::vec3& shine) {
        return here.path.weight * (here.diffuse * irradiance * kPerPi + shine);
    };
    SharedLight& found = main_.found[corners.centre];
    found.unshadowed = leaving(blend.irradiance, blend.shine);
    found.arrived = blend.is_plain ? found.unshadowed : leaving(seen_irradiance, seen_shine);
    blend.seen = ratio(found.arrived, found.unshadowed, 1.0f);
    main_.lights[corners.centre] = blend;
    return true;
}

// What the pixel shows besides what its surface mirrors, as far as is known.
float TileTracer::light_so_far(std::uint16_t surface) const {
    const std::uint16_t pixel = main_.surfaces[surface].path.pixel;
    return brightest(pixels_[pixel].clean + main_.found[surface].unshadowed * main_.lights[surface].seen);
}

void TileTracer::add_main_light() {
    for (std::size_t i = 0; i < main_.surfaces.size(); ++i) {
        const SeenSurface& surface = main_.surfaces[i];
        PixelLight& out = pixels_[surface.path.pixel];
        out.shared.unshadowed += main_.found[i].unshadowed;
        out.shared.arrived += main_.found[i].arrived;
        out.clean += surface.path.weight * surface.polished * main_.reflections[i];
    }
}

}  // namespace gh::render
