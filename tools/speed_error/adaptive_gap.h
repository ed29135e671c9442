// speed_error/adaptive_gap.h - what adaptive subsampling leaves out: the same picture, with the same random numbers, with
// every pixel's light worked out and with most of them blended from others.
#pragma once

#include "findings.h"
#include "studio.h"

#include <vector>

namespace speed_error {

// At 640x360, for several thresholds of contrast. FLIP below .02 is the aim; the row "another seed" is full sampling
// again with other random numbers: what noise alone makes of it.
[[nodiscard]] std::vector<Finding> adaptive_gaps(const View& view, const gh::Jobs& jobs);

}  // namespace speed_error
