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
    for (Plane3* light : {&direct, &indirect, &specular, &clean}) light->fit(width, height);
    part.resize(width, height, kSky);
    for (Plane3* plane : {&position, &previous, &geometric, &normal, &albedo, &gloss})
        plane->resize(width, height);
    roughness.resize(width, height, 1.0f);
    reflected.resize(width, height);
    rays.resize(width, height);
}

}  // namespace gh::render
