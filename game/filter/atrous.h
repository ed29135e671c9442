// filter/atrous.h - smoothing over the picture by what is known of each pixel's noise and of its surface.
//
// An edge-avoiding a-trous wavelet transform (Dammertz et al. 2010) guided by variance (Schied et al. 2017, equations
// 2-5): level i averages 3x3 (or 5x5) pixels 2^i apart; a neighbour counts less the more its nearness, its normal and,
// measured in standard deviations of the pixel's noise, its luminance differ. Variance is filtered along, so each level
// is surer of what it sees. Where there is no noise, nothing is blurred.
//
// Two signals on the same surfaces are done together: what geometry says is worked out once.
//
// Cost      per level about 15 cycles a pixel for one signal, 25 for two (3x3); 5x5 three times that. Two sets of planes
//           are read and written alternately; levels are apart by a barrier.
// Threads   rows over all threads. Same bits for any number of them and any instruction set.
// Energy    a weighted mean: a constant stays that constant to 1e-6; between equal surfaces nothing is lost.
// Bad input a pixel whose light is not finite counts for nobody and takes the mean of its neighbours; one whose
//           geometry is not finite keeps its light. A variance that is not above 0 is 0.
#pragma once

#include "base/jobs.h"
#include "filter/guides.h"
#include "filter/plane.h"

#include <span>

namespace gh::filter {

// Light to be smoothed and what is known of it.
struct Signal {
    Plane3 light;
    Plane luminance;  // of `light`; atrous() keeps it up
    Plane variance;   // of luminance, as an estimate of the light there
    Plane stiffness;  // how much sooner this signal stops: 1 / (4 * pixels at which it falls to 1/e). Empty: 0

    void fit(int width, int height);
};

struct AtrousSettings {
    int levels = 5;  // reaches 2^levels pixels either way
    int radius = 1;  // 1: 3x3, 2: 5x5
    float luminance_sigmas = 4.0f;  // by so many standard deviations light may differ (sigma_l of the paper)
};

// One level, from `in` to `out` (made to fit; stiffness is not copied). One or two signals of the guides' size.
void atrous_level(const Guides& guides, std::span<const Signal* const> in, const AtrousSettings& settings, int level,
                  const Jobs& jobs, std::span<Signal* const> out);

// All levels of one signal; `scratch` holds every other level.
void atrous(const Guides& guides, const AtrousSettings& settings, const Jobs& jobs, Signal& signal, Signal& scratch);

}  // namespace gh::filter
