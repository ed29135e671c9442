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

Plane3 mended(const Plane3& light, const Jobs& jobs) {
    Plane3 out;
    gh::filter::mend(light, {}, jobs, out);
    return out;
}

Image image_of(const Plane3& planes) {
    Image image;
    gh::filter::image_from(planes, image);
    return image;
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
    Parted parts{{}, image_of(film.planes.clean)};
    for (std::size_t i = 0; i < light.pixels.size(); ++i) light.pixels[i] -= parts.still.pixels[i];
    gh::filter::planes_from(light, parts.light);
    light = image_of(mended(parts.light, jobs));
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
    surfaces.part = film.planes.part;
    surfaces.position = film.planes.position;
    surfaces.normal = film.planes.normal;
    surfaces.geometric = film.planes.geometric;
    surfaces.albedo = film.planes.albedo;
    surfaces.lens = {film.planes.eye, film.planes.corner, film.planes.right, film.planes.down};
    gh::filter::Guides guides;
    gh::filter::make_guides(surfaces, jobs, guides);

    Plane3 dull(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            dull.set(x, y, film.planes.direct.get(x, y) + film.planes.indirect.get(x, y));
    }
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
    join(light, image_of(film.planes.clean), film);
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
