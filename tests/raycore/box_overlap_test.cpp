// Crates and doors: what a turned box overlaps, how deep, and the way out. The truth is found by searching the triangle
// for the place deepest in the box, in long double; nothing is shared with the separating axes under test.
#include "support/brute_force.h"

#include "raycore/cast_oracle.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace test {
namespace {

constexpr rc::LayerMask kAll = rc::kAllLayers;

// How far a point is outside the box in the direction of its worst side; negative inside. Convex.
long double outside(const rc::OrientedBox& box, const Point& p) {
    long double worst = -std::numeric_limits<long double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const long double along = glm::dot(p - Point(box.centre), Point(box.axes[i]));
        worst = std::max(worst, std::abs(along) - static_cast<long double>(box.half[i]));
    }
    return worst;
}

long double least_of(const std::function<long double(long double)>& f) {
    long double low = 0, high = 1;
    for (int i = 0; i < 40; ++i) {
        const long double a = low + (high - low) * 0.382L, b = low + (high - low) * 0.618L;
        (f(a) <= f(b) ? high : low) = f(a) <= f(b) ? b : a;
    }
    return std::min({f(low), f(0.0L), f(1.0L)});
}

// The least of `outside` over the triangle: a convex function, minimised along fans of straight lines.
long double least_outside(const rc::OrientedBox& box, const Triangle& t) {
    const Point a(t[0]), b(t[1]), c(t[2]);
    return least_of([&](long double v) {
        const Point from = a + v * (b - a);
        return least_of([&](long double w) { return outside(box, from + w * (c - from)); });
    });
}

glm::mat3 a_rotation(Random& random) {
    const glm::vec3 x = random.direction();
    const glm::vec3 y = glm::normalize(glm::cross(x, random.direction()));
    return {x, y, glm::cross(x, y)};
}

rc::OrientedBox a_box(Random& random) {
    rc::OrientedBox box{.centre = random.in_cube(1.2f),
                        .half = glm::vec3(0.05f) + glm::abs(random.in_cube(0.6f))};
    if (random.below(3) != 0) box.axes = a_rotation(random);
    return box;
}

// Thin, tiny and flat-lying triangles among fat ones.
Mesh some_triangles(Random& random, std::uint32_t n) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < n; ++i) {
        const glm::vec3 a = random.in_cube(1.5f);
        glm::vec3 b = random.in_cube(1.5f), c = random.in_cube(1.5f);
        if (i % 5 == 0) c = a + (b - a) * random.unit() + random.direction() * 1e-3f;
        if (i % 5 == 1) b = a + random.in_cube(0.02f), c = a + random.in_cube(0.02f);
        if (i % 5 == 2) b.y = c.y = a.y;
        mesh.positions.insert(mesh.positions.end(), {a, b, c});
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return mesh;
}

