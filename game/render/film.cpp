#include "render/film.h"

namespace gh::render {

FrameStats& FrameStats::operator+=(const FrameStats& other) {
    primary_rays += other.primary_rays;
    reflected_rays += other.reflected_rays;
    refracted_rays += other.refracted_rays;
    shadow_rays += other.shadow_rays;
    glass_shadow_rays += other.glass_shadow_rays;
    ambient_rays += other.ambient_rays;
    lit_pixels += other.lit_pixels;
    return *this;
}

void SeenThings::resize(std::size_t pixels) {
    part.resize(pixels);
    position.resize(pixels);
    previous.resize(pixels);
    normal.resize(pixels);
}

}  // namespace gh::render
