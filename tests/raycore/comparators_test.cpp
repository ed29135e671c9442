// Three ways to look for a ray's hit that share nothing: raycore's tree, a uniform grid and a kD-tree. They must agree in
// every bit, in scenes too large for brute force.
#include "comparators/closest.h"
#include "support/isas.h"
#include "support/specification.h"

#include "raycore/query.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using comparators::closest;
using test::Mesh;
using test::Random;
using test::Specification;

struct World {
    const char* name;
    Mesh mesh;
    float half;  // rays start within twice this
};

Mesh thin_triangles(Random& random, int n) {
    Mesh mesh;
    for (int i = 0; i < n; ++i) {
        const glm::vec3 a = random.in_cube(2.0f), along = random.direction();
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), {a, a + along, a + random.direction() * 1e-5f});
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    return mesh;
}

Mesh teapot_in_a_stadium() {
    Mesh mesh = test::make_ball({0.3f, 0.2f, -0.1f}, 0.05f, 22);
    test::append(mesh, test::make_box(glm::vec3(-80), glm::vec3(80)));
    test::append(mesh, test::make_sheet(80.0f, 0.0f, 3));
    return mesh;
}

std::vector<World> worlds() {
    Random random(31);
    std::vector<World> all;
    all.push_back({"soup", test::make_soup(random, 6000, 3.0f, 0.3f), 3.0f});
    all.push_back({"slivers", thin_triangles(random, 4000), 2.0f});
    all.push_back({"teapot in a stadium", teapot_in_a_stadium(), 40.0f});
    all.push_back({"tiled floor", test::make_sheet(4.0f, 0.0f, 48), 4.0f});
    Mesh far = test::make_ball(glm::vec3(1e6f, -1e6f, 1e6f), 100.0f, 16);
    all.push_back({"ball 1e6 m away", std::move(far), 100.0f});
    Mesh tiny = test::make_soup(random, 2000, 1e-20f, 3e-21f);
    all.push_back({"soup of 1e-20 m", std::move(tiny), 1e-20f});
    return all;
}

// Aimed at vertices, along axes and anywhere; some from far away.
rc::Ray a_ray(Random& random, const World& world, int i) {
    const Mesh& mesh = world.mesh;
    const auto a_vertex = [&] {
        const glm::uvec3& t = mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
        return mesh.positions[t.x];
    };
    const glm::vec3 near = a_vertex();
    rc::Ray ray{.origin = near + random.in_cube(2.0f * world.half), .direction = random.direction()};
    if (i % 7 == 0) ray.origin = near + random.direction() * (1000.0f * world.half);
    if (i % 3 != 0) ray.direction = a_vertex() - ray.origin;
    if (i % 5 == 0) {
        ray.direction = glm::vec3(0.0f);
        ray.direction[random.below(3)] = random.below(2) == 0 ? 1.0f : -1.0f;
        ray.origin = a_vertex() - ray.direction * world.half;
    }
    if (i % 11 == 0) ray.t_max = random.unit();
    if (ray.direction == glm::vec3(0.0f)) ray.direction.x = 1;
    return ray;
}

class Comparators : public ::testing::TestWithParam<rc::Isa> {
  protected:
    test::IsaScope isa_{GetParam()};
};

TEST_P(Comparators, AGridAndAKdTreeAgreeWithRaycoreInEveryBit) {
    for (const World& world : worlds()) {
        const comparators::Soup soup(world.mesh.view());
        const comparators::UniformGrid grid(soup);
        const comparators::KdTree tree(soup);
        for (const rc::BuildQuality quality :
             {rc::BuildQuality::Fast, rc::BuildQuality::Default, rc::BuildQuality::High}) {
            rc::SceneBuilder builder;
            builder.add({rc::build_blas(world.mesh.view(), {quality})});
            const auto scene = builder.commit();
            Random random(32);
            int hits = 0;
            for (int i = 0; i < 600; ++i) {
                const rc::Ray ray = a_ray(random, world, i);
                const rc::Hit ours = rc::closest_hit(*scene, ray, rc::kAllLayers).value_or(rc::Hit{});
                ASSERT_TRUE(test::same_bits(ours, closest<Specification>(tree, ray)))
                    << world.name << " kD " << i;
                ASSERT_TRUE(test::same_bits(ours, closest<Specification>(grid, ray)))
                    << world.name << " grid " << i;
                ASSERT_EQ(rc::any_hit(*scene, ray, rc::kAllLayers), !ours.is_miss()) << world.name << i;
                hits += !ours.is_miss();
            }
            EXPECT_GT(hits, 150) << world.name;
        }
    }
}

// The oracles themselves, against no structure at all.
TEST(ComparatorsAlone, StructuresLoseNoTriangleThatBruteForceFinds) {
    for (const World& world : worlds()) {
        const comparators::Soup soup(world.mesh.view());
        const comparators::BruteForce all(soup);
        const comparators::UniformGrid grid(soup);
        const comparators::KdTree tree(soup);
        Random random(33);
        for (int i = 0; i < 60; ++i) {
            const rc::Ray ray = a_ray(random, world, i);
            const rc::Hit truth = closest<Specification>(all, ray);
            ASSERT_TRUE(test::same_bits(truth, closest<Specification>(tree, ray))) << world.name << i;
            ASSERT_TRUE(test::same_bits(truth, closest<Specification>(grid, ray))) << world.name << i;
        }
    }
}

// The other tests are right where it is easy: well inside a triangle of ordinary shape, to a few roundings.
TEST(ComparatorsAlone, EveryTriangleTestMeetsTheMiddleOfATriangle) {
    Random random(34);
    for (int i = 0; i < 500; ++i) {
        const comparators::Corners p{random.in_cube(1.0f), random.in_cube(1.0f) + glm::vec3(3, 0, 0),
                                     random.in_cube(1.0f) + glm::vec3(0, 3, 0)};
        rc::Ray ray{.origin = random.in_cube(1.0f) + glm::vec3(1, 1, 5)};
        ray.direction = (p[0] * 0.4f + p[1] * 0.35f + p[2] * 0.25f) - ray.origin;
        rc::Hit hits[4];
        ASSERT_TRUE(comparators::MoellerTrumbore<float>(ray)(p, hits[0]));
        ASSERT_TRUE(comparators::MoellerTrumbore<double>(ray)(p, hits[1]));
        ASSERT_TRUE(comparators::Woop(ray)(p, hits[2]));
        ASSERT_TRUE(Specification(ray)(p, hits[3]));
        for (const rc::Hit& hit : hits) {
            EXPECT_NEAR(hit.t, 1.0f, 4e-6f);
            EXPECT_NEAR(hit.u, 0.35f, 4e-6f);
            EXPECT_NEAR(hit.v, 0.25f, 4e-6f);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(EveryIsa, Comparators, ::testing::ValuesIn(test::supported_isas()),
                         test::isa_test_name);

}  // namespace