Triangle triangle_of(const Mesh& mesh, std::uint32_t i) {
    const glm::uvec3& t = mesh.triangles[i];
    return {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
}

TestScene scene_of(const Mesh& mesh) {
    TestScene scene;
    scene.add(mesh);
    scene.commit();
    return scene;
}

TEST(BoxOverlap, EveryTriangleWithinIsFoundDeepestFirst) {
    Random random(61);
    const Mesh mesh = some_triangles(random, 40);
    const TestScene scene = scene_of(mesh);
    int contacts = 0, apart = 0;
    for (int i = 0; i < 16; ++i) {
        const rc::OrientedBox box = a_box(random);
        std::vector<rc::CastHit> out(40);
        out.resize(rc::box_overlaps(scene.scene(), box, kAll, out));
        std::vector<bool> is_found(40, false);
        for (std::size_t k = 0; k < out.size(); ++k) {
            ASSERT_TRUE(k == 0 || out[k - 1].depth >= out[k].depth);
            ASSERT_FALSE(is_found[out[k].primitive]) << "one contact a triangle";
            is_found[out[k].primitive] = true;
            const Triangle t = triangle_of(mesh, out[k].primitive);
            ASSERT_LT(static_cast<double>(distance_to_triangle(Point(out[k].point), t)), 1e-6);
            ASSERT_LT(static_cast<double>(outside(box, Point(out[k].point))), 1e-6)
                << "the contact is in the box";
        }
        contacts += static_cast<int>(out.size());
        for (std::uint32_t t = 0; t < 40; ++t) {
            const long double least = least_outside(box, triangle_of(mesh, t));
            if (std::abs(least) < 4e-6L) continue;  // touching
            ASSERT_EQ(is_found[t], least < 0) << "triangle " << t << " by " << static_cast<double>(least);
            apart += least > 0;
        }
    }
    EXPECT_GT(contacts, 60);
    EXPECT_GT(apart, 200);
}

TEST(BoxOverlap, TheNormalAndTheDepthAreTheShortestWayOut) {
    Random random(62);
    int pushed = 0;
    for (int i = 0; i < 2000 && pushed < 150; ++i) {
        const TestScene scene = scene_of(some_triangles(random, 1));
        rc::OrientedBox box = a_box(random);
        rc::CastHit hit;
        if (rc::box_overlaps(scene.scene(), box, kAll, {&hit, 1}) == 0) continue;
        ++pushed;
        ASSERT_NEAR(glm::length(hit.normal), 1.0f, 1e-6f);
        const glm::vec3 start = box.centre;
        const auto overlaps_moved = [&](const glm::vec3& by) {
            box.centre = start + by;
            rc::CastHit again;
            return rc::box_overlaps(scene.scene(), box, kAll, {&again, 1}) != 0;
        };
        ASSERT_FALSE(overlaps_moved(hit.normal * (hit.depth + 1e-5f))) << i;
        if (hit.depth < 1e-4f) continue;
        for (int k = 0; k < 30; ++k)
            ASSERT_TRUE(overlaps_moved(random.direction() * (0.99f * hit.depth)))
                << "a shorter way out, " << i;
    }
    EXPECT_EQ(pushed, 150);
}

TEST(BoxOverlap, ACrateSunkIntoAFloorIsPushedStraightUp) {
    const TestScene scene = scene_of(make_sheet(4.0f, 0.0f, 3));
    const rc::OrientedBox crate{.centre = {0.2f, 0.45f, 0.3f}, .half = glm::vec3(0.5f)};
    std::vector<rc::CastHit> out(18);
    out.resize(rc::box_overlaps(scene.scene(), crate, kAll, out));
    ASSERT_GE(out.size(), 2u);
    for (const rc::CastHit& hit : out) {
        EXPECT_NEAR(hit.depth, 0.05f, 1e-6f);
        EXPECT_EQ(hit.normal, glm::vec3(0, 1, 0));
        EXPECT_NEAR(hit.point.y, 0.0f, 1e-7f);
    }
}

TEST(BoxOverlap, TouchingIsNotOverlapping) {
    const TestScene scene = scene_of(make_sheet(4.0f, 0.0f, 3));
    rc::CastHit hit;
    const auto count = [&](float height) {
        const rc::OrientedBox crate{.centre = {0.2f, height, 0.3f}, .half = glm::vec3(0.5f)};
        return rc::box_overlaps(scene.scene(), crate, kAll, {&hit, 1});
    };
    EXPECT_EQ(count(0.5f), 0u);
    EXPECT_EQ(count(std::nextafter(0.5f, 0.0f)), 0u) << "by rounding only";
    EXPECT_EQ(count(0.4999f), 1u);
}

// A box without thickness is a pane, without width a stick: each overlaps what goes through it.
TEST(BoxOverlap, PanesAndSticksOverlapWhatGoesThroughThem) {
    const TestScene scene = scene_of(make_sheet(1.0f, 0.0f, 1));
    rc::CastHit hit;
    const auto count = [&](const glm::vec3& half) {
        return rc::box_overlaps(scene.scene(), {.centre = {0.3f, 0.1f, 0.2f}, .half = half}, kAll, {&hit, 1});
    };
    EXPECT_EQ(count({0.0f, 0.5f, 0.5f}), 1u);
    EXPECT_EQ(count({0.5f, 0.0f, 0.5f}), 0u) << "a pane above the sheet";
    EXPECT_EQ(count({0.0f, 0.5f, 0.0f}), 1u);
    EXPECT_EQ(count({0.0f, 0.05f, 0.0f}), 0u) << "a stick that ends above it";
    EXPECT_EQ(count(glm::vec3(0.0f)), 0u);
}

TEST(BoxOverlap, AxesAreMadeOrthonormal) {
    Random random(63);
    const Mesh mesh = some_triangles(random, 60);
    const TestScene scene = scene_of(mesh);
    for (int i = 0; i < 60; ++i) {
        rc::OrientedBox box = a_box(random);
        std::vector<rc::CastHit> a(60), b(60);
        a.resize(rc::box_overlaps(scene.scene(), box, kAll, a));
        box.axes = {box.axes[0] * 3.0f, box.axes[1] * 0.2f + box.axes[0] * 0.1f, box.axes[2] * -1.0f};
        b.resize(rc::box_overlaps(scene.scene(), box, kAll, b));
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k].depth, b[k].depth, 1e-6f);
    }
}

