// filter/anti_lag.h - forgetting light that has changed, so that a lamp switched off is dark at once.
//
// Two ways, for two kinds of change:
//
// Known change. The renderer knows what the lamps gave last frame, or has shaded some of last frame's samples again.
// Then the share of light that changed is |now - then| / max(now, then) (Schied et al. 2018, "Gradient estimation for
// real-time adaptive temporal filtering", equations 4-6), and accumulate() forgets that share of the past.
//   lamp_change()  both values known at every pixel: a lamp group's light if nothing stood before it, now and then.
//   gradients()    re-shaded samples at some pixels only: their differences and their maxima are smoothed apart over
//                  their neighbours before they are divided, so that noise in them cancels.
//
// Unknown change: what a moving guard shades, what comes over two corners. settle() compares the long means of 5x5 pixels
// with their fast means of two frames. What of the difference their samples' own variance does not explain is change:
// what got darker is made so at once, and the means' counts fall by what of them was wrong. Edges in the light cancel in
// the difference, and a lone bright sample raises the variance with the mean. (In the spirit of the history clamping of
// Karis 2014 and of the fast history of NVIDIA's ReBLUR, but a test of significance, so that it keeps the energy.)
//
// Cost      lamp_change 2, gradients about 60 (of few pixels), settle 5 cycles a pixel.
// Same bits for any number of threads and any instruction set.
// Bad input what is not finite has not changed.
#pragma once

#include "base/jobs.h"
#include "filter/movement.h"
#include "filter/plane.h"
#include "filter/temporal.h"

namespace gh::filter {

// change = |now - then| / max(now, then), in [0, 1]; 0 where both are 0. Of one size; `change` is made to fit.
void lamp_change(const Plane& now, const Plane& then, const Jobs& jobs, Plane& change);

// One re-shaded sample for each block of `side` x `side` pixels, in planes of one number a block: luminance it had and
// luminance it has, same surface point, same random numbers. Both 0: none in this block.
struct Reshaded {
    Plane then, now;
    int side = 3;
};

// `change` gets the picture's size; `width` and `height` lie within the blocks.
void gradients(const Reshaded& samples, int width, int height, const Jobs& jobs, Plane& change);

// `change` of each pixel is what `then`, of the last frame's size, says where it was, times `sharpness`, at most 1; 0 where
// it was nowhere: there is no past to be forgotten.
void carry_change(const Plane& then, const Taps& taps, float sharpness, const Jobs& jobs, Plane& change);
[[nodiscard]] RowWork carry_rows(const Plane& then, const Taps& taps, float sharpness, Plane& change);

struct SettleSettings {
    float sigmas = 2.0f;        // standard errors of the difference that are put down to chance
    float fast_longest = 2.0f;  // what TemporalSettings said when the fast mean was made
};

// Puts `signal` right in place. `scratch` is any two planes to be used meanwhile.
void settle(const SettleSettings& settings, const Jobs& jobs, Accumulated& signal, Plane scratch[2]);
// Its two halves, of which the first asks rows up to kSettleReach away. The second writes where those read. With `only`
// nothing settles but the blocks of columns where something moved by itself: for light of which somebody tells.
inline constexpr int kSettleReach = 2;
[[nodiscard]] RowWork settle_sum_rows(const Accumulated& signal, Plane scratch[2],
                                      const Movement* only = nullptr);
[[nodiscard]] RowWork settle_rows(const SettleSettings& settings, Plane scratch[2], Accumulated& signal,
                                  const Movement* only = nullptr);

}  // namespace gh::filter
