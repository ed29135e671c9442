// filter/plane.h - the planes of base/plane.h as the filters use them.
#pragma once

#include "base/image.h"
#include "base/plane.h"

namespace gh::filter {

using gh::Plane;
using gh::Plane3;
using gh::PlaneOf;
using gh::PlaneU32;

// Light on its way through the filters: x red, y luminance (0.2126 r + 0.7152 g + 0.0722 b), z blue. Luminance is what they
// judge by and green is most of it, so they carry three planes instead of four; being linear, they lose nothing.
using Luma3 = Plane3;

// The same picture, the other way round in memory. Sizes are made to fit.
void planes_from(const Image& image, Plane3& out);
void image_from(const Plane3& planes, Image& out);
// One row of that. Of one size.
void part_row(const Image& image, int y, Plane3& out);
void join_row(const Plane3& planes, int y, Image& out);

}  // namespace gh::filter
