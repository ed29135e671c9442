#include "filter/denoiser.h"

#include "filter/albedo.h"
#include "filter/mend.h"

#include <utility>

namespace gh::filter {

namespace {

constexpr std::size_t kMendingPass = 1;  // of a layer, after what fills the frame

// A level less reaches as far.
void reach_half_as_far(AtrousSettings& settings) {
    if (settings.levels > 1) --settings.levels;
}

// Of what is known of the last frame's light, every second pixel: it is smooth over more.
void halve_change(const Plane& change, const Jobs& jobs, Plane& half) {
    half.fit((change.width() + 1) / 2, (change.height() + 1) / 2);
    run_rows(half.height(), jobs, [&](int y) {
        const float* from = change.row(2 * y);
        float* to = half.row(y);
        for (int x = 0; x < half.width(); ++x) to[x] = from[2 * x];
    });
}

}  // namespace

void Denoiser::forget() {
    *this = Denoiser();
}

// Mended and taken off their colours at full size, and from then on at half the sides.
void Denoiser::add_half(const LightLayer::Frame& whole, RowPasses& passes) {
    const GBuffer& surfaces = whole.surfaces;
    const Light& light = whole.light;
    soft_ = whole.settings;
    reach_half_as_far(soft_.indirect);
    reach_half_as_far(soft_.specular);
    const auto prepare = [&](const Plane3& samples, const Plane3& colour, bool is_halved, Plane3& wide) {
        if (!is_halved) {
            wide = {};
            return;
        }
        passes.add_to(kMendingPass, mend_rows(samples, soft_.mend, &colour, wide));
    };
    prepare(light.indirect, surfaces.albedo, whole.leaves_indirect, wide_indirect_);
    prepare(light.specular, surfaces.gloss, whole.leaves_specular, wide_specular_);
    half_.fit(surfaces, light, wide_indirect_, wide_specular_);
    RowPasses half;
    half.begin(0);
    half.add(halve_rows(surfaces, whole_.guides(), light, wide_indirect_, wide_specular_, half_));
    half_layer_.add_passes(
        {.surfaces = half_.surfaces, .light = half_.light, .settings = soft_, .is_plain = true, .pixels = 2},
        half);
    passes.add_halved(std::move(half), surfaces.height(), kMendingPass + 1);
}

// What was filtered at half the sides, for every pixel, as a pass of its own.
void Denoiser::add_wide(const GBuffer& surfaces, RowPasses& passes) {
    const Widening widening{.light = {half_layer_.indirect(), half_layer_.specular()},
                            .asks_part = {false, true},
                            .out = {&wide_indirect_, &wide_specular_}};
    passes.begin(kWidenReach);
    passes.add(
        widen_rows(widening, half_layer_.guides(), half_.surfaces.part, whole_.guides(), surfaces.part));
}

// Of a frame's lights what is shown, taken off their colours.
Parts Denoiser::add_layers(const GBuffer& surfaces, const Light& light, const DenoiseSettings& settings,
                           const Jobs& jobs, RowPasses& passes) {
    const LightLayer::Frame whole{.surfaces = surfaces,
                                  .light = light,
                                  .settings = settings,
                                  .leaves_indirect = settings.halves_indirect && !light.indirect.empty(),
                                  .leaves_specular = settings.halves_specular && !light.specular.empty()};
    whole_.add_passes(whole, passes);
    Parts parts{.direct = whole_.direct(),
                .indirect = whole_.indirect(),
                .specular = whole_.specular(),
                .clean = &light.clean,
                .gloss = &surfaces.gloss};
    if (!whole.leaves_indirect && !whole.leaves_specular) {
        half_layer_ = {};
        half_ = {};
        passes.begin(0);
        return parts;
    }
    halve_change(light.change_then, jobs, half_.light.change_then);
    add_half(whole, passes);
    add_wide(surfaces, passes);
    if (whole.leaves_indirect) parts.indirect = &wide_indirect_;
    if (whole.leaves_specular) parts.specular = &wide_specular_;
    return parts;
}

void Denoiser::denoise(const GBuffer& surfaces, const Light& light, const DenoiseSettings& settings,
                       const Jobs& jobs, Plane3& out, const Ends& ends) {
    RowPasses passes;
    passes.begin(0);
    passes.add(ends.before);
    const Parts parts = add_layers(surfaces, light, settings, jobs, passes);
    const Plane* change = whole_.change(light);
    if (settings.adds_up) {
        pictures_.add_rows(surfaces, remodulated_rows(parts, surfaces.albedo).work,
                           {change != nullptr ? *change : light.direct_change, whole_.movement()}, passes,
                           out);
    } else {
        passes.add(remodulate_rows(parts, surfaces.albedo, out));
    }
    passes.add(ends.after);
    passes.run(surfaces.height(), jobs);
    settings.adds_up ? pictures_.finish(surfaces) : pictures_.forget();
    whole_.finish(surfaces);
    if (!half_.surfaces.part.empty()) half_layer_.finish(half_.surfaces);
}

}  // namespace gh::filter
