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

void FilmPlanes::resize(int width, int height) {
    fit_together(width, height, part, position, previous, geometric, normal, albedo, gloss, roughness,
                 reflected, rays, direct, indirect, specular, clean);
    part.fill(kSky);
    for (Plane3* plane : {&position, &previous, &geometric, &normal, &albedo, &gloss})
        plane->fill(glm::vec3(0.0f));
    roughness.fill(1.0f);
    reflected.fill(0.0f);
    rays.fill(0.0f);
}

}  // namespace gh::render
