// filter/mend.h - the door noisy light comes in by: what is not a number is replaced, what is absurdly bright clamped.
//
// A firefly is one sample that stands for many: unbiased, and a flashing blob to whoever watches. A pixel brighter than
// `floor` may be `factor` times as bright as the mean of its eight neighbours and no more; its hue stays. Everything
// darker than `floor` passes unchanged, so sparse light is safe: energy is lost only above it.
//
// Cost      1 cycle a pixel; 30 for vectors that hold something to mend.
// Same bits for any number of threads and any instruction set.
// Bad input a pixel with a NaN, a negative number or one beyond kInfiniteLight becomes the mean of its sound neighbours,
//           black if none. Nobody behind this door checks again.
#pragma once

#include "base/jobs.h"
#include "filter/plane.h"
#include "filter/rows.h"

namespace gh::filter {

// So bright that sums over a neighbourhood might overflow.
inline constexpr float kInfiniteLight = 1e30f;

struct MendSettings {
    float floor = 3.0f;   // luminance; say four times what shows as white, or more
    float factor = 8.0f;  // times the neighbours' mean
};

// `out` is made to fit and is not `light`.
void mend(const Plane3& light, const MendSettings& settings, const Jobs& jobs, Plane3& out);
// Asks rows up to kMendReach away.
inline constexpr int kMendReach = 1;
[[nodiscard]] RowWork mend_rows(const Plane3& light, const MendSettings& settings, Plane3& out);
// And takes it off its colour, as demodulate() does; null or empty: white.
[[nodiscard]] RowWork mend_rows(const Plane3& light, const MendSettings& settings, const Plane3* albedo,
                                Plane3& out);

}  // namespace gh::filter
