// filter/albedo.h - light apart from the colour it falls on, so that filters blur the light and never the texture.
//
// Cost      3 cycles a pixel each.
// Same bits for any number of threads and any instruction set.
// Energy    remodulate(demodulate(x)) is x to 1e-6, for black surfaces too: both take an albedo of at least
//           kLeastAlbedo.
// Bad input an albedo that is not a number above kLeastAlbedo counts as that.
#pragma once

#include "base/jobs.h"
#include "filter/plane.h"
#include "filter/rows.h"

#include <functional>

namespace gh::filter {

inline constexpr float kLeastAlbedo = 1e-3f;

// The other way to write a colour. `out` is made to fit and may be the other one.
void luma_from(const Plane3& colour, const Jobs& jobs, Luma3& out);
void colour_from(const Luma3& luma, const Jobs& jobs, Plane3& out);

// light / albedo. `out` is made to fit and may be `light` itself. An empty albedo is 1.
void demodulate(const Plane3& light, const Plane3& albedo, const Jobs& jobs, Plane3& out);
// Nothing where the albedo is empty: then `out` must be `light`.
[[nodiscard]] RowWork demodulate_rows(const Plane3& light, const Plane3& albedo, Plane3& out);

// What is put together again: (direct + indirect) * albedo + specular * gloss + clean. Any of the lights may be null or
// empty: black. An empty albedo or gloss is 1.
struct Parts {
    const Luma3* direct = nullptr;    // demodulated
    const Luma3* indirect = nullptr;  // demodulated
    const Luma3* specular = nullptr;  // demodulated
    const Plane3* clean = nullptr;    // in red, green and blue
    const Plane3* gloss = nullptr;    // the specular light's albedo
};
// `out` has the albedo's size, or that of the first light there is.
void remodulate(const Parts& parts, const Plane3& albedo, const Jobs& jobs, Plane3& out);
[[nodiscard]] RowWork remodulate_rows(const Parts& parts, const Plane3& albedo, Plane3& out);
// The same to rows of whole vectors that a caller keeps elsewhere.
struct RemodulatedRows {
    int width, height;
    std::function<void(int y, float* const out[3])> work;
};
[[nodiscard]] RemodulatedRows remodulated_rows(const Parts& parts, const Plane3& albedo);

}  // namespace gh::filter
