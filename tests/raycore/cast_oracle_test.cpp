// Balls and capsules against single triangles of every shape: the answer is compared with one found by
// searching.
#include "raycore/cast_oracle.h"

#include "support/brute_force.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace test {
namespace {

// Thin, long, tiny and right-angled triangles as well as fat ones.
Triangle a_triangle(Random& random) {
    const glm::vec3 a = random.in_cube(1.0f);
    switch (random.below(5)) {
        case 0: {  // a sliver, 1e4 to 1
            const glm::vec3 along = random.direction() * 2.0f;
            return {a, a + along, a + along * random.unit() + random.direction() * 2e-4f};
        }
        case 1:
            return {a, a + random.in_cube(0.01f), a + random.in_cube(0.01f)};
        case 2:
            return {a, a + glm::vec3(1.5f, 0, 0), a + glm::vec3(0, 0, 1.5f)};  // lies flat, as floors do
        default:
            return {a, random.in_cube(1.0f), random.in_cube(1.0f)};
    }
}

struct Cast {
    rc::Segment axis;
    float radius;
    glm::vec3 way;
};

Cast a_cast(Random& random, bool is_capsule) {
    const glm::vec3 from = random.in_cube(random.below(4) == 0 ? 0.7f : 2.0f);  // some overlap at the start
    glm::vec3 to = from;
    if (is_capsule) to += random.below(3) == 0 ? glm::vec3(0, random.unit(), 0) : random.in_cube(0.7f);
    const float radius = random.below(8) == 0 ? 1e-3f : random.between(0.02f, 0.5f);
    glm::vec3 way = random.in_cube(1.0f) - 0.7f * from;  // most pass near the middle
    if (random.below(6) == 0) way = glm::vec3(0, -2.0f * from.y, 0);
    return {{from, to}, radius, way * random.between(0.3f, 4.0f)};
}

struct Tally {
    int hits = 0, misses = 0, overlaps = 0;
};

void compare(const Triangle& triangle, const Cast& cast, Tally& tally) {
    Mesh mesh{.positions = {triangle[0], triangle[1], triangle[2]}, .triangles = {{0, 1, 2}}};
    TestScene scene;
    scene.add(mesh);
    scene.commit();
    const auto hit = rc::capsule_cast(scene.scene(), cast.axis, cast.radius, cast.way, rc::kAllLayers);
    const OracleCast truth = cast_by_search(cast.axis, cast.radius, cast.way, triangle);

    // Positions are within 4 of the origin and floats; t is rounded down to a float. A sliver of the least
    // area may be dropped at build, so the widths above keep clear of that.
    const auto r = static_cast<long double>(cast.radius);
    const long double slack = 1e-6L;
    if (!hit) {
        EXPECT_GT(truth.least_distance, r - slack)
            << "reported clear, yet " << static_cast<double>(truth.least_distance)
            << " from the triangle with radius " << cast.radius;
        ++tally.misses;
        return;
    }
    EXPECT_LT(truth.least_distance, r + slack) << "hit what it never comes near";
    EXPECT_NEAR(glm::length(hit->normal), 1.0f, 1e-6f);
    const long double at_hit = distance_at(cast.axis, cast.way, static_cast<long double>(hit->t), triangle);
    const long double point_off = distance_to_triangle(Point(hit->point), triangle);
    EXPECT_LT(point_off, slack) << "the contact is not on the triangle";
    if (hit->t == 0.0f && truth.start_distance <= r) {
        ++tally.overlaps;
        if (truth.start_distance > slack) {
            EXPECT_NEAR(static_cast<double>(hit->depth), static_cast<double>(r - truth.start_distance), 1e-6);
        } else {
            EXPECT_GE(hit->depth, cast.radius - 1e-6f)
                << "an axis that goes through is at least a radius deep";
        }
    } else {
        ++tally.hits;
        EXPECT_EQ(hit->depth, 0.0f);
        // Touching, 1e-5 of the radius or a float's step of the way.
        EXPECT_NEAR(static_cast<double>(at_hit), static_cast<double>(r),
                    1e-5 * static_cast<double>(cast.radius) + 1e-6);
        ASSERT_TRUE(truth.first_t || truth.least_distance < r + slack);
        // Never later than the truth by more than its own rounding; earlier only as far as the slope is
        // shallow.
        if (truth.first_t) {
            EXPECT_LE(static_cast<long double>(hit->t), *truth.first_t + 1e-7L);
        }
    }
    if (truth.start_distance > r) {
        // The normal points from the contact to the axis: stepping along it by the radius reaches the axis.
        const Point moved = static_cast<long double>(hit->t) * Point(cast.way);
        const Point tip = Point(hit->point) + r * Point(hit->normal);
        const Point a = Point(cast.axis.from) + moved, along = Point(cast.axis.to) - Point(cast.axis.from);
        const long double square = glm::dot(along, along);
        const long double s = square > 0 ? glm::clamp(glm::dot(tip - a, along) / square, 0.0L, 1.0L) : 0.0L;
        EXPECT_LT(glm::length(a + s * along - tip), 3e-6L) << "normal or contact does not lead to the axis";
    }
}

TEST(CastOracle, BallsMeetTrianglesWhenASearchSaysSo) {
    Random random(11);
    Tally tally;
    for (int i = 0; i < 5000 && !testing::Test::HasFailure(); ++i) {
        const Triangle triangle = a_triangle(random);
        SCOPED_TRACE(i);
        compare(triangle, a_cast(random, false), tally);
    }
    EXPECT_GT(tally.hits, 500);
    EXPECT_GT(tally.misses, 500);
    EXPECT_GT(tally.overlaps, 50);
}

TEST(CastOracle, CapsulesMeetTrianglesWhenASearchSaysSo) {
    Random random(12);
    Tally tally;
    for (int i = 0; i < 800 && !testing::Test::HasFailure(); ++i) {
        const Triangle triangle = a_triangle(random);
        SCOPED_TRACE(i);
        compare(triangle, a_cast(random, true), tally);
    }
    EXPECT_GT(tally.hits, 100);
    EXPECT_GT(tally.misses, 50);
    EXPECT_GT(tally.overlaps, 20);
}

}  // namespace
}  // namespace test