TEST(BoxOverlap, LayersAndInstancesAreHonoured) {
    TestScene scene;
    const Mesh sheet = make_sheet(1.0f, 0.0f, 1);
    scene.add(sheet, glm::mat4x3(2, 0, 0, 0, 1, 0, 0, 0, -2, 0, 5, 0), 1);
    scene.add(sheet, glm::mat4x3(0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0), 2);
    scene.commit();
    const rc::OrientedBox box{.centre = {0.3f, 5.1f, 0.2f}, .half = glm::vec3(0.5f)};
    rc::CastHit hit;
    for (const rc::LayerMask layer : {1u, 2u}) {
        ASSERT_EQ(rc::box_overlaps(scene.scene(), box, layer, {&hit, 1}), 1u);
        EXPECT_EQ(hit.instance, layer - 1);
        EXPECT_EQ(std::abs(hit.normal[layer == 1 ? 1 : 0]), 1.0f);
    }
    EXPECT_EQ(rc::box_overlaps(scene.scene(), box, 4, {&hit, 1}), 0u);
}

// Balls, capsules and boxes in batches are answered as each alone.
TEST(BoxOverlap, BatchesOfBodiesAreAnsweredAsEachAlone) {
    Random random(64);
    const TestScene scene = scene_of(some_triangles(random, 80));
    constexpr std::size_t kBodies = 33, kCapacity = 4;
    std::vector<rc::Ball> balls;
    std::vector<rc::Capsule> capsules;
    std::vector<rc::OrientedBox> boxes;
    for (std::size_t i = 0; i < kBodies; ++i) {
        balls.push_back({random.in_cube(2.0f), random.between(0.0f, 0.4f)});
        capsules.push_back({{random.in_cube(2.0f), random.in_cube(2.0f)}, random.between(0.0f, 0.2f)});
        boxes.push_back(a_box(random));
    }
    std::vector<rc::CastHit> out(kBodies * kCapacity), alone(kCapacity);
    std::vector<std::uint32_t> counts(kBodies);
    std::uint32_t total = 0;
    const auto expect_same = [&](std::size_t i, std::size_t count) {
        ASSERT_EQ(counts[i], count);
        total += counts[i];
        for (std::size_t k = 0; k < count; ++k) {
            EXPECT_EQ(out[i * kCapacity + k].depth, alone[k].depth);
            EXPECT_EQ(out[i * kCapacity + k].point, alone[k].point);
            EXPECT_EQ(out[i * kCapacity + k].normal, alone[k].normal);
            EXPECT_EQ(out[i * kCapacity + k].primitive, alone[k].primitive);
        }
    };
    rc::sphere_overlaps(scene.scene(), balls, kAll, kCapacity, out, counts);
    for (std::size_t i = 0; i < kBodies; ++i)
        expect_same(i, rc::sphere_overlaps(scene.scene(), balls[i].centre, balls[i].radius, kAll, alone));
    rc::capsule_overlaps(scene.scene(), capsules, kAll, kCapacity, out, counts);
    for (std::size_t i = 0; i < kBodies; ++i)
        expect_same(i,
                    rc::capsule_overlaps(scene.scene(), capsules[i].axis, capsules[i].radius, kAll, alone));
    rc::box_overlaps(scene.scene(), boxes, kAll, kCapacity, out, counts);
    for (std::size_t i = 0; i < kBodies; ++i)
        expect_same(i, rc::box_overlaps(scene.scene(), boxes[i], kAll, alone));
    EXPECT_GT(total, 60u);
}

// A ball is a capsule without length, and its depth that of the nearest point.
TEST(BoxOverlap, ABallOverlapsWhatIsNearerThanItsRadius) {
    Random random(65);
    const TestScene scene = scene_of(some_triangles(random, 80));
    int overlaps = 0;
    for (int i = 0; i < 400; ++i) {
        const glm::vec3 centre = random.in_cube(2.0f);
        const float radius = random.between(0.01f, 0.3f);
        rc::CastHit hit;
        const bool is_over = rc::sphere_overlaps(scene.scene(), centre, radius, kAll, {&hit, 1}) != 0;
        const auto nearest = rc::closest_point(scene.scene(), centre, radius, kAll);
        ASSERT_EQ(is_over, nearest && nearest->distance < radius);
        if (!is_over) continue;
        ++overlaps;
        EXPECT_NEAR(hit.depth, radius - nearest->distance, 1e-6f);
        EXPECT_LT(glm::length(hit.point - nearest->point), 1e-6f);
    }
    EXPECT_GT(overlaps, 80);
}

}  // namespace
}  // namespace test
