#include "filter/light_layer.h"

#include "filter/mend.h"
#include "filter/variance.h"

#include <algorithm>
#include <span>
#include <utility>

namespace gh::filter {

namespace {

constexpr int kMostAtFirst = 5;  // a-trous levels

// How far light off gloss may be blurred, in pixels: the lobe of a surface seen from a few metres widens about so.
float stiffness_of(float roughness, float side) {
    const float pixels = 48.0f * roughness * roughness;
    return pixels > 1e-3f ? 0.25f * side / pixels : 250.0f;  // NaN stays sharp
}

RowWork stiffness_rows(const Plane& roughness, int side, Plane& stiffness) {
    stiffness.fit(roughness.width(), roughness.height());
    return [&roughness, side = static_cast<float>(side), &stiffness](int y) {
        const float* from = roughness.row(y);
        float* to = stiffness.row(y);
        for (int x = 0; x < roughness.width(); ++x) to[x] = stiffness_of(from[x], side);
    };
}

bool has_indirect(const LightLayer::Frame& frame) {
    return !frame.leaves_indirect && !frame.light.indirect.empty();
}
bool has_specular(const LightLayer::Frame& frame) {
    return !frame.leaves_specular && !frame.light.specular.empty();
}

RowWork copying_rows(const PlaneU32& from, PlaneU32& to) {
    to.fit(from.width(), from.height());
    return [&from, &to](int y) { std::copy_n(from.row(y), from.width(), to.row(y)); };
}

}  // namespace

void LightLayer::add_samples(const Plane3& light, const Plane& told, const Plane3& albedo, const Frame& frame,
                             RowPasses& passes, Track& track) {
    const Plane3* samples = &light;
    if (!frame.is_plain) {
        Plane3& mended = track.scratch[0].light;
        passes.add(mend_rows(light, frame.settings.mend, &albedo, mended));
        samples = &mended;
    }
    std::swap(track.before, track.mean);
    const Plane& change = asks_change(frame.light) ? change_ : told;
    passes.add(accumulate_rows(*samples, change, {taps_, track.before}, frame.settings.temporal, track.mean));
    track.smooth = &track.mean.light;
}

bool LightLayer::asks_change(const Light& light) const {
    const Plane& then = light.change_then;
    return !then.empty() && then.width() == seen_.part.width() && then.height() == seen_.part.height();
}

// Where each pixel was, for the lights whose samples are added next.
void LightLayer::find_past(Motion motion, const Frame& frame, RowPasses& passes) {
    const bool leaves = motion == Motion::OfSurface && !seen_.part.empty();
    has_movement_ = has_movement_ || leaves;
    passes.add(reproject_rows(frame.surfaces, guides_, seen_, motion, taps_, leaves ? &movement_ : nullptr));
    if (asks_change(frame.light))
        passes.add(carry_rows(frame.light.change_then, taps_, frame.settings.change_sharpness, change_));
}

// What light each pixel has by now, from its samples and its past.
void LightLayer::accumulate_tracks(const Frame& frame, RowPasses& passes) {
    const GBuffer& surfaces = frame.surfaces;
    const Light& light = frame.light;
    const bool has_direct = !light.direct.empty();
    has_movement_ = false;
    passes.begin(frame.is_plain ? 0 : kMendReach);
    passes.add(guide_rows(surfaces, guides_));
    passes.add(copying_rows(surfaces.part, part_));
    if (has_direct || has_indirect(frame)) find_past(Motion::OfSurface, frame, passes);
    if (has_direct) add_samples(light.direct, light.direct_change, surfaces.albedo, frame, passes, direct_);
    if (has_indirect(frame))
        add_samples(light.indirect, light.indirect_change, surfaces.albedo, frame, passes, indirect_);
    if (!has_specular(frame)) return;
    find_past(Motion::OfReflection, frame, passes);
    add_samples(light.specular, light.direct_change, surfaces.gloss, frame, passes, specular_);
    if (!surfaces.roughness.empty()) passes.add(stiffness_rows(surfaces.roughness, frame.pixels, stiffness_));
}

// How far each is right, and how sure.
void LightLayer::settle_tracks(const Frame& frame, RowPasses& passes) {
    const DenoiseSettings& how = frame.settings;
    const auto for_all = [&](auto work) {
        for (Track* track : {&direct_, &indirect_, &specular_}) {
            if (track->smooth != nullptr) passes.add(work(*track));
        }
    };
    if (how.settles) {
        const SettleSettings settings{how.settle_sigmas, how.temporal.fast_longest};
        // Paths that are asked again tell of all light but that on what moves by itself.
        const Movement* const only = asks_change(frame.light) ? movement() : nullptr;
        passes.begin(kSettleReach);
        for_all([&](Track& track) { return settle_sum_rows(track.mean, track.sums, only); });
        passes.begin(kSettleReach);
        for_all([&](Track& track) { return settle_rows(settings, track.sums, track.mean, only); });
    }
    passes.begin(kVarianceReach);
    for_all([](Track& track) { return variance_rows(track.mean, track.variance); });
}

// All lights side by side, for they ask the same guides.
void LightLayer::smooth_tracks(const Frame& frame, RowPasses& passes) {
    const DenoiseSettings& how = frame.settings;
    std::size_t count = 0;
    const int more = seen_.part.empty() ? how.more_levels_at_first : 0;
    const auto add = [&](Track& track, AtrousSettings settings) {
        if (track.smooth == nullptr || settings.levels == 0) return;
        settings.levels = std::max(settings.levels, std::min(settings.levels + more, kMostAtFirst));
        smoothing_[count++] = {{&track.mean.light, &track.variance}, settings, track.scratch, false};
        track.smooth = &track.scratch[(settings.levels - 1) % 2].light;
    };
    add(direct_, how.direct);
    add(indirect_, how.indirect);
    add(specular_, how.specular);
    if (specular_.smooth != nullptr && how.specular.levels > 0) {
        smoothing_[count - 1].in.stiffness = frame.surfaces.roughness.empty() ? nullptr : &stiffness_;
        smoothing_[count - 1].in.part = &frame.surfaces.part;
    }
    add_atrous(guides_, std::span(smoothing_).first(count), passes);
}

void LightLayer::add_passes(const Frame& frame, RowPasses& passes) {
    // A light that pauses has no past when it comes back.
    if (frame.light.direct.empty()) direct_ = {};
    if (!has_indirect(frame)) indirect_ = {};
    if (!has_specular(frame)) specular_ = {};
    accumulate_tracks(frame, passes);
    settle_tracks(frame, passes);
    smooth_tracks(frame, passes);
}

void LightLayer::finish(const GBuffer& surfaces) {
    seen_.lens = surfaces.lens;
    std::swap(seen_.part, part_);
    std::swap(seen_.guides, guides_);
    if (has_movement_) movement_.finish();
}

}  // namespace gh::filter
