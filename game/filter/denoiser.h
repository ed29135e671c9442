// filter/denoiser.h - all stages in their order: one frame's noisy light in, the frame to be shown out.
//
//   filter::Denoiser denoiser;                                  // once; forget() after a cut
//   denoiser.denoise(surfaces, light, {}, jobs, radiance);      // every frame, in order
//
// mend -> demodulate -> reproject -> accumulate -> settle -> variance -> a-trous -> remodulate -> add up. Direct and indirect
// light share reprojection and geometry and are filtered apart; specular light has its own reprojection, by the virtual
// image, and is blurred the less the smoother the surface. Indirect and specular light may be filtered at half the sides
// (halve.h). What is empty costs nothing.
//
// Cost      at 640x360 with AVX-512 on a busy core 6.5 core-ms for direct light, 11 with indirect, 16 with specular too,
//           13 with those two halved; 2.6 more to add up; by stage see README.md. Memory: about 350 bytes a pixel.
// Threads   rows over all threads; a Denoiser belongs to one caller at a time.
// Same bits the result depends on the frames fed since forget() only: not on threads, not on the instruction set.
// Bad input NaN light is mended, NaN geometry makes a pixel keep its own light; neither spreads, in space or in time.
#pragma once

#include "base/jobs.h"
#include "filter/albedo.h"
#include "filter/denoise_settings.h"
#include "filter/gbuffer.h"
#include "filter/halve.h"
#include "filter/light_layer.h"
#include "filter/picture_mean.h"
#include "filter/rows.h"

namespace gh::filter {

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
    [[nodiscard]] const Plane& history_length() const { return whole_.history_length(); }
    // Of that mean, as an estimate.
    [[nodiscard]] const Plane& variance() const { return whole_.variance(); }

  private:
    void add_half(const LightLayer::Frame& whole, RowPasses& passes);
    void add_wide(const GBuffer& surfaces, RowPasses& passes);
    [[nodiscard]] Parts add_layers(const GBuffer& surfaces, const Light& light,
                                   const DenoiseSettings& settings, const Jobs& jobs, RowPasses& passes);

    LightLayer whole_, half_layer_;
    Halved half_;                          // what half_layer_ is given
    DenoiseSettings soft_;                 // and how
    Luma3 wide_indirect_, wide_specular_;  // first as they are mended, then what came of them
    PictureMean pictures_;
};

}  // namespace gh::filter
