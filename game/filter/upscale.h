// filter/upscale.h - a picture in another size.
//
// Cost      16 pixels read for each written. Rows over all threads; the same bits for any number of them.
// Bad input sizes >= 1. A value that is not finite counts as black, so it does not spread.
#pragma once

#include "base/image.h"
#include "base/jobs.h"

namespace gh::filter {

// Mitchell and Netravali's cubic (B = C = 1/3); for a smaller `out` it widens to cover the pixels it merges.
// Overshoot beyond the values it blends is clamped away: no halo goes dark or bright. A constant stays that constant.
void resample(const Image& in, const Jobs& jobs, Image& out);

// The same for bytes a screen takes, blended as encoded.
void resample(const Image8& in, const Jobs& jobs, Image8& out);

}  // namespace gh::filter
