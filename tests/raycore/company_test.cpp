// What a ray meets does not depend on the rays that are asked with it: bundles that run together and are walked as
// packets, bundles that almost do, and crowds, must say what each ray is told alone. A guard's look is in one batch with
// the renderer's or in none, and a replay must not know.
#include "support/isas.h"
#include "support/shapes.h"

#include "raycore/query.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

namespace {

using test::Mesh;
using test::Random;

class Company : public ::testing::TestWithParam<rc::Isa> {};

// Rays from about `from` to points on the mesh near one of its triangles, half of them aimed at corners and edges.
std::vector<rc::Ray> make_bundle(const Mesh& mesh, const glm::vec3& from, float foot, float spread,
                                 std::size_t n, Random& random) {
    const auto target = random.below(static_cast<std::uint32_t>(mesh.triangles.size()));
    const glm::vec3 middle = mesh.positions[mesh.triangles[target].x];
    const float reach = glm::length(middle - from) * spread;
    std::vector<rc::Ray> rays;
    for (std::size_t i = 0; i < n; ++i) {
        rc::Ray ray{.origin = from + random.in_cube(foot),
                    .direction = middle + random.in_cube(reach) - from};
        const std::uint32_t near =
            (target + random.below(9)) % static_cast<std::uint32_t>(mesh.triangles.size());
        const glm::uvec3& t = mesh.triangles[near];
        if (i % 4 == 0) ray.direction = mesh.positions[t.x] - ray.origin;
        if (i % 4 == 1) ray.direction = (mesh.positions[t.x] + mesh.positions[t.y]) * 0.5f - ray.origin;
        if (i % 16 == 2) ray.direction.x = i % 32 == 2 ? 0.0f : -0.0f;
        if (i % 8 == 3) ray.t_max = random.between(0.5f, 1.5f);
        if (i % 8 == 7) ray.t_min = random.between(0.0f, 1.1f);
        if (i % 8 == 5) {
            ray.skip_instance = random.below(2);
            ray.skip_primitive = near;
        }
        if (ray.direction == glm::vec3(0.0f)) ray.direction.y = 1.0f;
        rays.push_back(ray);
    }
    return rays;
}

// How many of the rays meet something.
std::size_t expect_same_as_alone(const rc::Scene& scene, const std::vector<rc::Ray>& rays,
                                 rc::LayerMask layers, rc::Isa isa) {
    std::vector<rc::Hit> together(rays.size()), alone(rays.size());
    std::vector<std::uint8_t> any_together(rays.size());
    {
        const test::IsaScope scope(isa);
        rc::closest_hits(scene, rays, layers, together);
        rc::any_hits(scene, rays, layers, any_together);
    }
    const test::IsaScope scope(rc::Isa::Scalar);
    std::size_t hits = 0, wrong_closest = 0, wrong_any = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        alone[i] = rc::closest_hit(scene, rays[i], layers).value_or(rc::Hit{});
        wrong_closest += std::memcmp(&alone[i], &together[i], sizeof(rc::Hit)) != 0;
        wrong_any += (any_together[i] != 0) != rc::any_hit(scene, rays[i], layers);
        hits += !alone[i].is_miss();
    }
    EXPECT_EQ(wrong_closest, 0u) << rays.size() << " rays together, closest";
    EXPECT_EQ(wrong_any, 0u) << rays.size() << " rays together, any";
    return hits;
}

constexpr std::size_t kSizes[] = {2, 15, 16, 17, 40, 63, 64, 65, 130, 256};

