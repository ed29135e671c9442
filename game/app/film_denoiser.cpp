#include "app/film_denoiser.h"

#include "base/contracts.h"

namespace gh::app {

namespace {

void copy(const std::vector<glm::vec3>& from, int width, int height, filter::Plane3& to) {
    to.fit(width, height);
    std::size_t i = 0;
    for (int y = 0; y < height; ++y) {
        float *red = to.x.row(y), *green = to.y.row(y), *blue = to.z.row(y);
        for (int x = 0; x < width; ++x, ++i) {
            red[x] = from[i].x;
            green[x] = from[i].y;
            blue[x] = from[i].z;
        }
    }
}

template <class T>
void copy(const std::vector<T>& from, int width, int height, filter::PlaneOf<T>& to) {
    to.fit(width, height);
    std::size_t i = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) to.row(y)[x] = from[i++];
    }
}

}  // namespace

void gbuffer_from(const render::FilmPlanes& planes, filter::GBuffer& out) {
    static_assert(render::FilmPlanes::kSky == filter::kNoSurface);
    const int width = planes.direct.width, height = planes.direct.height;
    out.lens = {planes.eye, planes.corner, planes.right, planes.down};
    copy(planes.part, width, height, out.part);
    copy(planes.position, width, height, out.position);
    copy(planes.previous, width, height, out.previous);
    copy(planes.normal, width, height, out.normal);
    copy(planes.geometric, width, height, out.geometric);
    copy(planes.albedo, width, height, out.albedo);
    copy(planes.gloss, width, height, out.gloss);
    copy(planes.roughness, width, height, out.roughness);
    copy(planes.reflected, width, height, out.reflected);
}

void light_from(const render::FilmPlanes& planes, filter::Light& out) {
    filter::planes_from(planes.direct, out.direct);
    filter::planes_from(planes.indirect, out.indirect);
    filter::planes_from(planes.specular, out.specular);
    filter::planes_from(planes.clean, out.clean);
}

void FilmDenoiser::denoise(render::Film& film, const Jobs& jobs, const filter::DenoiseSettings& settings,
                           const filter::Plane& change_then) {
    EXPECTS(!film.planes.part.empty());
    gbuffer_from(film.planes, surfaces_);
    light_from(film.planes, light_);
    light_.change_then = change_then;
    denoiser_.denoise(surfaces_, light_, settings, jobs, picture_);
    filter::image_from(picture_, film.radiance);
}

}  // namespace gh::app
