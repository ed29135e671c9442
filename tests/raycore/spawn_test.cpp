// Light leaves a surface without meeting it again, at any size and any distance: section 3 of the field's figures.
#include "support/brute_force.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using test::Mesh;
using test::Random;

struct Case {
    const char* name;
    float size;      // of the body
    float distance;  // of its instance from the world's origin
    float ray_from;  // how far away the first ray starts
};

const Case kCases[] = {
    {"1 m at the origin", 1.0f, 0.0f, 2.0f},   {"1 mm at the origin", 1e-3f, 0.0f, 2e-3f},
    {"1 m at 1 km", 1.0f, 1e3f, 2.0f},         {"1 cm at 100 m", 1e-2f, 100.0f, 2e-2f},
    {"1 m seen from 10 km", 1.0f, 0.0f, 1e4f},
};

glm::vec3 outwards(const rc::SurfacePoint& point, const glm::vec3& incoming) {
    return glm::dot(point.normal, incoming) > 0.0f ? -point.normal : point.normal;
}

// Half of the directions graze: a thousandth to a hundred-thousandth of a radian over the surface.
glm::vec3 leaving_direction(Random& random, const glm::vec3& normal, int i) {
    glm::vec3 d = random.direction();
    if (glm::dot(d, normal) < 0.0f) d = -d;
    if (i % 2 == 0) return d;
    const glm::vec3 along = d - normal * glm::dot(d, normal);
    return along + normal * (random.unit() * 1e-3f + 1e-5f);
}

// No ray that leaves a convex body comes back to it. Neighbours of the triangle it starts on are not skipped.
TEST(SpawnRay, NeverMeetsTheConvexBodyItLeaves) {
    for (const Case& c : kCases) {
        // Boxes and balls: coplanar neighbours and nearly coplanar ones.
        for (const Mesh& mesh : {test::make_ball(glm::vec3(0.0f), c.size, 10),
                                 test::make_box(glm::vec3(-c.size), glm::vec3(c.size))}) {
            glm::mat4x3 place(1.0f);
            place[3] = glm::vec3(c.distance, -0.4f * c.distance, 0.7f * c.distance);
            rc::SceneBuilder builder;
            builder.add({rc::build_blas(mesh.view()), place});
            const auto scene = builder.commit();
            Random random(31);
            int met = 0, left = 0;
            for (int i = 0; i < 10'000; ++i) {
                const glm::vec3 from = place[3] + random.direction() * c.ray_from * 3.0f;
                const rc::Ray ray{.origin = from,
                                  .direction = place[3] + random.in_cube(0.7f * c.size) - from};
                const auto hit = rc::closest_hit(*scene, ray, rc::kAllLayers);
                if (!hit) continue;
                ++left;
                const rc::SurfacePoint point = scene->surface(*hit);
                const glm::vec3 direction = leaving_direction(random, outwards(point, ray.direction), i);
                met += rc::any_hit(*scene, rc::spawn_ray(point, direction), rc::kAllLayers);
            }
            EXPECT_GT(left, 8000) << c.name;
            EXPECT_EQ(met, 0) << c.name << ", " << mesh.triangles.size() << " triangles";
        }
    }
}

TEST(SpawnRay, OnATiledFloorMeetsNoTile) {
    for (const float height : {0.0f, 1.7f, -300.0f}) {
        const Mesh floor = test::make_sheet(20.0f, height, 32);
        rc::SceneBuilder builder;
        builder.add({rc::build_blas(floor.view())});
        const auto scene = builder.commit();
        Random random(32);
        int met = 0;
        for (int i = 0; i < 20'000; ++i) {
            // Every other ray aims exactly at a joint of the tiles.
            const float cell = 1.25f * static_cast<float>(random.below(31) + 1) - 20.0f;
            const glm::vec3 target(i % 2 ? cell : random.between(-20, 20), height, random.between(-20, 20));
            const glm::vec3 from = random.in_cube(15.0f) + glm::vec3(0, height + 20.0f, 0);
            const auto hit =
                rc::closest_hit(*scene, {.origin = from, .direction = target - from}, rc::kAllLayers);
            ASSERT_TRUE(hit);
            const glm::vec3 direction = leaving_direction(random, glm::vec3(0, 1, 0), i);
            met += rc::any_hit(*scene, rc::spawn_ray(scene->surface(*hit), direction), rc::kAllLayers);
        }
        EXPECT_EQ(met, 0) << "floor at " << height;
    }
}

