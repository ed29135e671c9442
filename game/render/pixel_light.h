// render/pixel_light.h - what a tile leaves for each pixel: light that has no noise, and light that neighbours share.
#pragma once

#include "base/image.h"
#include "base/jobs.h"
#include "render/film.h"

#include <glm/vec3.hpp>

#include <vector>

namespace gh::render {

// Of a pixel's main surface: its light if nothing stood before the lamps, exact; and an estimate, by few shadow rays and
// right on average, of what of it arrives. A single pixel's may be negative or more than there is.
struct SharedLight {
    glm::vec3 unshadowed{0.0f};
    glm::vec3 arrived{0.0f};
};
// Whether all of it does, but for less than an eye can tell.
[[nodiscard]] bool arrives_whole(const SharedLight& light);

struct PixelLight {
    glm::vec3 clean{0.0f};  // exact for this pixel
    SharedLight shared;
    // The main surface, by which pixels know whether they belong together.
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
    float size = 0.0f;      // of the pixel there, metres; 0: no surface
    bool is_mixed = false;  // its samples lie on several surfaces
};

// Whether two pixels show one surface, that goes on between them.
[[nodiscard]] bool are_together(const PixelLight& a, const PixelLight& b);

// Adds it up. With `shares`, the share of the light that gets through is averaged over 5x5 neighbours on the same
// surface, in which every pixel of the 4x4 sampling pattern counts the same.
void develop(const std::vector<PixelLight>& pixels, bool shares, const Jobs& jobs, Image& out);

}  // namespace gh::render
