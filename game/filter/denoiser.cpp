#include "filter/denoiser.h"

#include "filter/albedo.h"
#include "filter/rows.h"
#include "filter/variance.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gh::filter {

namespace {

constexpr int kMostAtFirst = 5;  // a-trous levels

// How far light off gloss may be blurred, in pixels: the lobe of a surface seen from a few metres widens about so.
float stiffness_of(float roughness) {
    const float pixels = 48.0f * roughness * roughness;
    return pixels > 1e-3f ? 0.25f / pixels : 250.0f;  // NaN stays sharp
}

RowWork stiffness_rows(const Plane& roughness, Plane& stiffness) {
    stiffness.fit(roughness.width(), roughness.height());
    return [&roughness, &stiffness](int y) {
        const float* from = roughness.row(y);
        float* to = stiffness.row(y);
        for (int x = 0; x < roughness.width(); ++x) to[x] = stiffness_of(from[x]);
    };
}

}  // namespace

struct Denoiser::Step {
    const GBuffer& surfaces;
    const Light& light;
    const DenoiseSettings& settings;
    RowPasses& passes;
};

void Denoiser::forget() {
    *this = Denoiser();
}

void Denoiser::add_samples(const Plane3& light, const Plane& told, const Plane3& albedo, const Step& step,
                           Track& track) {
    Plane3& samples = track.scratch[0].light;
    step.passes.add(mend_rows(light, step.settings.mend, samples));
    step.passes.add(demodulate_rows(samples, albedo, samples));
    std::swap(track.before, track.mean);
    const Plane& change = asks_change(step) ? change_ : told;
    step.passes.add(
        accumulate_rows(samples, change, {taps_, track.before}, step.settings.temporal, track.mean));
    track.smooth = &track.mean.light;
}

bool Denoiser::asks_change(const Step& step) const {
    const Plane& then = step.light.change_then;
    return !then.empty() && then.width() == seen_.part.width() && then.height() == seen_.part.height();
}

// Where each pixel was, for the lights whose samples are added next.
void Denoiser::find_past(Motion motion, const Step& step) {
    step.passes.add(reproject_rows(step.surfaces, guides_, seen_, motion, taps_));
    if (asks_change(step))
        step.passes.add(carry_rows(step.light.change_then, taps_, step.settings.change_sharpness, change_));
}

// What light each pixel has by now, from its samples and its past.
void Denoiser::accumulate_tracks(const Step& step) {
    const GBuffer& surfaces = step.surfaces;
    const Light& light = step.light;
    const bool has_direct = !light.direct.empty(), has_indirect = !light.indirect.empty();
    step.passes.begin(kMendReach);
    step.passes.add(guide_rows(surfaces, guides_));
    if (has_direct || has_indirect) find_past(Motion::OfSurface, step);
    if (has_direct) add_samples(light.direct, light.direct_change, surfaces.albedo, step, direct_);
    if (has_indirect) add_samples(light.indirect, light.indirect_change, surfaces.albedo, step, indirect_);
    if (light.specular.empty()) return;
    find_past(Motion::OfReflection, step);
    add_samples(light.specular, light.direct_change, surfaces.gloss, step, specular_);
    if (!surfaces.roughness.empty()) step.passes.add(stiffness_rows(surfaces.roughness, stiffness_));
}

// How far each is right, and how sure.
void Denoiser::settle_tracks(const Step& step) {
    const auto for_all = [&](auto work) {
        for (Track* track : {&direct_, &indirect_, &specular_}) {
            if (track->smooth != nullptr) step.passes.add(work(*track));
        }
    };
    if (step.settings.settles) {
        const SettleSettings settings{step.settings.settle_sigmas, step.settings.temporal.fast_longest};
        step.passes.begin(kSettleReach);
        for_all([](Track& track) { return settle_sum_rows(track.mean, track.sums); });
        step.passes.begin(kSettleReach);
        for_all([&](Track& track) { return settle_rows(settings, track.sums, track.mean); });
    }
    step.passes.begin(kVarianceReach);
    for_all([](Track& track) { return variance_rows(track.mean, track.variance); });
}

// All lights side by side, for they ask the same guides.
std::size_t Denoiser::smooth_tracks(const Step& step, std::span<Smoothing, 3> all) {
    std::size_t count = 0;
    const int more = seen_.part.empty() ? step.settings.more_levels_at_first : 0;
    const auto add = [&](Track& track, AtrousSettings settings) {
        if (track.smooth == nullptr || settings.levels == 0) return;
        settings.levels = std::max(settings.levels, std::min(settings.levels + more, kMostAtFirst));
        all[count++] = {{&track.mean.light, &track.variance}, settings, track.scratch, false};
        track.smooth = &track.scratch[(settings.levels - 1) % 2].light;
    };
    add(direct_, step.settings.direct);
    add(indirect_, step.settings.indirect);
    add(specular_, step.settings.specular);
    if (specular_.smooth != nullptr && step.settings.specular.levels > 0) {
        all[count - 1].in.stiffness = step.surfaces.roughness.empty() ? nullptr : &stiffness_;
        all[count - 1].in.part = &step.surfaces.part;
    }
    return count;
}

void Denoiser::denoise(const GBuffer& surfaces, const Light& light, const DenoiseSettings& settings,
                       const Jobs& jobs, Plane3& out, const Ends& ends) {
    RowPasses passes;
    if (ends.before) {
        passes.begin(0);
        passes.add(ends.before);
    }
    const Step step{surfaces, light, settings, passes};
    // A light that pauses has no past when it comes back.
    if (light.direct.empty()) direct_ = {};
    if (light.indirect.empty()) indirect_ = {};
    if (light.specular.empty()) specular_ = {};

    std::array<Smoothing, 3> all;
    accumulate_tracks(step);
    settle_tracks(step);
    const std::size_t count = smooth_tracks(step, all);
    add_atrous(guides_, std::span(all).first(count), passes);
    const Plane& known_change = asks_change(step) ? change_ : light.direct_change;
    Plane3& remade = settings.adds_up ? remade_ : out;
    passes.begin(0);
    passes.add(remodulate_rows({.direct = direct_.smooth,
                                .indirect = indirect_.smooth,
                                .specular = specular_.smooth,
                                .clean = &light.clean,
                                .gloss = &surfaces.gloss},
                               surfaces.albedo, remade));
    if (settings.adds_up) pictures_.add_rows(surfaces, remade, known_change, passes, out);
    passes.add(ends.after);
    passes.run(surfaces.height(), jobs);
    settings.adds_up ? pictures_.finish(surfaces) : pictures_.forget();

    seen_.lens = surfaces.lens;
    seen_.part = surfaces.part;
    std::swap(seen_.guides, guides_);
}

}  // namespace gh::filter