TEST(SpawnRay, ReachesItsTargetAndNotBeyond) {
    const Mesh room = test::make_box(glm::vec3(-2.0f), glm::vec3(2.0f));
    rc::SceneBuilder builder;
    builder.add({rc::build_blas(room.view())});
    const auto scene = builder.commit();
    Random random(33);
    for (int i = 0; i < 2000; ++i) {
        const auto hit =
            rc::closest_hit(*scene, {.origin = random.in_cube(1.5f), .direction = random.direction()}, 1);
        ASSERT_TRUE(hit);
        const rc::SurfacePoint point = scene->surface(*hit);
        const glm::vec3 lamp = random.in_cube(1.9f);
        const rc::Ray ray = rc::spawn_ray_to(point, lamp);
        EXPECT_EQ(ray.t_max, 1.0f);
        EXPECT_LT(glm::length(ray.origin + ray.direction - lamp), 1e-6f);
        EXPECT_FALSE(rc::any_hit(*scene, ray, rc::kAllLayers));  // inside a convex room nothing is in the way
    }
}

TEST(Surface, LiesWithinItsErrorBoundOfTheTruth) {
    Random random(34);
    const glm::mat4x3 place(0.3f, 0.1f, 0, -0.2f, 2.0f, 0.4f, 0, 0.1f, -1.5f, 40, -7, 3);
    const Mesh mesh = test::make_soup(random, 200, 3.0f, 1.0f);
    rc::SceneBuilder builder;
    builder.add({rc::build_blas(mesh.view()), place});
    const auto scene = builder.commit();
    int hits = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 from = place[3] + random.in_cube(8.0f);
        const auto hit = rc::closest_hit(*scene, {.origin = from, .direction = random.direction()}, 1);
        if (!hit) continue;
        ++hits;
        const rc::SurfacePoint point = scene->surface(*hit);
        const auto corners = scene->triangle(hit->instance, hit->primitive);
        const double b[3] = {(1.0 - double(hit->u)) - double(hit->v), double(hit->u), double(hit->v)};
        for (std::size_t r = 0; r < 3; ++r) {
            double truth = double(place[3][r]);
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t k = 0; k < 3; ++k)
                    truth += double(place[k][r]) * b[c] * double(corners[c][k]);
            EXPECT_LE(std::abs(truth - double(point.position[r])), double(point.position_error[r]));
        }
        EXPECT_NEAR(glm::length(point.normal), 1.0f, 1e-6f);
    }
    EXPECT_GT(hits, 400);
}

// Counter-clockwise corners seen from the tip, in the world: mirrors and squeezes included.
TEST(Surface, NormalFollowsTheCornersThroughMirrors) {
    const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    for (const auto& [place, normal] :
         {std::pair{glm::mat4x3(1.0f), glm::vec3(0, 0, 1)},
          {glm::mat4x3(-1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0), glm::vec3(0, 0, -1)},
          {glm::mat4x3(1, 0, 0, 0, 1, 0, 0, 0, -1, 0, 0, 0), glm::vec3(0, 0, 1)}}) {
        rc::SceneBuilder builder;
        builder.add({rc::build_blas(mesh.view()), place});
        EXPECT_EQ(
            builder.commit()->surface({.t = 1, .u = 0.2f, .v = 0.2f, .primitive = 0, .instance = 0}).normal,
            normal);
    }
}

}  // namespace
