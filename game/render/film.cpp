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

void FilmPlanes::resize_surfaces(std::size_t pixels) {
    part.assign(pixels, kSky);
    for (std::vector<glm::vec3>* plane : {&position, &previous, &geometric})
        plane->assign(pixels, glm::vec3(0.0f));
}

void FilmPlanes::resize(int width, int height) {
    for (Image* image : {&direct, &indirect, &specular, &clean}) {
        if (image->width != width || image->height != height) *image = Image(width, height);
    }
    const std::size_t count = direct.pixels.size();
    resize_surfaces(count);
    for (std::vector<glm::vec3>* plane : {&normal, &albedo, &gloss}) plane->assign(count, glm::vec3(0.0f));
    roughness.assign(count, 1.0f);
    reflected.assign(count, 0.0f);
    rays.assign(count, 0.0f);
}

}  // namespace gh::render
