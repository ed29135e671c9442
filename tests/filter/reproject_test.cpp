// Where a pixel was a frame ago, held against geometry that can be worked out by hand.
#include "filter/reproject.h"

#include "filter/synthetic.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gh {
namespace {

constexpr int kWidth = 96, kHeight = 64;

struct Pair {
    test::Frame then, now;
    filter::Taps taps;
};

Pair reprojected(const test::Room& before, const test::Room& after, filter::Motion motion,
                 int then_width = kWidth, int then_height = kHeight) {
    const Jobs jobs(1);
    Pair pair{test::render(before, then_width, then_height, 1), test::render(after, kWidth, kHeight, 2), {}};
    filter::SeenSurfaces seen{pair.then.surfaces.lens, {}, pair.then.surfaces.part};
    filter::make_guides(pair.then.surfaces, jobs, seen.guides);
    filter::Guides guides;
    filter::make_guides(pair.now.surfaces, jobs, guides);
    filter::reproject(pair.now.surfaces, guides, seen, motion, jobs, pair.taps);
    return pair;
}

float weight_of(const filter::Taps& taps, int x, int y) {
    return (taps.weight[0].at(x, y) + taps.weight[1].at(x, y)) +
           (taps.weight[2].at(x, y) + taps.weight[3].at(x, y));
}

// The place the four taps stand for, if all four count.
glm::vec2 place_of(const Pair& pair, int x, int y) {
    const filter::Taps& taps = pair.taps;
    const auto stride = static_cast<int>(pair.then.surfaces.part.stride());
    const int first = taps.first.at(x, y);
    const float right = taps.weight[1].at(x, y) + taps.weight[3].at(x, y);
    const float below = taps.weight[2].at(x, y) + taps.weight[3].at(x, y);
    return {static_cast<float>(first % stride) + right + 0.5f,
            static_cast<float>(first / stride) + below + 0.5f};
}

// Picture point of p by the lens' own definition, in double precision.
glm::vec2 seen_at(const filter::Pinhole& lens, const glm::vec3& p) {
    const glm::dvec3 d(p - lens.eye), r(lens.right), w(lens.down), c(lens.corner);
    const double volume = glm::dot(r, glm::cross(w, c));
    const double depth = glm::dot(glm::cross(r, w), d) / volume;
    return {glm::dot(glm::cross(w, c), d) / volume / depth, glm::dot(glm::cross(c, r), d) / volume / depth};
}

TEST(Reproject, WithNothingMovingEveryPixelIsItselfWhateverTheJitter) {
    const Pair pair = reprojected({}, {}, filter::Motion::OfSurface);
    const auto stride = static_cast<int>(pair.then.surfaces.part.stride());
    int torn = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (pair.now.surfaces.part.at(x, y) == filter::kNoSurface) {
                EXPECT_EQ(weight_of(pair.taps, x, y), 0.0f);
                continue;
            }
            if (pair.now.surfaces.part.at(x, y) != pair.then.surfaces.part.at(x, y))
                continue;  // jitter over an edge
            torn += pair.taps.weight[0].at(x, y) != 1.0f || pair.taps.first.at(x, y) != y * stride + x;
        }
    }
    // At the ball's rim its own curve is more than its tangent foretells, half a pixel away.
    EXPECT_LE(torn, kWidth * kHeight / 100);
}

TEST(Reproject, FollowsTheCamera) {
    test::Room before, after;
    after.eye += glm::vec3(0.11f, 0.03f, -0.05f);
    after.yaw = 0.02f;
    const Pair pair = reprojected(before, after, filter::Motion::OfSurface);
    int compared = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (pair.now.surfaces.part.at(x, y) != test::kBackWall || pair.taps.weight[0].at(x, y) == 0.0f ||
                pair.taps.weight[1].at(x, y) == 0.0f || pair.taps.weight[2].at(x, y) == 0.0f ||
                pair.taps.weight[3].at(x, y) == 0.0f) {
                continue;
            }
            const glm::vec3 p = pair.now.surfaces.position.get(x, y);
            const glm::vec2 jitter = seen_at(pair.now.surfaces.lens, p) -
                                     glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const glm::vec2 wanted = seen_at(pair.then.surfaces.lens, p) - jitter;
            const glm::vec2 off = place_of(pair, x, y) - wanted;
            EXPECT_LT(std::max(std::abs(off.x), std::abs(off.y)), 1.0f / 256.0f) << x << ' ' << y;
            ++compared;
        }
    }
    EXPECT_GT(compared, 300);
}

// Whether any of the nine pixels around showed that part.
bool is_shown_around(const filter::GBuffer& surfaces, int x, int y, std::uint32_t part) {
    for (int v = std::max(0, y - 1); v <= std::min(kHeight - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(kWidth - 1, x + 1); ++u) {
            if (surfaces.part.at(u, v) == part) return true;
        }
    }
    return false;
}

