#include "filter/planes.h"

#include "base/jobs.h"
#include "base/random.h"

#include <glm/common.hpp>

#include <algorithm>

namespace gh::test {

using filter::Plane;
using filter::Plane3;

Plane3 noise(int width, int height, std::uint64_t seed) {
    Random random(seed);
    Plane3 out(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) out.set(x, y, {random.unit(), random.unit(), random.unit()});
    }
    return out;
}

double mean_of(const Plane& plane) {
    double sum = 0.0;
    for (int y = 0; y < plane.height(); ++y) {
        for (int x = 0; x < plane.width(); ++x) sum += static_cast<double>(plane.at(x, y));
    }
    return sum / (static_cast<double>(plane.width()) * plane.height());
}

float largest_difference(const Plane3& a, const Plane3& b) {
    float most = 0.0f;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const glm::vec3 off = glm::abs(a.get(x, y) - b.get(x, y));
            if (!(std::max({off.x, off.y, off.z}) <= most)) most = std::max({off.x, off.y, off.z});
        }
    }
    return most;
}

filter::GBuffer stepped_wall(int width, int height) {
    filter::GBuffer surfaces;
    surfaces.fit(width, height);
    const float pixel = 1.0f / static_cast<float>(height);
    const float left = -0.5f * static_cast<float>(width) * pixel;
    surfaces.lens = {.eye = glm::vec3(0.0f),
                     .corner = {left, 0.5f, -1.0f},
                     .right = {pixel, 0, 0},
                     .down = {0, -pixel, 0}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::vec3 d = surfaces.lens.corner + surfaces.lens.right * (static_cast<float>(x) + 0.5f) +
                                surfaces.lens.down * (static_cast<float>(y) + 0.5f);
            surfaces.position.set(x, y, d * (x < width / 2 ? 2.0f : 3.0f));
            surfaces.normal.set(x, y, {0.0f, 0.0f, 1.0f});
            surfaces.part.at(x, y) = x < width / 2 ? 1u : 2u;
        }
    }
    return surfaces;
}

filter::Guides guides_of(const filter::GBuffer& surfaces) {
    filter::Guides guides;
    filter::make_guides(surfaces, Jobs(1), guides);
    return guides;
}

filter::Taps taps_of_still_wall(int width, int height, const Jobs& jobs) {
    const filter::GBuffer surfaces = stepped_wall(width, height);
    const filter::Guides guides = guides_of(surfaces);
    filter::Taps taps;
    filter::reproject(surfaces, guides, {surfaces.lens, guides, surfaces.part}, filter::Motion::OfSurface,
                      jobs, taps);
    return taps;
}

}  // namespace gh::test
