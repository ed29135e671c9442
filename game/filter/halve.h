// filter/halve.h - light that has no fine detail at half the picture's sides, and back again by what every pixel shows.
//
// halve   a block of 2x2 pixels becomes one, which shows what the upper left one does; its light is the mean of those of
//         the four that lie on the same plane of the same part: another surface's light is none of its own.
// widen   a pixel takes light from the four small ones around it, bilinearly, as far as they are of its surface (Kopf et
//         al. 2007). Where none is, those nearest in kind stand in, or, where all are sky, its own sample.
//
// Cost      of halving two lights 1.5 ns, of widening two 3 ns a pixel of the large picture, with AVX-512.
// Threads   rows by themselves. Same bits for any number of them and any instruction set.
// Energy    a constant stays that constant to 1e-6.
// Bad input light must be finite, as mend() leaves it; guides are always fine.
#pragma once

#include "filter/gbuffer.h"
#include "filter/guides.h"
#include "filter/rows.h"

#include <array>

namespace gh::filter {

// A picture of half the size, rounded up, and its light, which is taken off its colours. Direct light stays out.
struct Halved {
    GBuffer surfaces;
    Light light;

    // `of` has its lens and sizes. What is empty stays empty.
    void fit(const GBuffer& of, const Light& lights, const Plane3& indirect, const Plane3& specular);
};

// Row `y` of `to`, from rows 2 y and 2 y + 1 of the others. `guides` are those of `surfaces`; `indirect` and `specular` are
// mended and taken off their colours, or empty.
[[nodiscard]] RowWork halve_rows(const GBuffer& surfaces, const Guides& guides, const Light& light,
                                 const Plane3& indirect, const Plane3& specular, Halved& to);

// What is to be widened: null lights are left out.
struct Widening {
    std::array<const Luma3*, 2> light{};
    // Whether light of another part counts no more than that of another surface, and not at all in either case: what
    // varnish mirrors is not on the plate beside it.
    std::array<bool, 2> asks_part{};
    std::array<Luma3*, 2>
        out{};  // of the large picture's size, holding the pixels' own samples, in red, green and blue
};
inline constexpr int kWidenReach = 2;  // large rows that must have been halved, above and below
[[nodiscard]] RowWork widen_rows(const Widening& widening, const Guides& small, const PlaneU32& small_part,
                                 const Guides& large, const PlaneU32& large_part);

}  // namespace gh::filter
