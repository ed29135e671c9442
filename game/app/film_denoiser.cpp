#include "app/film_denoiser.h"

#include "base/contracts.h"
#include "filter/interleave.h"
#include "filter/rows.h"

#include <algorithm>
#include <vector>

namespace gh::app {

namespace {

using Vectors = std::vector<glm::vec3>;

// One row of a plane of the film.
void copy_row(const Vectors& from, int y, filter::Plane3& to) {
    float* rows[3];
    filter::point_to(rows, to, y);
    const auto width = static_cast<std::size_t>(to.width());
    filter::part_row(&from[static_cast<std::size_t>(y) * width].x, width, rows);
}

template <class T>
void copy_row(const std::vector<T>& from, int y, filter::PlaneOf<T>& to) {
    const auto width = static_cast<std::ptrdiff_t>(to.width());
    std::copy_n(from.begin() + y * width, width, to.row(y));
}

void fit(int width, int height, filter::GBuffer& surfaces, filter::Light& light) {
    surfaces.part.fit(width, height);
    surfaces.position.fit(width, height);
    surfaces.normal.fit(width, height);
    for (filter::Plane3* planes : {&surfaces.previous, &surfaces.geometric, &surfaces.albedo, &surfaces.gloss,
                                   &light.direct, &light.indirect, &light.specular, &light.clean})
        planes->fit(width, height);
    surfaces.roughness.fit(width, height);
    surfaces.reflected.fit(width, height);
}

void copy_row(const render::FilmPlanes& planes, int y, filter::GBuffer& surfaces, filter::Light& light) {
    copy_row(planes.part, y, surfaces.part);
    copy_row(planes.position, y, surfaces.position);
    copy_row(planes.previous, y, surfaces.previous);
    copy_row(planes.normal, y, surfaces.normal);
    copy_row(planes.geometric, y, surfaces.geometric);
    copy_row(planes.albedo, y, surfaces.albedo);
    copy_row(planes.gloss, y, surfaces.gloss);
    copy_row(planes.roughness, y, surfaces.roughness);
    copy_row(planes.reflected, y, surfaces.reflected);
    filter::part_row(planes.direct, y, light.direct);
    filter::part_row(planes.indirect, y, light.indirect);
    filter::part_row(planes.specular, y, light.specular);
    filter::part_row(planes.clean, y, light.clean);
}

}  // namespace

void FilmDenoiser::denoise(render::Film& film, const Jobs& jobs, const filter::DenoiseSettings& settings,
                           const filter::Plane& change_then) {
    EXPECTS(!film.planes.part.empty());
    static_assert(render::FilmPlanes::kSky == filter::kNoSurface);
    const render::FilmPlanes& planes = film.planes;
    EXPECTS(film.radiance.width == planes.direct.width && film.radiance.height == planes.direct.height);
    fit(planes.direct.width, planes.direct.height, surfaces_, light_);
    surfaces_.lens = {planes.eye, planes.corner, planes.right, planes.down};
    light_.change_then = change_then;
    denoiser_.denoise(surfaces_, light_, settings, jobs, picture_,
                      {.before = [&](int y) { copy_row(planes, y, surfaces_, light_); },
                       .after = [&](int y) { filter::join_row(picture_, y, film.radiance); }});
}

}  // namespace gh::app
