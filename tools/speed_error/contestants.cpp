#include "contestants.h"

#include "render/path_tracer.h"
#include "render/whitted.h"

#include <fmt/format.h>

namespace speed_error {

namespace {

using gh::render::WhittedSettings;

Contestant whitted(const std::string& family, int samples, WhittedSettings settings) {
    settings.samples_per_pixel = samples;
    return {.name = fmt::format("{}, {} spp", family, samples),
            .family = family,
            .truth = "whitted",
            .samples_per_pixel = samples,
            .render = [settings](const auto& scene, const auto& camera, std::uint32_t seed, const auto& jobs,
                                 auto& film) {
                gh::render::render_whitted(scene, camera, settings, seed, jobs, film);
            }};
}

Contestant path(const std::string& family, const std::string& truth, int samples,
                gh::render::PathSettings settings) {
    settings.samples_per_pixel = samples;
    return {.name = fmt::format("{}, {} spp", family, samples),
            .family = family,
            .truth = truth,
            .samples_per_pixel = samples,
            .render = [settings](const auto& scene, const auto& camera, std::uint32_t seed, const auto& jobs,
                                 auto& film) {
                gh::render::PathSettings seeded = settings;
                seeded.seed = seed;
                gh::render::render_path(scene, camera, seeded, 0, jobs, film);
            }};
}

}  // namespace

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
    using gh::render::SampleKind;
    for (const int samples : counts) {
        all.push_back(path("path, Sobol", "path", samples, {.sampler = SampleKind::Sobol}));
        all.push_back(path("path, blue noise", "path", samples, {.sampler = SampleKind::BlueNoise}));
        all.push_back(path("path, jittered", "path", samples, {.sampler = SampleKind::Jittered}));
        all.push_back(path("path, iid", "path", samples, {.sampler = SampleKind::Iid}));
    }
    return all;
}

Contestant truth_of(const std::string& truth, int samples_per_pixel) {
    if (truth == "path") return path(truth, truth, samples_per_pixel, {});
    return whitted(truth, samples_per_pixel, {.min_weight = 1e-4f, .shares_samples = false});
}

}  // namespace speed_error
