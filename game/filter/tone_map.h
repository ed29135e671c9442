// filter/tone_map.h - from scene-referred radiance to what a screen shows, and the eye that adapts in between.
//
// Same bits pure functions of their arguments; rows are independent, so any number of threads gives the same bytes.
// Bad input a NaN pixel comes out black, an infinite one white; neither touches its neighbours or the exposure.
#pragma once

#include "base/image.h"
#include "base/jobs.h"

#include <cstdint>

namespace gh::filter {

// The exposure, radiance -> display, for the picture's logarithmic mean. It goes with the root of the light only, so
// that a dark room looks dark, and is bounded, so that darkness stays dark and a lamp held before the eye does not
// blind. An empty or all-black picture asks for the upper bound.
[[nodiscard]] float metered_exposure(const Image& picture);

// One step of an eye that follows metered_exposure: towards brightness within about 0.3 s, towards darkness within
// about 2 s. `previous` > 0.
[[nodiscard]] float adapted_exposure(const Image& picture, float previous, float seconds);

// Display-linear value in [0, 1) for exposed radiance x >= 0: straight in the darks, a soft shoulder in the lights.
// Monotonic; curve(0) == 0.
[[nodiscard]] float film_curve(float x);

// The sRGB transfer function and its inverse (IEC 61966-2-1), on [0, 1].
[[nodiscard]] float srgb_from_linear(float linear);
[[nodiscard]] float linear_from_srgb(float encoded);

// Exposes, bends, encodes, and rounds with an ordered dither of half a step that turns with `frame`, so that dark
// gradients do not band. `out` is made to fit, RGB; a colour too bright for the screen goes towards white, not to a
// corner of the gamut.
void tone_map(const Image& picture, float exposure, std::uint32_t frame, const Jobs& jobs, Image8& out);

}  // namespace gh::filter
