// filter/variance.h - how uncertain each pixel's accumulated light is.
//
// With four samples or more: the variance of its own samples' luminance, over their number. With fewer: the variance of
// the luminance of 25 pixels around, two apart, doubled, over that number too (Schied et al. 2017, section 4.2, who use
// 7x7 and leave out the division: their weights so stay wide for ever, ours close as the mean becomes sure). Whether those
// pixels are of one surface is not asked: that took four times as long and gained nothing.
//
// Cost      1 cycle a pixel; 15 more where history is short.
// Same bits for any number of threads and any instruction set.
#pragma once

#include "base/jobs.h"
#include "filter/temporal.h"

namespace gh::filter {

// `variance` is made to fit.
void estimate_variance(const Accumulated& signal, const Jobs& jobs, Plane& variance);
// Asks rows up to kVarianceReach away.
inline constexpr int kVarianceReach = 4;
[[nodiscard]] RowWork variance_rows(const Accumulated& signal, Plane& variance);

}  // namespace gh::filter
