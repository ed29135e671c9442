// filter/reproject.h - where each pixel's surface was a frame ago, by the camera's motion and by its own.
//
// The point a pixel shaded is carried to where it was (GBuffer::previous) and looked up in the last frame's picture.
// Each of the four pixels around that place is asked whether it showed the same surface: same part, normal within
// 25 degrees, and nearness as its plane foretells for that very point, to a hundredth; those that did share the weight,
// bilinearly. With none the nearest of the nine pixels around that showed about the same surface stands in: where samples
// jitter, an edge shows now one side and now the other, and thin things come and go. With none of those either the pixel
// was not seen before: it is disoccluded. (Schied et al. 2017, section 4.1; Yang, Liu and Salvi 2020, section 4.)
//
// Motion is measured from the point itself, not from the pixel's centre, and rounded to 1/256 pixel: with nothing moving
// the weights are exactly 1, 0, 0, 0, however the renderer jitters. The picture may change its size between frames;
// history is found all the same.
//
// Cost      about 20 cycles a pixel with AVX-512 where neighbours stay neighbours; twice that where they are torn apart.
// Threads   reads its arguments only.
// Same bits for any number of threads and any instruction set.
// Bad input NaN positions or normals are disoccluded.
#pragma once

#include "base/jobs.h"
#include "filter/gbuffer.h"
#include "filter/guides.h"
#include "filter/movement.h"

#include <cstdint>

namespace gh::filter {

// The last frame as reprojection asks it: its guides (swap them in), its parts, its lens.
struct SeenSurfaces {
    Pinhole lens;
    Guides guides;
    PlaneU32 part;
};

// For each pixel of a frame four pixels of the last one. `first` is where the upper left one lies, counted from pixel
// (0, 0) in numbers of a plane of that frame's size; the others are to its right, below, and below right of it, in the
// slack beside the picture maybe. Weights sum to 1, or to 0 where nothing is known.
struct Taps {
    PlaneOf<std::int32_t> first;
    Plane weight[4];

    void fit(int width, int height);
};

enum class Motion {
    OfSurface,  // light that sticks to its surface
    OfReflection,  // light seen in it: follows the virtual image at the reflected distance, the more the smoother the
                   // surface (dominant direction of Lagarde and de Rousiers 2014, listing 24)
};

// `guides` are those of `now`. `taps` is made to fit. With nothing seen every weight is 0.
void reproject(const GBuffer& now, const Guides& guides, const SeenSurfaces& seen, Motion motion,
               const Jobs& jobs, Taps& taps);
// `movement`, if anybody asks for it, is that of surfaces; with nothing seen it stays as it is.
[[nodiscard]] RowWork reproject_rows(const GBuffer& now, const Guides& guides, const SeenSurfaces& seen,
                                     Motion motion, Taps& taps, Movement* movement = nullptr);

}  // namespace gh::filter