TEST_P(Company, ABundleIsToldWhatEachOfItsRaysIsToldAlone) {
    Random random(77);
    for (const float scale : {1.0f, 1e-4f, 3e5f}) {
        Mesh mesh = test::make_ball(glm::vec3(0.3f) * scale, scale, 24);
        test::append(mesh, test::make_box(glm::vec3(-3 * scale), glm::vec3(3 * scale)));
        const Mesh once = mesh;
        test::append(mesh, once);  // every triangle twice: ties
        rc::SceneBuilder builder;
        builder.add({rc::build_blas(mesh.view())});
        const auto scene = builder.commit();
        std::size_t hits = 0, asked = 0;
        for (const std::size_t n : kSizes) {
            for (const float foot : {0.0f, 0.02f, 1.0f}) {
                for (const float spread : {0.0f, 0.02f, 0.1f, 1.0f}) {
                    const glm::vec3 from = random.in_cube(2.5f * scale);
                    hits +=
                        expect_same_as_alone(*scene, make_bundle(mesh, from, foot * scale, spread, n, random),
                                             rc::kAllLayers, GetParam());
                    asked += n;
                }
            }
        }
        EXPECT_GT(hits, asked / 2) << "scale " << scale;
    }
}

// Rays from about `from` that go every way, some no farther than a little, some into corners, a few along axes.
std::vector<rc::Ray> make_crowd(const Mesh& mesh, const glm::vec3& from, float foot, float reach,
                                std::size_t n, Random& random) {
    std::vector<rc::Ray> rays;
    for (std::size_t i = 0; i < n; ++i) {
        rc::Ray ray{.origin = from + random.in_cube(foot), .direction = random.direction() * reach};
        if (i % 4 == 0)
            ray.direction = mesh.positions[random.below(std::uint32_t(mesh.positions.size()))] - ray.origin;
        if (i % 8 == 1) ray.direction = {i % 16 == 1 ? 0.0f : -0.0f, i % 32 < 16 ? reach : -reach, 0.0f};
        if (i % 16 == 6) ray.direction *= 1e-30f;  // too slow to walk in company
        if (i % 2 == 1) ray.t_max = random.between(0.0f, 1.5f);
        if (i % 16 == 10) ray.t_min = random.between(-1.0f, 0.5f);
        if (ray.direction == glm::vec3(0.0f)) ray.direction.y = reach;
        ray.skip_primitive = random.below(std::uint32_t(mesh.triangles.size()));
        ray.skip_instance = i % 8 == 5 ? 0u : rc::kNone;
        rays.push_back(ray);
    }
    return rays;
}

// A pixel's neighbours ask for shade and for lamps from nearly the same spot, whichever way they look.
TEST_P(Company, ACrowdFromOneSpotIsToldWhatEachOfItsRaysIsToldAlone) {
    Random random(80);
    for (const float scale : {1.0f, 1e-4f, 3e5f}) {
        Mesh mesh = test::make_ball(glm::vec3(0.3f) * scale, scale, 24);
        test::append(mesh, test::make_box(glm::vec3(-3 * scale), glm::vec3(3 * scale)));
        const auto blas = rc::build_blas(mesh.view());
        rc::SceneBuilder one, several;
        one.add({blas});
        several.add({blas});
        several.add({blas, glm::mat4x3(0.5f, 0, 0, 0, 0, 0.5f, 0, -0.5f, 0, scale, 0, 0)});
        several.add({blas, glm::mat4x3(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, scale, 0)});
        const auto alone = one.commit(), among = several.commit();
        std::size_t hits = 0, asked = 0;
        for (const std::size_t n : kSizes) {
            for (const float foot : {0.0f, 0.05f, 0.5f}) {
                for (const float reach : {0.3f, 3.0f}) {
                    const glm::vec3 from = random.in_cube(2.5f * scale);
                    const auto rays = make_crowd(mesh, from, foot * scale, reach * scale, n, random);
                    hits += expect_same_as_alone(*alone, rays, rc::kAllLayers, GetParam());
                    hits += expect_same_as_alone(*among, rays, rc::kAllLayers, GetParam());
                    asked += 2 * n;
                }
            }
        }
        EXPECT_GT(hits, asked / 3) << "scale " << scale;
        EXPECT_LT(hits, asked) << "scale " << scale;
    }
}

