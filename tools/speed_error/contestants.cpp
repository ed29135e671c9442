#include "contestants.h"

#include "app/film_denoiser.h"
#include "app/guided_picture.h"
#include "app/reshading.h"
#include "clocks.h"
#include "render/path_tracer.h"
#include "render/whitted.h"
#include "single_filters.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace speed_error {

namespace {

using gh::render::Film;
using gh::render::PathSettings;
using gh::render::SampleKind;
using gh::render::WhittedSettings;

// Whitted has one number for frame and seed: runs are so far apart that none meets another.
constexpr std::uint32_t kFramesOfARun = 4096;

std::uint32_t whitted_number(const Shot& shot) {
    return shot.seed * kFramesOfARun + shot.frame;
}

// Each run has its own places in pixels, as it has its own samples: a mean of pictures through the same ones, which a truth is,
// would have their edges.
void whitted_frame(const Shot& shot, WhittedSettings settings, Film& film) {
    settings.places = shot.seed;
    gh::render::render_whitted(shot.scene, shot.camera, settings, whitted_number(shot), shot.jobs, film);
}

void path_frame(const Shot& shot, PathSettings settings, Film& film) {
    settings.seed = shot.seed;
    gh::render::render_path(shot.scene, shot.camera, settings, shot.frame, shot.jobs, film);
}

// A way that remembers nothing.
template <class Render>
std::function<Run()> single(Render render) {
    return [render] {
        return [render](const Shot& shot, Film& film) {
            const double start = core_ms();
            render(shot, film);
            return StageTimes{.render_ms = core_ms() - start};
        };
    };
}

std::string named(const std::string& family, int samples) {
    return fmt::format("{}, {} spp", family, samples);
}

Contestant whitted(const std::string& family, int samples, WhittedSettings settings) {
    settings.samples_per_pixel = samples;
    return {
        .name = named(family, samples),
        .family = family,
        .truth = "whitted",
        .samples_per_pixel = samples,
        .begin = single([settings](const Shot& shot, Film& film) { whitted_frame(shot, settings, film); })};
}

Contestant path(const std::string& family, int samples, PathSettings settings,
                const std::string& truth = "path") {
    settings.samples_per_pixel = samples;
    return {.name = named(family, samples),
            .family = family,
            .truth = truth,
            .samples_per_pixel = samples,
            .begin = single([settings](const Shot& shot, Film& film) { path_frame(shot, settings, film); })};
}

// What is seen, of a light picture whose sides go into the film's this many times.
int step_of(const Film& film) {
    const glm::ivec2 size(film.radiance.width, film.radiance.height);
    for (const int step : {3, 2}) {
        if (size % step == glm::ivec2(0)) return step;
    }
    return 1;
}

// As the game shows it: every pixel is looked at, one in four or nine is lit, and the pictures are added up.
std::function<Run()> guided_run(const WhittedSettings& settings) {
    struct Memory {
        gh::app::GuidedPicture guided;
        Film lit;
    };
    return [settings] {
        return [settings, memory = std::make_shared<Memory>()](const Shot& shot, Film& film) {
            const int step = step_of(film);
            const gh::app::PictureShape shape{{film.radiance.width / step, film.radiance.height / step},
                                              step};
            Film& lit = memory->lit;
            if (lit.radiance.width != shape.lit.x || lit.radiance.height != shape.lit.y)
                lit = Film(shape.lit.x, shape.lit.y);
            WhittedSettings jittered = settings;
            const double start = core_ms();
            jittered.jitter =
                memory->guided.begin(shot.scene, shot.camera, settings, shot.frame, shape, shot.jobs);
            jittered.texture_blur = gh::app::GuidedPicture::texture_blur(shape);
            whitted_frame(shot, jittered, lit);
            const double rendered = core_ms();
            memory->guided.add(lit.radiance, shot.jobs);
            film.radiance = memory->guided.picture();
            film.stats = lit.stats;
            return StageTimes{.render_ms = rendered - start, .filter_ms = core_ms() - rendered};
        };
    };
}

// As the game shows it: denoised, and the pictures added up, here lit in every pixel.
std::function<Run()> denoised_run(const PathSettings& settings) {
    struct Memory {
        gh::app::Reshading reshading;
        gh::filter::Plane change;
        gh::app::FilmDenoiser denoiser;
    };
    return [settings] {
        return [settings, memory = std::make_shared<Memory>()](const Shot& shot, Film& film) {
            PathSettings jittered = settings;
            jittered.seed = shot.seed;
            jittered.jitter = gh::filter::halton_jitter(shot.frame);
            const double start = core_ms();
            memory->reshading.ask_again(shot.scene, shot.jobs, memory->change);
            path_frame(shot, jittered, film);
            memory->reshading.note(shot.camera, jittered, shot.frame, film);
            const double rendered = core_ms();
            memory->denoiser.denoise(film, shot.jobs, {.adds_up = true}, &memory->change);
            return StageTimes{.render_ms = rendered - start, .filter_ms = core_ms() - rendered};
        };
    };
}

// What the game's path tracer aims at: fewer bounces, no focused light, bright light clamped. How far that is from all
// the light there is is said apart (kRealTime against "path").
constexpr const char* kRealTime = "real time";

PathSettings unfiltered_real_time() {
    PathSettings settings = gh::render::realtime_path();
    settings.fills_planes = false;
    settings.jitters = true;
    return settings;
}

Contestant in_a_row(const std::string& family, const std::string& truth, int frames,
                    std::function<Run()> begin) {
    return {.name = fmt::format("{}, frame {}", family, frames),
            .family = family,
            .truth = truth,
            .samples_per_pixel = 1,
            .frames = frames,
            .begin = std::move(begin)};
}

}  // namespace

