// A niche in a wall, both of one part and facing the same way: when the eye moves, what the wall's edge uncovers has no
// past, though thing and normal are the same. Only the plane tells.
#include "filter/reproject.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace gh {
namespace {

constexpr int kWidth = 96, kHeight = 16;
constexpr float kWallAt = -2.0f, kNicheAt = -4.0f;  // the wall is where x < 0

filter::Pinhole lens_at(float eye_x) {
    const float across = 1.2f, pixel = across / kWidth;
    return {.eye = {eye_x, 0.0f, 0.0f},
            .corner = {-0.5f * across, 0.5f * pixel * kHeight, -1.0f},
            .right = {pixel, 0.0f, 0.0f},
            .down = {0.0f, -pixel, 0.0f}};
}

// Where the way from the eye along `direction` ends.
glm::vec3 seen(const glm::vec3& eye, const glm::vec3& direction) {
    const glm::vec3 on_wall = eye + direction * (kWallAt / direction.z);
    return on_wall.x < 0.0f ? on_wall : eye + direction * (kNicheAt / direction.z);
}

filter::GBuffer picture_from(float eye_x) {
    filter::GBuffer surfaces;
    surfaces.lens = lens_at(eye_x);
    surfaces.fit(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const glm::vec3 direction = surfaces.lens.corner +
                                        surfaces.lens.right * (static_cast<float>(x) + 0.5f) +
                                        surfaces.lens.down * (static_cast<float>(y) + 0.5f);
            surfaces.part.at(x, y) = 7;
            surfaces.position.set(x, y, seen(surfaces.lens.eye, direction));
            surfaces.normal.set(x, y, {0.0f, 0.0f, 1.0f});
        }
    }
    return surfaces;
}

TEST(Reproject, ANicheThatTheWallUncoversHasNoPast) {
    const Jobs jobs(1);
    const filter::GBuffer then = picture_from(0.0f), now = picture_from(0.7f);
    filter::SeenSurfaces before{then.lens, {}, then.part};
    filter::make_guides(then, jobs, before.guides);
    filter::Guides guides;
    filter::make_guides(now, jobs, guides);
    filter::Taps taps;
    filter::reproject(now, guides, before, filter::Motion::OfSurface, jobs, taps);
    int uncovered = 0, falsely_known = 0, kept = 0, lost = 0;
    for (int x = 0; x < kWidth; ++x) {
        const glm::vec3 p = now.position.get(x, kHeight / 2);
        const glm::vec3 from_then = p - then.lens.eye;
        const float at_wall = then.lens.eye.x + from_then.x * (kWallAt / p.z);
        float weight = 0.0f;
        for (const filter::Plane& tap : taps.weight) weight += tap.at(x, kHeight / 2);
        const bool is_niche = p.z < -3.0f;
        if (is_niche && at_wall < -0.05f) {  // a pixel or two within the edge
            ++uncovered;
            falsely_known += weight > 0.0f ? 1 : 0;
        } else if (is_niche && at_wall > 0.05f && at_wall < 1.0f) {
            ++kept;
            lost += weight > 0.0f ? 0 : 1;
        }
    }
    EXPECT_GT(uncovered, 5);
    EXPECT_EQ(falsely_known, 0) << "of " << uncovered;
    EXPECT_GT(kept, 10);
    EXPECT_EQ(lost, 0) << "of " << kept;
}

}  // namespace
}  // namespace gh
