#include "contestants.h"

#include "app/film_denoiser.h"
#include "app/reshading.h"
#include "clocks.h"
#include "filter/temporal_upscale.h"
#include "render/path_tracer.h"
#include "render/whitted.h"

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

void whitted_frame(const Shot& shot, const WhittedSettings& settings, Film& film) {
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

// As the game shows it: a picture of half the width and height, jittered and added up in the large one.
std::function<Run()> upscaled_run(const WhittedSettings& settings) {
    struct Memory {
        gh::filter::TemporalUpscaler upscaler;
        Film small;
    };
    return [settings] {
        return [settings, memory = std::make_shared<Memory>()](const Shot& shot, Film& film) {
            const int width = film.radiance.width, height = film.radiance.height;
            Film& small = memory->small;
            if (small.radiance.width != (width + 1) / 2 || small.radiance.height != (height + 1) / 2)
                small = Film((width + 1) / 2, (height + 1) / 2);
            WhittedSettings jittered = settings;
            jittered.jitter = gh::filter::halton_jitter(shot.frame);
            jittered.notes_things = true;
            const double start = core_ms();
            whitted_frame(shot, jittered, small);
            const double rendered = core_ms();
            memory->upscaler.add(gh::app::jittered_frame(small, shot.camera, jittered.jitter),
                                 {width, height}, shot.jobs, film.radiance);
            film.stats = small.stats;
            return StageTimes{.render_ms = rendered - start, .filter_ms = core_ms() - rendered};
        };
    };
}

// As the game shows it: denoised, and the pictures added up, here to the size they have.
std::function<Run()> denoised_run(const PathSettings& settings) {
    struct Memory {
        gh::app::Reshading reshading;
        gh::filter::Plane change;
        gh::app::FilmDenoiser denoiser;
        gh::filter::TemporalUpscaler upscaler;
        gh::Image added_up;
    };
    return [settings] {
        return [settings, memory = std::make_shared<Memory>()](const Shot& shot, Film& film) {
            PathSettings jittered = settings;
            jittered.jitter = gh::filter::halton_jitter(shot.frame);
            jittered.seed = shot.seed;
            const double start = core_ms();
            memory->reshading.ask_again(shot.scene, shot.jobs, memory->change);
            path_frame(shot, jittered, film);
            memory->reshading.note(shot.camera, jittered, shot.frame, film);
            const double rendered = core_ms();
            memory->denoiser.denoise(film, shot.jobs, {}, memory->change);
            memory->upscaler.add(gh::app::jittered_frame(film, shot.camera, jittered.jitter),
                                 {film.radiance.width, film.radiance.height}, shot.jobs, memory->added_up);
            std::swap(film.radiance, memory->added_up);
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
    all.push_back(in_a_row("whitted adaptive, upscaled", "whitted", 1, upscaled_run({.is_adaptive = true})));
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
    for (const int frames : {1, 4, 16}) {
        all.push_back(in_a_row("path, real time, denoised", kRealTime, frames,
                               denoised_run(gh::render::realtime_path())));
        all.push_back(
            in_a_row("whitted adaptive, upscaled", "whitted", frames, upscaled_run({.is_adaptive = true})));
    }
    return all;
}

Contestant truth_of(const std::string& truth, int samples_per_pixel) {
    if (truth == "path") return path(truth, samples_per_pixel, {});
    if (truth == kRealTime) return path(truth, samples_per_pixel, unfiltered_real_time());
    return whitted(truth, samples_per_pixel, {.min_weight = 1e-4f, .shares_samples = false});
}

}  // namespace speed_error
