// What must not make a difference, does not: who asks, on how many threads, whether a thing is placed or baked, how near a
// ray grazes, how thin a gap is.
#include "support/isas.h"

#include "raycore/every_way.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <thread>

namespace test {
namespace {

constexpr rc::LayerMask kAll = rc::kAllLayers;

TestScene a_hall(rc::BuildQuality quality) {
    Random random(111);
    TestScene scene(quality);
    scene.add(make_ball(glm::vec3(0.0f), 2.0f, 10));
    scene.add(make_soup(random, 300, 3.0f, 0.7f),
              glm::mat4x3(0.6f, 0.8f, 0, -0.8f, 0.6f, 0, 0, 0, -1, 1, 0, 0));
    scene.add(make_sheet(4.0f, -2.0f, 8));
    scene.commit();
    return scene;
}

std::vector<rc::Ray> rays_in_the_hall(int count) {
    Random random(112);
    std::vector<rc::Ray> rays;
    for (int i = 0; i < count; ++i)
        rays.push_back(
            {.origin = random.in_cube(4.0f), .direction = random.direction() * random.between(0.1f, 3.0f)});
    return rays;
}

// The renderer, a guard, a sound and a foot put one question each from a thread of their own.
TEST(Agreement, ManyThreadsAskingAtOnceGetTheSameBits) {
    const TestScene hall = a_hall(rc::BuildQuality::Default);
    const std::vector<rc::Ray> rays = rays_in_the_hall(2000);
    std::vector<rc::Hit> expected(rays.size());
    rc::closest_hits(hall.scene(), rays, kAll, expected);
    std::vector<int> wrong(4, 0);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < wrong.size(); ++t) {
        threads.emplace_back([&, t] {
            const std::size_t batch = 1 + 7 * t;
            std::vector<rc::Hit> hits(batch), crossing(1);
            for (std::size_t i = 0; i + batch <= rays.size(); i += batch) {
                rc::closest_hits(hall.scene(), std::span(rays).subspan(i, batch), kAll, hits);
                for (std::size_t k = 0; k < batch; ++k) {
                    wrong[t] += !same_bits(hits[k], expected[i + k]);
                    wrong[t] += rc::any_hit(hall.scene(), rays[i + k], kAll) == expected[i + k].is_miss();
                }
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

// A statue placed by a transform stands where one whose vertices were moved stands.
TEST(Agreement, PlacedAndBakedGeometryAreMetAlike) {
    const Mesh statue = make_ball({0.3f, 0.1f, 0}, 1.0f, 8);
    const glm::mat4x3 places[] = {glm::mat4x3(0.6f, 0.8f, 0, -0.8f, 0.6f, 0, 0, 0, 1, 1, 2, -1),
                                  glm::mat4x3(-1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5f, 0, 0),
                                  glm::mat4x3(3, 0, 0, 0, 0.25f, 0, 0, 0, 1, 0, 0, 0),
                                  glm::mat4x3(1, 0.5f, 0, 0.2f, 1, 0, -0.3f, 0, 1, 0, 1, 0)};
    for (const glm::mat4x3& m : places) {
        Mesh baked = statue;
        for (glm::vec3& p : baked.positions) p = ((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3];
        rc::SceneBuilder a, b;
        a.add({rc::build_blas(statue.view()), m});
        b.add({rc::build_blas(baked.view())});
        const auto placed = a.commit(), moved = b.commit();
        Random random(113);
        int met = 0, other_triangle = 0;
        for (int i = 0; i < 1500; ++i) {
            rc::Ray ray{.origin = m[3] + random.in_cube(4.0f)};
            ray.direction =
                glm::normalize(baked.positions[random.below(40)] + random.in_cube(0.3f) - ray.origin);
            const auto x = rc::closest_hit(*placed, ray, kAll), y = rc::closest_hit(*moved, ray, kAll);
            if (x.has_value() != y.has_value()) {
                ++other_triangle;  // within rounding of the outline
                continue;
            }
            if (!x) continue;
            ++met;
            other_triangle += x->primitive != y->primitive;
            const glm::vec3 n = placed->surface(*x).normal;
            const float cosine = std::abs(glm::dot(n, ray.direction));
            EXPECT_NEAR(x->t, y->t, 1e-5f * std::max(1.0f, 0.1f / cosine));
        }
        EXPECT_GT(met, 200);
        EXPECT_LE(other_triangle, 2) << "only what meets an edge to within rounding may differ";
    }
}

// Along a floor of a thousand tiles at cosines down to 1e-7: any and closest agree, and so does every instruction set.
TEST(Agreement, GrazingRaysMeetTheSameForEveryone) {
    for (const rc::BuildQuality quality : kQualities) {
        Random random(114);
        TestScene scene(quality);
        Mesh floor = make_sheet(8.0f, 0.0f, 12);
        for (glm::vec3& p : floor.positions) p.y = 1e-3f * random.unit();
        scene.add(floor, glm::mat4x3(0.8f, 0.6f, 0, -0.6f, 0.8f, 0, 0, 0, 1, 3, 1, 2));
        scene.commit();
        std::vector<rc::Ray> rays;
        for (const float cosine : {1e-2f, 1e-3f, 1e-4f, 1e-5f, 1e-6f, 1e-7f}) {
            for (int i = 0; i < 40; ++i) {
                const float angle = 6.28f * random.unit();
                const glm::vec3 along(std::cos(angle), -cosine, std::sin(angle));
                const glm::vec3 local = random.in_cube(6.0f) * glm::vec3(1, 0, 1) - along * 4.0f;
                const auto turned = [](const glm::vec3& v) {
                    return glm::vec3(0.8f * v.x - 0.6f * v.y, 0.6f * v.x + 0.8f * v.y, v.z);
                };
                rays.push_back({.origin = turned(local) + glm::vec3(3, 1, 2), .direction = turned(along)});
            }
        }
        EXPECT_GT(expect_every_way(scene, rays, "grazing"), 60);
    }
}

// Two panes a gap apart, a metre wide: what leaves one towards the other meets it. At a millionth of a metre, 2 m from
// the origin, the start's own error bound (four roundings of the position) reaches across.
TEST(Agreement, NoLightSlipsThroughAThinGap) {
    for (const float gap : {1e-2f, 1e-3f, 1e-4f, 1e-5f}) {
        Random random(115);
        const Mesh pane = make_sheet(0.5f, 0.0f, 7);
        Mesh both = pane;
        append(both, pane);
        for (std::size_t i = pane.positions.size(); i < both.positions.size(); ++i) both.positions[i].y = gap;
        rc::SceneBuilder builder;
        builder.add(
            {rc::build_blas(both.view()), glm::mat4x3(0.6f, 0.8f, 0, -0.8f, 0.6f, 0, 0, 0, 1, 1, -2, 0.5f)});
        const auto scene = builder.commit();
        const auto in_world = [&](const glm::vec3& p) {
            const glm::mat4x3& m = scene->instance(0).world_from_instance;
            return ((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3];
        };
        int leaks = 0, left = 0;
        for (int i = 0; i < 3000; ++i) {
            const glm::vec3 on = random.in_cube(0.4f) * glm::vec3(1, 0, 1);
            const auto hit = rc::closest_hit(*scene,
                                             {.origin = in_world(on - glm::vec3(0, 1, 0)),
                                              .direction = in_world(on) - in_world(on - glm::vec3(0, 1, 0))},
                                             kAll);
            ASSERT_TRUE(hit);
            ASSERT_LT(hit->primitive, pane.triangles.size()) << "the lower pane";
            const glm::vec3 up = in_world({0, 1, 0}) - in_world({0, 0, 0});
            const rc::Ray ray =
                rc::spawn_ray(scene->surface(*hit), glm::normalize(up + random.in_cube(0.3f)));
            const auto next = rc::closest_hit(*scene, ray, kAll);
            ++left;
            leaks += !next || next->primitive < pane.triangles.size();
        }
        EXPECT_EQ(leaks, 0) << "of " << left << " through a gap of " << gap;
    }
}

// Directions whose products vanish, limits that are infinite, origins on a slab of the tree.
TEST(Agreement, ZerosInfinitiesAndSlabs) {
    std::vector<rc::Ray> rays;
    for (const float x : {0.0f, -0.0f, 1e-45f, -1e-45f, 1e-38f, 1.0f, -1.0f}) {
        for (const float y : {0.0f, -0.0f, 1e-40f, -1.0f}) {
            for (const float z : {0.0f, -0.0f, 1.0f}) {
                if (glm::vec3(x, y, z) == glm::vec3(0.0f)) continue;
                for (const glm::vec3 from :
                     {glm::vec3(0), glm::vec3(2, 0, 0), glm::vec3(-4, -2, -4), glm::vec3(1, -2, 1)})
                    for (const float far : {rc::kInfinity, 3e38f, 1.0f})
                        rays.push_back({.origin = from, .direction = {x, y, z}, .t_min = -far, .t_max = far});
            }
        }
    }
    for (const rc::BuildQuality quality : kQualities)
        EXPECT_GT(expect_every_way(a_hall(quality), rays, "zeros and infinities"), 100);
}

}  // namespace
}  // namespace test
