// filter/denoiser.h - all stages in their order: one frame's noisy light in, the frame to be shown out.
//
//   filter::Denoiser denoiser;                                  // once; forget() after a cut
//   denoiser.denoise(surfaces, light, {}, jobs, radiance);      // every frame, in order
//
// mend -> demodulate -> reproject -> accumulate -> settle -> variance -> a-trous -> remodulate -> add up. Direct and indirect light
// share reprojection and geometry and are filtered apart; specular light has its own reprojection, by the virtual image,
// and is blurred the less the smoother the surface. What is empty costs nothing.
//
// Cost      at 640x360 with AVX-512 on a busy core 6.5 core-ms for direct light, 11 with indirect, 16 with specular too; by
//           stage see game/README.md. Memory: about 350 bytes a pixel.
// Threads   rows over all threads; a Denoiser belongs to one caller at a time.
// Same bits the result depends on the frames fed since forget() only: not on threads, not on the instruction set.
// Bad input NaN light is mended, NaN geometry makes a pixel keep its own light; neither spreads, in space or in time.
#pragma once

#include "base/jobs.h"
#include "filter/anti_lag.h"
#include "filter/atrous.h"
#include "filter/gbuffer.h"
#include "filter/guides.h"
#include "filter/mend.h"
#include "filter/picture_mean.h"
#include "filter/reproject.h"
#include "filter/temporal.h"

#include <cstddef>
#include <span>

namespace gh::filter {

struct DenoiseSettings {
    MendSettings mend{};
    TemporalSettings temporal{};
    // Levels of 0: not smoothed over the picture.
    AtrousSettings direct{.levels = 2};
    AtrousSettings indirect{.levels = 3, .luminance_sigmas = 8.0f};  // no edges of its own to keep
    AtrousSettings specular{.levels = 2, .luminance_sigmas = 5.0f};
    // So many more, up to five, while nothing is known of the past: still pictures, and the first one after a cut.
    int more_levels_at_first = 2;
    bool settles = true;  // whether unknown changes are looked for
    float settle_sigmas = 2.0f;
    // Light::change_then counts so many times: a little noise for a moment is less to be seen than light that lingers.
    float change_sharpness = 4.0f;
    // Whether pictures are added up at the end (picture_mean.h): for those taken through other places of their pixels.
    bool adds_up = false;
};

class Denoiser {
  public:
    // The next frame is the first: nothing of what was seen counts.
    void forget();

    // What a caller does to each row while it is at hand: `before` may still fill that row of `surfaces` and `light` (whose
    // planes all have their sizes by then), `after` finds that row of `out` made.
    struct Ends {
        RowWork before, after;
    };
    // `out` is made to fit, linear radiance like `light`.
    void denoise(const GBuffer& surfaces, const Light& light, const DenoiseSettings& settings,
                 const Jobs& jobs, Plane3& out, const Ends& ends = {});

    // Samples in the mean of each pixel's direct light, for views of what the filter does.
    [[nodiscard]] const Plane& history_length() const { return direct_.mean.length; }
    // Of that mean, as an estimate.
    [[nodiscard]] const Plane& variance() const { return direct_.variance; }

  private:
    // One of the lights through the frames.
    struct Track {
        Accumulated mean, before;
        Plane variance;
        Plane sums[2];      // while it settles
        Signal scratch[2];  // the a-trous levels by turns; before them, the samples as they are mended
        const Luma3* smooth = nullptr;  // what is shown; null: there is no such light
    };
    struct Step;

    [[nodiscard]] bool asks_change(const Step& step) const;
    void find_past(Motion motion, const Step& step);
    void add_samples(const Plane3& light, const Plane& told, const Plane3& albedo, const Step& step,
                     Track& track);
    void accumulate_tracks(const Step& step);
    void settle_tracks(const Step& step);
    [[nodiscard]] std::size_t smooth_tracks(const Step& step, std::span<Smoothing, 3> all);

    Guides guides_;
    SeenSurfaces seen_;
    Taps taps_;
    Track direct_, indirect_, specular_;
    Plane stiffness_;
    Plane change_;
    Plane3 remade_;  // before pictures are added up
    PictureMean pictures_;
};

}  // namespace gh::filter
