// filter/atrous.h - smoothing over the picture by what is known of each pixel's noise and of its surface.
//
// An edge-avoiding a-trous wavelet transform (Dammertz et al. 2010) guided by variance (Schied et al. 2017, equations
// 2-5): level i averages 3x3 (or 5x5) pixels 2^i apart; a neighbour counts less the more its nearness, its normal and,
// measured in standard deviations of the pixel's noise, its luminance differ. Variance is filtered along, so each level
// is surer of what it sees. A pixel without noise, in full light or in full shadow, stays as it is, and sixteen such
// beside each other cost next to nothing.
//
// Cost      per level about 15 cycles a pixel with AVX-512 (3x3), twice that for 5x5. Levels are apart by a barrier.
//           Signals side by side ask a block of 128 pixels by turns, so that how near neighbours are is found out once for
//           all. (All signals of one vector before the next were slower than one
//           after the other: three times as many streams of memory.)
// Threads   rows over all threads. Same bits for any number of them and any instruction set.
// Energy    a weighted mean: a constant stays that constant to 1e-6; between equal surfaces nothing is lost.
// Bad input light and variance are finite and variance is not below 0, as mend(), accumulate() and
//           estimate_variance() leave them; make_signal() sees to it for anybody else's. Guides are always fine.
#pragma once

#include "base/jobs.h"
#include "filter/guides.h"
#include "filter/plane.h"
#include "filter/rows.h"

#include <span>

namespace gh::filter {

// Light to be smoothed and what is known of it.
struct Signal {
    Luma3 light;
    Plane variance;  // of its luminance, as an estimate of the light there

    void fit(int width, int height);
};

// The same, wherever it lives.
struct SignalView {
    const Luma3* light;
    const Plane* variance;
    // How much sooner this signal stops: 1 / (4 * pixels at which it falls to 1/e). Null or empty: 0.
    const Plane* stiffness = nullptr;
    // Which thing gives the light back: others keep theirs to themselves. Null: it does not matter.
    const PlaneU32* part = nullptr;
};
[[nodiscard]] inline SignalView view_of(const Signal& signal) {
    return {&signal.light, &signal.variance};
}

// From light in red, green and blue. What is not finite is mended by its neighbours.
void make_signal(const Plane3& light, const Plane& variance, const Jobs& jobs, Signal& signal);

struct AtrousSettings {
    int levels = 5;                 // reaches 2^levels pixels either way
    int radius = 1;                 // 1: 3x3, 2: 5x5
    float luminance_sigmas = 4.0f;  // by so many standard deviations light may differ (sigma_l of the paper)
};

// One level, from `in` to `out` (made to fit). Of the guides' size.
void atrous_level(const Guides& guides, const SignalView& in, const AtrousSettings& settings, int level,
                  const Jobs& jobs, Signal& out);

// All levels (at least one) of one signal, by turns into the two of `scratch`; returns the one that holds the result.
const Signal& atrous(const Guides& guides, const SignalView& in, const AtrousSettings& settings,
                     const Jobs& jobs, Signal scratch[2]);

// The same of several signals side by side: row by row, so that guides are read once for all and a level finds in the
// cache what the one before has left. The result of each is in scratch[(levels - 1) % 2].
struct Smoothing {
    SignalView in;
    AtrousSettings settings;
    Signal* scratch;              // two
    bool leaves_variance = true;  // otherwise the result's is not to be relied on
};
void atrous(const Guides& guides, std::span<const Smoothing> signals, const Jobs& jobs);
// The same as passes after those that make guides and signals. `signals` must live until they have run.
void add_atrous(const Guides& guides, std::span<const Smoothing> signals, RowPasses& passes);

}  // namespace gh::filter
