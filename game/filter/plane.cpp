#include "filter/plane.h"

#include "filter/interleave.h"
#include "filter/rows.h"

namespace gh::filter {

void planes_from(const Image& image, Plane3& out) {
    out.fit(image.width, image.height);
    for (int y = 0; y < image.height; ++y) part_row(image, y, out);
}

void image_from(const Plane3& planes, Image& out) {
    if (out.width != planes.width() || out.height != planes.height()) {
        out = Image(planes.width(), planes.height());
    }
    for (int y = 0; y < out.height; ++y) join_row(planes, y, out);
}

void part_row(const Image& image, int y, Plane3& out) {
    if (image.width == 0) return;
    float* to[3];
    point_to(to, out, y);
    part_row(&image.pixels[image.index(0, y)].x, static_cast<std::size_t>(image.width), to);
}

void join_row(const Plane3& planes, int y, Image& out) {
    if (out.width == 0) return;
    const float* from[3];
    point_to(from, planes, y);
    join_row(from, static_cast<std::size_t>(out.width), &out.pixels[out.index(0, y)].x);
}

}  // namespace gh::filter
