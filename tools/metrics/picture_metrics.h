// metrics/picture_metrics.h - how far a picture is from a reference: as a number for estimators, as an eye sees it.
//
//   rel_mse  for convergence: linear radiance, unbounded, halves when samples double
//   ssim     for structure: what is on a screen, 1 where both are alike
//   flip     for what a viewer who flips between the two notices: 0 nothing ... 1 everything
//
// Pictures  both of one size, at least 1x1. "Shown" ones hold what a screen takes, sRGB-encoded, in [0, 1].
// Cost      rel_mse 1, ssim 50, flip about 500 ns a pixel, on one thread. For reports, not for frames.
// Bad input a number that is not finite counts as 0 and is counted (rel_mse), values outside [0, 1] are clamped (others).
#pragma once

#include "base/image.h"

#include <cstddef>
#include <vector>

namespace metrics {

struct RelMse {
    double all = 0.0;            // mean over pixels and channels of (a - b)^2 / (b^2 + 0.01)
    double trimmed = 0.0;        // the same without the worst thousandth of the pixels: fireflies apart
    std::size_t not_finite = 0;  // pixels of the picture with a NaN or an infinity
};

// Relative mean square error of linear radiance (Rousselle et al. 2011 with the floor of 0.01 that FACTS names).
[[nodiscard]] RelMse rel_mse(const gh::Image& picture, const gh::Image& reference);

// Mean structural similarity of the luma of shown pictures (Wang et al. 2004): Gaussian window of 1.5 pixels over 11x11,
// K1 = 0.01, K2 = 0.03, over all windows that lie within the picture; over the whole picture if none does.
[[nodiscard]] double ssim(const gh::Image& shown, const gh::Image& reference);

// How many pixels one degree of the viewer's sight covers.
[[nodiscard]] double pixels_per_degree(double distance_m, double screen_width_m, int screen_width_px);

// A 0.7 m wide screen of 3840 pixels seen from 0.7 m, the paper's default.
inline constexpr double kUsualPixelsPerDegree = 67.02064327658226;

struct Flip {
    double mean = 0.0;
    std::vector<float> map;  // a pixel each, rows from the top, in [0, 1]
};

// LDR-FLIP (Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astroem, Fairchild: "FLIP: A Difference Evaluator for
// Alternating Images", HPG 2020).
[[nodiscard]] Flip flip(const gh::Image& shown, const gh::Image& reference,
                        double ppd = kUsualPixelsPerDegree);

}  // namespace metrics