TEST_P(Company, HoldsAcrossInstancesTiesAndLayers) {
    Random random(78);
    const Mesh ball = test::make_ball(glm::vec3(0.0f), 1.0f, 16);
    const auto blas = rc::build_blas(ball.view());
    rc::SceneBuilder builder;
    const glm::mat4x3 moved(1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5f, 0, 0),
        turned(0, 0, -1, 0, 1, 0, 1, 0, 0, -1.2f, 0.3f, 0),
        squashed(1, 0.2f, 0, 0, -0.5f, 0, 0.1f, 0, 2, 0, 1.5f, 1);
    // The same place twice, the lower id on another layer: ties between instances.
    for (const glm::mat4x3& place : {moved, glm::mat4x3(1.0f), turned, moved, glm::mat4x3(1.0f), squashed})
        builder.add({blas, place, builder.size() < 2 ? 1u : 2u});
    for (int i = 0; i < 40; ++i) {
        glm::mat4x3 place(0.2f);
        place[3] = random.in_cube(3.0f);
        builder.add({blas, place, 1u << (i % 3)});
    }
    const auto scene = builder.commit();
    std::size_t hits = 0;
    for (const std::size_t n : kSizes) {
        for (const float spread : {0.01f, 0.1f, 0.4f}) {
            for (const rc::LayerMask layers : {rc::kAllLayers, 2u, 8u}) {
                const glm::vec3 from = random.in_cube(5.0f);
                hits += expect_same_as_alone(*scene, make_bundle(ball, from, 0.02f, spread, n, random),
                                             layers, GetParam());
            }
        }
    }
    EXPECT_GT(hits, 2000u);
}

// One bad ray must not spoil the bundle, nor the bundle answer for it.
TEST_P(Company, ABadRayAmongGoodOnesMissesAlone) {
#ifdef RC_CONTRACTS
    GTEST_SKIP() << "bad rays trap in this build";
#endif
    const Mesh ball = test::make_ball(glm::vec3(0.0f), 1.0f, 16);
    rc::SceneBuilder builder;
    builder.add({rc::build_blas(ball.view())});
    const auto scene = builder.commit();
    Random random(79);
    for (const float bad : {std::nanf(""), rc::kInfinity}) {
        std::vector<rc::Ray> rays = make_bundle(ball, {0, 0, 4}, 0.01f, 0.05f, 64, random);
        rays[17].direction.y = bad;
        rays[40].origin.x = bad;
        rays[41].direction = glm::vec3(0.0f);
        rays[42].t_max = std::nanf("");
        rays[43].t_min = -5.0f;
        EXPECT_GT(expect_same_as_alone(*scene, rays, rc::kAllLayers, GetParam()), 30u);
    }
}

// What the boxes of instances forgive grows with the farthest origin of the packet. When the last ray's origin was no
// number, nor was that, and nobody met anything.
TEST_P(Company, ARayFromNowhereSpoilsNoneAmongInstances) {
#ifdef RC_CONTRACTS
    GTEST_SKIP() << "bad rays trap in this build";
#endif
    const Mesh ball = test::make_ball(glm::vec3(0.0f), 1.0f, 16);
    const auto blas = rc::build_blas(ball.view());
    rc::SceneBuilder builder;
    for (const float x : {-0.5f, 0.5f, 3.0f})
        builder.add({blas, glm::mat4x3(1, 0, 0, 0, 1, 0, 0, 0, 1, x, 0.25f, 0)});
    const auto scene = builder.commit();
    Random random(80);
    for (const float bad : {std::nanf(""), rc::kInfinity}) {
        for (const std::size_t which : {std::size_t{0}, std::size_t{31}, std::size_t{63}}) {
            std::vector<rc::Ray> rays = make_bundle(ball, {0, 0, 4}, 0.01f, 0.05f, 64, random);
            rays[which].origin = glm::vec3(bad);
            EXPECT_GT(expect_same_as_alone(*scene, rays, rc::kAllLayers, GetParam()), 30u);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(EveryIsa, Company, ::testing::ValuesIn(test::supported_isas()), test::isa_test_name);

}  // namespace
