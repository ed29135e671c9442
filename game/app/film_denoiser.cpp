#include "app/film_denoiser.h"

#include "base/contracts.h"
#include "filter/interleave.h"

#include <utility>

namespace gh::app {

namespace {

// The film's planes as the filters', without copying one; and back.
void exchange(render::FilmPlanes& planes, filter::GBuffer& surfaces, filter::Light& light) {
    std::swap(planes.part, surfaces.part);
    std::swap(planes.position, surfaces.position);
    std::swap(planes.previous, surfaces.previous);
    std::swap(planes.normal, surfaces.normal);
    std::swap(planes.geometric, surfaces.geometric);
    std::swap(planes.albedo, surfaces.albedo);
    std::swap(planes.gloss, surfaces.gloss);
    std::swap(planes.roughness, surfaces.roughness);
    std::swap(planes.reflected, surfaces.reflected);
    std::swap(planes.direct, light.direct);
    std::swap(planes.indirect, light.indirect);
    std::swap(planes.specular, light.specular);
    std::swap(planes.clean, light.clean);
}

}  // namespace

void FilmDenoiser::denoise(render::Film& film, const Jobs& jobs, const filter::DenoiseSettings& settings,
                           filter::Plane* change_then) {
    render::FilmPlanes& planes = film.planes;
    EXPECTS(!planes.part.empty());
    EXPECTS(film.radiance.width == planes.part.width() && film.radiance.height == planes.part.height());
    static_assert(render::FilmPlanes::kSky == filter::kNoSurface);
    surfaces_.lens = {planes.eye, planes.corner, planes.right, planes.down};
    const auto lend = [&] {
        exchange(planes, surfaces_, light_);
        if (change_then != nullptr) std::swap(*change_then, light_.change_then);
    };
    lend();
    denoiser_.denoise(surfaces_, light_, settings, jobs, picture_,
                      {.before = {}, .after = [&](int y) { filter::join_row(picture_, y, film.radiance); }});
    lend();
}

}  // namespace gh::app
