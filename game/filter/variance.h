// filter/variance.h - how uncertain each pixel's accumulated light is.
//
// With four samples or more: the variance of its own samples' luminance, over their number. With fewer: the variance of
// the luminance of 25 pixels on the same surface, two apart, over that number too (Schied et al. 2017, section 4.2, who
// use 7x7 and leave out the division: their weights so stay wide for ever, ours close as the mean becomes sure).
//
// Cost      1 cycle a pixel; 50 more where history is short.
// Same bits for any number of threads and any instruction set.
#pragma once

#include "base/jobs.h"
#include "filter/guides.h"
#include "filter/temporal.h"

namespace gh::filter {

// `variance` is made to fit.
void estimate_variance(const Accumulated& signal, const Guides& guides, const Jobs& jobs, Plane& variance);

}  // namespace gh::filter