// The ball's own pixels are found where the ball was; what it uncovered was never seen, but for its rim, which goes on
// with the light that the wall had right beside it.
TEST(Reproject, FollowsAThingThatMovesAndKnowsWhatItUncovered) {
    test::Room before, after;
    after.ball_before = before.ball;
    after.ball.x -= 0.5f;
    const Pair pair = reprojected(before, after, filter::Motion::OfSurface);
    const auto stride = static_cast<int>(pair.then.surfaces.part.stride());
    int followed = 0, ball = 0, uncovered = 0, at_the_rim = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const bool known = weight_of(pair.taps, x, y) > 0.0f;
            const std::uint32_t now = pair.now.surfaces.part.at(x, y),
                                then = pair.then.surfaces.part.at(x, y);
            if (now == test::kBall) {
                ++ball;
                followed += known;
            } else if (then == test::kBall && now != filter::kNoSurface) {
                ++uncovered;
                if (!known) continue;
                ++at_the_rim;
                EXPECT_TRUE(is_shown_around(pair.then.surfaces, x, y, now)) << x << ' ' << y;
                if (pair.taps.weight[0].at(x, y) != 1.0f) continue;
                const int first = pair.taps.first.at(x, y);
                EXPECT_EQ(pair.then.surfaces.part.at(first % stride, first / stride), now);
            }
        }
    }
    ASSERT_GT(ball, 100);
    ASSERT_GT(uncovered, 50);
    EXPECT_GT(followed, ball * 9 / 10);
    EXPECT_LT(at_the_rim, uncovered / 2);
}

// Samples lie elsewhere in every frame, so a pixel at an edge shows now the wall and now the ball. Either goes on with
// what was learnt of it beside: else edges would be as noisy as a first frame for ever.
TEST(Reproject, APixelAtAnEdgeGoesOnWithWhatIsKnownBesideIt) {
    const Pair pair = reprojected({}, {}, filter::Motion::OfSurface);
    int changed = 0, known = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const std::uint32_t now = pair.now.surfaces.part.at(x, y);
            if (now == filter::kNoSurface || now == pair.then.surfaces.part.at(x, y)) continue;
            if (!is_shown_around(pair.then.surfaces, x, y, now)) continue;
            ++changed;
            known += weight_of(pair.taps, x, y) > 0.0f;
        }
    }
    ASSERT_GT(changed, 30);
    EXPECT_GT(known, changed * 9 / 10);
}

TEST(Reproject, FindsThePlaceInAPictureOfAnotherSize) {
    const Pair pair = reprojected({}, {}, filter::Motion::OfSurface, 48, 32);
    int compared = 0;
    for (int y = 8; y < kHeight - 8; ++y) {
        for (int x = 8; x < kWidth - 8; ++x) {
            if (pair.now.surfaces.part.at(x, y) != test::kBackWall) continue;
            const float least = std::min({pair.taps.weight[0].at(x, y), pair.taps.weight[1].at(x, y),
                                          pair.taps.weight[2].at(x, y), pair.taps.weight[3].at(x, y)});
            if (least == 0.0f) continue;
            const glm::vec2 place = place_of(pair, x, y);
            EXPECT_NEAR(place.x, (static_cast<float>(x) + 0.5f) * 0.5f, 1.0f / 256.0f);
            EXPECT_NEAR(place.y, (static_cast<float>(y) + 0.5f) * 0.5f, 1.0f / 256.0f);
            ++compared;
        }
    }
    EXPECT_GT(compared, 100);
}

// A polished floor shows the room upside down, as far below as it is above. Walking on, the picture in the floor moves
// like things at that distance, not like the floor.
TEST(Reproject, LightInAMirrorFollowsItsVirtualImage) {
    test::Room before, after;
    after.eye += glm::vec3(0.1f, 0.04f, 0.0f);
    const Jobs jobs(1);
    Pair pair{test::render(before, kWidth, kHeight, 1), test::render(after, kWidth, kHeight, 2), {}};
    filter::SeenSurfaces seen{pair.then.surfaces.lens, {}, pair.then.surfaces.part};
    filter::make_guides(pair.then.surfaces, jobs, seen.guides);
    filter::Guides guides;
    filter::make_guides(pair.now.surfaces, jobs, guides);
    filter::GBuffer& now = pair.now.surfaces;
    now.roughness = filter::Plane(kWidth, kHeight, 0.0f);
    filter::reproject(now, guides, seen, filter::Motion::OfReflection, jobs, pair.taps);
    int compared = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const float least = std::min({pair.taps.weight[0].at(x, y), pair.taps.weight[1].at(x, y),
                                          pair.taps.weight[2].at(x, y), pair.taps.weight[3].at(x, y)});
            if (now.part.at(x, y) != test::kFloor || now.reflected.at(x, y) > 100.0f || least == 0.0f)
                continue;
            // Mirror image of what is met: the point met, reflected in y = 0.
            const glm::vec3 p = now.position.get(x, y);
            const glm::vec3 d = glm::normalize(p - now.lens.eye);
            const glm::vec3 met = p + glm::vec3(d.x, -d.y, d.z) * now.reflected.at(x, y);
            const glm::vec3 image(met.x, -met.y, met.z);
            const glm::vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const glm::vec2 wanted =
                seen_at(pair.then.surfaces.lens, image) - seen_at(now.lens, image) + centre;
            const glm::vec2 off = place_of(pair, x, y) - wanted;
            EXPECT_LT(std::max(std::abs(off.x), std::abs(off.y)), 1.0f / 256.0f) << x << ' ' << y;
            const glm::vec2 by_surface = seen_at(pair.then.surfaces.lens, p) - seen_at(now.lens, p) + centre;
            compared += glm::length(by_surface - wanted) > 0.25f;  // and the floor's own motion is another
        }
    }
    EXPECT_GT(compared, 50);
}

TEST(Reproject, TheFirstFrameKnowsNothing) {
    const Jobs jobs(1);
    const test::Frame frame = test::render({}, kWidth, kHeight, 0);
    filter::Guides guides;
    filter::make_guides(frame.surfaces, jobs, guides);
    filter::Taps taps;
    filter::reproject(frame.surfaces, guides, {}, filter::Motion::OfSurface, jobs, taps);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) ASSERT_EQ(weight_of(taps, x, y), 0.0f);
    }
}

}  // namespace
}  // namespace gh
