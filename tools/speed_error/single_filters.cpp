#include "single_filters.h"

#include "clocks.h"
#include "filter/albedo.h"
#include "filter/bilateral.h"
#include "filter/gaussian.h"
#include "filter/mend.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace speed_error {

namespace {

using gh::Image;
using gh::Jobs;
using gh::filter::Plane3;
using gh::render::Film;

constexpr float kSigma = 2.0f;  // pixels

Plane3 mended(const Image& image, const Jobs& jobs) {
    Plane3 raw, out;
    gh::filter::planes_from(image, raw);
    gh::filter::mend(raw, {}, jobs, out);
    return out;
}

Plane3 planes_of(const std::vector<glm::vec3>& vectors, int width) {
    Plane3 out(width, static_cast<int>(vectors.size()) / width);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        out.set(static_cast<int>(i) % width, static_cast<int>(i) / width, vectors[i]);
    return out;
}

// A picture in two: what is blurred, and what stays where it is. That is what lamps and mirrors show by themselves, and what
// is brighter than twice a screen's white, lamps mirrored in floors and the insides of shades: it would bury all beside it.
// A lone firefly is neither and is mended before: else it would stay where it is as well.
struct Parted {
    Plane3 light;
    Image still;
};
Parted parted(const Film& film, const Jobs& jobs) {
    constexpr float kBright = 2.0f;
    Image light = film.radiance;
    for (std::size_t i = 0; i < light.pixels.size(); ++i) light.pixels[i] -= film.planes.clean.pixels[i];
    gh::filter::image_from(mended(light, jobs), light);
    Parted parts{{}, film.planes.clean};
    for (std::size_t i = 0; i < light.pixels.size(); ++i) {
        glm::vec3& shown = light.pixels[i];
        const float peak = std::max(std::max(shown.x, shown.y), shown.z);
        if (!(peak > kBright)) continue;
        const glm::vec3 kept = shown * (kBright / peak);
        parts.still.pixels[i] += shown - kept;
        shown = kept;
    }
    gh::filter::planes_from(light, parts.light);
    return parts;
}

void join(const Plane3& light, const Image& still, Film& film) {
    gh::filter::image_from(light, film.radiance);
    for (std::size_t i = 0; i < film.radiance.pixels.size(); ++i) film.radiance.pixels[i] += still.pixels[i];
}

void by_gaussian(Film& film, const Jobs& jobs) {
    const Parted parts = parted(film, jobs);
    Plane3 out;
    gh::filter::gaussian(parts.light, kSigma, jobs, out);
    join(out, parts.still, film);
}

void by_bilateral(Film& film, const Jobs& jobs) {
    const Parted parts = parted(film, jobs);
    Plane3 out;
    gh::filter::bilateral(parts.light, {.sigma_px = kSigma, .luminance = 2.0f}, jobs, out);
    join(out, parts.still, film);
}

// Colours apart from what shines on them.
void by_surfaces(Film& film, const Jobs& jobs) {
    const int width = film.radiance.width, height = film.radiance.height;
    gh::filter::GBuffer surfaces;
    surfaces.part.fit(width, height);
    for (std::size_t i = 0; i < film.planes.part.size(); ++i)
        surfaces.part.at(static_cast<int>(i) % width, static_cast<int>(i) / width) = film.planes.part[i];
    surfaces.position = planes_of(film.planes.position, width);
    surfaces.normal = planes_of(film.planes.normal, width);
    surfaces.geometric = planes_of(film.planes.geometric, width);
    surfaces.albedo = planes_of(film.planes.albedo, width);
    surfaces.lens = {film.planes.eye, film.planes.corner, film.planes.right, film.planes.down};
    gh::filter::Guides guides;
    gh::filter::make_guides(surfaces, jobs, guides);

    Image dull = film.planes.direct;
    for (std::size_t i = 0; i < dull.pixels.size(); ++i) dull.pixels[i] += film.planes.indirect.pixels[i];
    const gh::filter::BilateralSettings settings{.sigma_px = kSigma, .luminance = 0.0f};
    Plane3 light = mended(dull, jobs), smooth_dull, smooth_shine;
    gh::filter::demodulate(light, surfaces.albedo, jobs, light);
    gh::filter::cross_bilateral(light, guides, {}, settings, jobs, smooth_dull);
    gh::filter::cross_bilateral(mended(film.planes.specular, jobs), guides, {}, settings, jobs, smooth_shine);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::vec3 albedo = glm::max(surfaces.albedo.get(x, y), gh::filter::kLeastAlbedo);
            light.set(x, y, smooth_dull.get(x, y) * albedo + smooth_shine.get(x, y));
        }
    }
    join(light, film.planes.clean, film);
}

}  // namespace

std::vector<Contestant> single_filters(const gh::render::PathSettings& settings, const char* truth) {
    struct Filter {
        const char* name;
        void (*apply)(Film&, const Jobs&);
    };
    gh::render::PathSettings own = settings;
    own.fills_planes = own.splits_glass = true;
    std::vector<Contestant> all;
    for (const Filter& filter :
         {Filter{"Gaussian", by_gaussian}, {"bilateral", by_bilateral}, {"cross-bilateral", by_surfaces}}) {
        const std::string family = fmt::format("path, real time, {}", filter.name);
        all.push_back(
            {.name = family + ", 1 spp",
             .family = family,
             .truth = truth,
             .samples_per_pixel = 1,
             .begin = [own, filter] {
                 return [own, filter](const Shot& shot, Film& film) {
                     gh::render::PathSettings seeded = own;
                     seeded.seed = shot.seed;
                     const double start = core_ms();
                     gh::render::render_path(shot.scene, shot.camera, seeded, shot.frame, shot.jobs, film);
                     const double rendered = core_ms();
                     filter.apply(film, shot.jobs);
                     return StageTimes{.render_ms = rendered - start, .filter_ms = core_ms() - rendered};
                 };
             }});
    }
    return all;
}

}  // namespace speed_error
