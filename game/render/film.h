// render/film.h - what a renderer fills: the picture, and what it took.
#pragma once

#include "base/image.h"

#include <cstdint>

namespace gh::render {

// Rays asked for by purpose, for the profiler. Summed over tiles in index order: the same for any thread count.
struct FrameStats {
    std::uint64_t primary_rays = 0;    // from the eye
    std::uint64_t reflected_rays = 0;  // off mirrors, polished floors, glass
    std::uint64_t refracted_rays = 0;  // into or through glass and past transparent texels
    std::uint64_t shadow_rays = 0;     // to lamps
    std::uint64_t glass_shadow_rays =
        0;                           // the same once more, where glass or cut-out leaves may stand in between
    std::uint64_t ambient_rays = 0;  // short ones that find corners
    std::uint64_t lit_pixels = 0;    // no rays: pixels whose light was worked out, not blended from others'

    [[nodiscard]] std::uint64_t total() const {
        return primary_rays + reflected_rays + refracted_rays + shadow_rays + glass_shadow_rays +
               ambient_rays;
    }
    FrameStats& operator+=(const FrameStats& other);
};

struct Film {
    Image radiance;  // linear, scene-referred; its size is the picture's size
    FrameStats stats;

    Film() = default;
    Film(int width, int height) : radiance(width, height) {}
};

}  // namespace gh::render
