#include "filter/denoiser.h"

#include "filter/albedo.h"
#include "filter/rows.h"
#include "filter/variance.h"

#include <utility>

namespace gh::filter {

namespace {

// The means of one and the next level trade places; what belongs to both stays.
void swap_levels(Signal& a, Signal& b) {
    std::swap(a.light, b.light);
    std::swap(a.luminance, b.luminance);
    std::swap(a.variance, b.variance);
}

// How far light off gloss may be blurred, in pixels: the lobe of a surface seen from a few metres widens about so.
float stiffness_of(float roughness) {
    const float pixels = 48.0f * roughness * roughness;
    return 0.25f / std::max(pixels, 1e-3f);
}

void make_stiffness(const Plane& roughness, const Jobs& jobs, Plane& stiffness) {
    stiffness.fit(roughness.width(), roughness.height());
    run_rows(roughness.height(), jobs, [&](int y) {
        const float* from = roughness.row(y);
        float* to = stiffness.row(y);
        for (int x = 0; x < roughness.width(); ++x) to[x] = stiffness_of(from[x]);
    });
}

}  // namespace

struct Denoiser::Step {
    const GBuffer& surfaces;
    const DenoiseSettings& settings;
    const Jobs& jobs;
};

void Denoiser::forget() {
    *this = Denoiser();
}

void Denoiser::accumulate_track(const Plane3& light, const Plane& change, const Taps& taps, const Step& step,
                                Track& track) {
    accumulate(light, change, taps, track.history, step.settings.temporal, step.jobs, track.mean);
    if (step.settings.settles) settle(step.settings.settle, step.jobs, track.mean, sums_);
    remember(track.mean, step.jobs, track.history);
    estimate_variance(track.mean, guides_, step.jobs, track.signal.variance);
    std::swap(track.signal.light, track.mean.light);
    std::swap(track.signal.luminance, track.mean.luminance);
}

void Denoiser::smooth_diffuse(const Step& step, bool has_direct, bool has_indirect) {
    const int direct_levels = has_direct ? step.settings.direct.levels : 0;
    const int indirect_levels = has_indirect ? step.settings.indirect.levels : 0;
    for (int level = 0; level < std::max(direct_levels, indirect_levels); ++level) {
        const bool both = level < std::min(direct_levels, indirect_levels) &&
                          step.settings.direct.radius == step.settings.indirect.radius &&
                          step.settings.direct.luminance_sigmas == step.settings.indirect.luminance_sigmas;
        if (both) {
            const Signal* in[] = {&direct_.signal, &indirect_.signal};
            Signal* out[] = {&direct_.scratch, &indirect_.scratch};
            atrous_level(guides_, in, step.settings.direct, level, step.jobs, out);
        }
        const auto one = [&](Track& track, const AtrousSettings& settings, int levels) {
            if (level >= levels) return;
            const Signal* in[] = {&track.signal};
            Signal* out[] = {&track.scratch};
            if (!both) atrous_level(guides_, in, settings, level, step.jobs, out);
            swap_levels(track.signal, track.scratch);
        };
        one(direct_, step.settings.direct, direct_levels);
        one(indirect_, step.settings.indirect, indirect_levels);
    }
}

void Denoiser::smooth_specular(const Step& step) {
    Plane& stiffness = specular_.signal.stiffness;
    if (step.surfaces.roughness.empty()) {
        stiffness = Plane();
    } else {
        make_stiffness(step.surfaces.roughness, step.jobs, stiffness);
    }
    atrous(guides_, step.settings.specular, step.jobs, specular_.signal, specular_.scratch);
}

void Denoiser::denoise(const GBuffer& surfaces, const Light& light, const DenoiseSettings& settings, const Jobs& jobs,
                       Plane3& out) {
    const Step step{surfaces, settings, jobs};
    const bool has_direct = !light.direct.empty(), has_indirect = !light.indirect.empty();
    const bool has_specular = !light.specular.empty();
    // A light that pauses has no past when it comes back.
    if (!has_direct) direct_ = {};
    if (!has_indirect) indirect_ = {};
    if (!has_specular) specular_ = {};
    make_guides(surfaces, jobs, guides_);

    const auto prepare = [&](const Plane3& from, Track& track, bool has_albedo) {
        mend(from, settings.mend, jobs, track.mended);
        if (has_albedo) demodulate(track.mended, surfaces.albedo, jobs, track.mended);
    };
    if (has_direct || has_indirect) {
        reproject(surfaces, seen_, Motion::OfSurface, jobs, taps_);
    }
    if (has_direct) {
        prepare(light.direct, direct_, true);
        accumulate_track(direct_.mended, light.direct_change, taps_, step, direct_);
    }
    if (has_indirect) {
        prepare(light.indirect, indirect_, true);
        accumulate_track(indirect_.mended, light.indirect_change, taps_, step, indirect_);
    }
    if (has_specular) {
        prepare(light.specular, specular_, false);
        reproject(surfaces, seen_, Motion::OfReflection, jobs, reflected_taps_);
        accumulate_track(specular_.mended, light.direct_change, reflected_taps_, step, specular_);
    }
    remember(surfaces, jobs, seen_);

    smooth_diffuse(step, has_direct, has_indirect);
    if (has_specular) smooth_specular(step);
    remodulate({.direct = has_direct ? &direct_.signal.light : nullptr,
                .indirect = has_indirect ? &indirect_.signal.light : nullptr,
                .specular = has_specular ? &specular_.signal.light : nullptr,
                .clean = &light.clean},
               surfaces.albedo, jobs, out);
}

}  // namespace gh::filter
