// tests/filter/planes.h - planes whose content is known, for the tests of single stages.
#pragma once

#include "base/jobs.h"
#include "filter/guides.h"
#include "filter/plane.h"
#include "filter/reproject.h"

#include <cstdint>

namespace gh::test {

// Each number of each pixel even in [0, 1), by itself.
[[nodiscard]] filter::Plane3 noise(int width, int height, std::uint64_t seed);
[[nodiscard]] double mean_of(const filter::Plane& plane);
// Over all pixels and colours; not a number if anything is.
[[nodiscard]] float largest_difference(const filter::Plane3& a, const filter::Plane3& b);

// A wall straight ahead at distance 2, its right half at distance 3: as surfaces, one picture high or twice that.
[[nodiscard]] filter::GBuffer stepped_wall(int width, int height);
[[nodiscard]] filter::Guides guides_of(const filter::GBuffer& surfaces);
// Where that wall finds its past when neither it nor the eye moves.
[[nodiscard]] filter::Taps taps_of_still_wall(int width, int height, const Jobs& jobs);

}  // namespace gh::test