std::vector<Contestant> moving_contestants() {
    std::vector<Contestant> all;
    all.push_back(whitted("whitted", 1, {}));
    all.push_back(in_a_row("whitted, guided", "whitted", 1, guided_run({})));
    all.push_back(path("path, real time, unfiltered", 1, unfiltered_real_time(), kRealTime));
    all.push_back(
        in_a_row("path, real time, denoised", kRealTime, 1, denoised_run(gh::render::realtime_path())));
    return all;
}

std::vector<Contestant> contestants(bool is_quick) {
    std::vector<Contestant> all;
    const std::vector<int> counts = is_quick ? std::vector<int>{1, 4} : std::vector<int>{1, 4, 16, 64};
    for (const int samples : counts) {
        all.push_back(whitted("whitted", samples, {}));
        all.push_back(whitted("whitted alone", samples, {.shares_samples = false}));
        all.push_back(whitted("whitted adaptive .25", samples, {.is_adaptive = true}));
    }
    for (const float contrast : {0.05f, 0.1f, 0.5f}) {
        all.push_back(whitted(fmt::format("whitted adaptive {:.2g}", contrast), 1,
                              {.is_adaptive = true, .contrast = contrast}));
    }
    for (const int samples : counts) {
        all.push_back(path("path, Sobol", samples, {.sampler = SampleKind::Sobol}));
        all.push_back(path("path, blue noise", samples, {.sampler = SampleKind::BlueNoise}));
        all.push_back(path("path, jittered", samples, {.sampler = SampleKind::Jittered}));
        all.push_back(path("path, iid", samples, {.sampler = SampleKind::Iid}));
    }
    for (const int samples : counts)
        all.push_back(path("path, real time, unfiltered", samples, unfiltered_real_time(), kRealTime));
    for (Contestant& filtered : single_filters(unfiltered_real_time(), kRealTime))
        all.push_back(std::move(filtered));
    for (const int frames : {1, 4, 16}) {
        all.push_back(in_a_row("path, real time, denoised", kRealTime, frames,
                               denoised_run(gh::render::realtime_path())));
        all.push_back(in_a_row("whitted, guided", "whitted", frames, guided_run({})));
    }
    return all;
}

Contestant truth_of(const std::string& truth, int samples_per_pixel) {
    if (truth == "path") return path(truth, samples_per_pixel, {});
    if (truth == kRealTime) return path(truth, samples_per_pixel, unfiltered_real_time());
    return whitted(truth, samples_per_pixel, {.min_weight = 1e-4f, .shares_samples = false});
}

}  // namespace speed_error
