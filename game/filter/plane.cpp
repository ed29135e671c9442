#include "filter/plane.h"

namespace gh::filter {

void planes_from(const Image& image, Plane3& out) {
    out.fit(image.width, image.height);
    for (int y = 0; y < image.height; ++y) {
        const glm::vec3* from = image.pixels.data() + image.index(0, y);
        float *r = out.x.row(y), *g = out.y.row(y), *b = out.z.row(y);
        for (int x = 0; x < image.width; ++x) {
            r[x] = from[x].x;
            g[x] = from[x].y;
            b[x] = from[x].z;
        }
    }
}

void image_from(const Plane3& planes, Image& out) {
    if (out.width != planes.width() || out.height != planes.height()) {
        out = Image(planes.width(), planes.height());
    }
    for (int y = 0; y < out.height; ++y) {
        glm::vec3* to = out.pixels.data() + out.index(0, y);
        const float *r = planes.x.row(y), *g = planes.y.row(y), *b = planes.z.row(y);
        for (int x = 0; x < out.width; ++x) to[x] = {r[x], g[x], b[x]};
    }
}

}  // namespace gh::filter
