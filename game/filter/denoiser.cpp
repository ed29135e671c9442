#include "filter/denoiser.h"

#include "filter/albedo.h"
#include "filter/rows.h"
#include "filter/variance.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace gh::filter {

namespace {

constexpr int kMostAtFirst = 5;  // a-trous levels

// How far light off gloss may be blurred, in pixels: the lobe of a surface seen from a few metres widens about so.
float stiffness_of(float roughness) {
    const float pixels = 48.0f * roughness * roughness;
    return pixels > 1e-3f ? 0.25f / pixels : 250.0f;  // NaN stays sharp
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

void Denoiser::accumulate_track(const Plane3& light, const Plane& change, const Plane3& albedo,
                                const Step& step, Track& track) {
    Plane3& samples = track.scratch[0].light;
    mend(light, step.settings.mend, step.jobs, samples);
    demodulate(samples, albedo, step.jobs, samples);
    std::swap(track.before, track.mean);
    accumulate(samples, change, {taps_, track.before}, step.settings.temporal, step.jobs, track.mean);
    if (step.settings.settles) {
        settle({step.settings.settle_sigmas, step.settings.temporal.fast_longest}, step.jobs, track.mean,
               sums_);
    }
    estimate_variance(track.mean, step.jobs, track.variance);
    track.smooth = &track.mean.light;
}

// All lights side by side, for they ask the same guides.
void Denoiser::smooth_tracks(const Step& step) {
    std::array<Smoothing, 3> all;
    std::size_t count = 0;
    const int more = seen_.part.empty() ? step.settings.more_levels_at_first : 0;
    const auto add = [&](Track& track, AtrousSettings settings) {
        if (track.smooth == nullptr || settings.levels == 0) return;
        settings.levels = std::max(settings.levels, std::min(settings.levels + more, kMostAtFirst));
        all[count++] = {{&track.mean.light, &track.variance}, settings, track.scratch};
        track.smooth = &track.scratch[(settings.levels - 1) % 2].light;
    };
    add(direct_, step.settings.direct);
    add(indirect_, step.settings.indirect);
    if (specular_.smooth != nullptr && !step.surfaces.roughness.empty())
        make_stiffness(step.surfaces.roughness, step.jobs, stiffness_);
    add(specular_, step.settings.specular);
    if (specular_.smooth != nullptr && step.settings.specular.levels > 0) {
        all[count - 1].in.stiffness = step.surfaces.roughness.empty() ? nullptr : &stiffness_;
        all[count - 1].in.part = &step.surfaces.part;
    }
    atrous(guides_, std::span(all).first(count), step.jobs);
}

void Denoiser::denoise(const GBuffer& surfaces, const Light& light, const DenoiseSettings& settings,
                       const Jobs& jobs, Plane3& out) {
    const Step step{surfaces, settings, jobs};
    const bool has_direct = !light.direct.empty(), has_indirect = !light.indirect.empty();
    const bool has_specular = !light.specular.empty();
    // A light that pauses has no past when it comes back.
    if (!has_direct) direct_ = {};
    if (!has_indirect) indirect_ = {};
    if (!has_specular) specular_ = {};

    make_guides(surfaces, jobs, guides_);
    if (has_direct || has_indirect) reproject(surfaces, guides_, seen_, Motion::OfSurface, jobs, taps_);
    const bool is_asked = !light.change_then.empty() && light.change_then.width() == seen_.part.width() &&
                          light.change_then.height() == seen_.part.height();
    const auto change = [&](const Plane& told) -> const Plane& {
        if (is_asked) carry_change(light.change_then, taps_, settings.change_sharpness, jobs, change_);
        return is_asked ? change_ : told;
    };
    if (has_direct)
        accumulate_track(light.direct, change(light.direct_change), surfaces.albedo, step, direct_);
    if (has_indirect)
        accumulate_track(light.indirect, change(light.indirect_change), surfaces.albedo, step, indirect_);
    if (has_specular) {
        reproject(surfaces, guides_, seen_, Motion::OfReflection, jobs, taps_);
        accumulate_track(light.specular, change(light.direct_change), surfaces.gloss, step, specular_);
    }
    smooth_tracks(step);
    remodulate({.direct = direct_.smooth,
                .indirect = indirect_.smooth,
                .specular = specular_.smooth,
                .clean = &light.clean,
                .gloss = &surfaces.gloss},
               surfaces.albedo, jobs, out);

    seen_.lens = surfaces.lens;
    seen_.part = surfaces.part;
    std::swap(seen_.guides, guides_);
}

}  // namespace gh::filter
