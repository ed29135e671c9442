// render/pixel_light.h - what a tile leaves for each pixel: light that has no noise, and light that neighbours share.
#pragma once

#include "base/image.h"
#include "base/jobs.h"

#include <glm/vec3.hpp>

#include <vector>

namespace gh::render {

struct PixelLight {
    glm::vec3 clean{0.0f};       // exact for this pixel
    glm::vec3 unshadowed{0.0f};  // of the main surface, if nothing stood before the area lamps: exact too
    glm::vec3 shadowed{0.0f};    // the same with what this pixel's few shadow rays found: noisy
    // The main surface, by which pixels know whether they belong together.
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
    float size = 0.0f;  // of the pixel there, metres; 0: no surface
};

// Adds it up. With `shares`, the share of the light that gets through is averaged over 5x5 neighbours on the same
// surface, in which every pixel of the 4x4 sampling pattern counts the same.
void develop(const std::vector<PixelLight>& pixels, bool shares, const Jobs& jobs, Image& out);

}  // namespace gh::render
