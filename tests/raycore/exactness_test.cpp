// Truth from outside: a double-precision oracle on the unsheared triangle, and symmetry under powers of two.
#include "support/brute_force.h"
#include "support/isas.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using test::Mesh;
using test::Random;

struct Truth {
    double t, u, v;
};

// Moeller-Trumbore in double: another formula altogether.
Truth oracle(const rc::Ray& ray, const glm::vec3 (&p)[3]) {
    double o[3], d[3], e1[3], e2[3], s[3];
    for (std::size_t a = 0; a < 3; ++a) {
        o[a] = double(ray.origin[a]);
        d[a] = double(ray.direction[a]);
        e1[a] = double(p[1][a]) - double(p[0][a]);
        e2[a] = double(p[2][a]) - double(p[0][a]);
        s[a] = o[a] - double(p[0][a]);
    }
    const auto cross = [](const double* a, const double* b, double* out) {
        for (int i = 0; i < 3; ++i)
            out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    };
    const auto dot = [](const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    double h[3], q[3];
    cross(d, e2, h);
    cross(s, e1, q);
    const double det = dot(e1, h);
    return {dot(e2, q) / det, dot(s, h) / det, dot(d, q) / det};
}

// Cosines of incidence from 1 to 1e-7: t errs by a few roundings of the distances involved, seen along the ray.
TEST(Exactness, TFollowsTheOracleDownToGrazingRays) {
    Random random(12);
    for (const float cosine : {1.0f, 1e-2f, 1e-4f, 1e-6f, 1e-7f}) {
        int hits = 0;
        double worst = 0;
        for (int i = 0; i < 4000; ++i) {
            glm::vec3 p[3];
            for (glm::vec3& corner : p) corner = random.in_cube(1.0f);
            const glm::vec3 n = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
            const float u = random.between(0.2f, 0.4f), v = random.between(0.2f, 0.4f);
            const glm::vec3 target = p[0] + (p[1] - p[0]) * u + (p[2] - p[0]) * v;
            const glm::vec3 along = glm::normalize(p[1] - p[0]);
            rc::Ray ray{.direction = along * std::sqrt(1.0f - cosine * cosine) - n * cosine};
            ray.origin = target - ray.direction * 2.0f;
            const auto hit = test::meet_triangle(ray.origin, ray.direction, p);
            const Truth truth = oracle(ray, p);
            const bool well_inside = truth.u > 0.05 && truth.v > 0.05 && truth.u + truth.v < 0.95;
            if (!hit || !well_inside) continue;
            ++hits;
            // Corners are at most 4 m away; a displacement across the plane is 1 / cosine as long along the ray.
            const double incidence = std::abs(double(glm::dot(ray.direction, n)));
            const double bound = 8 * 0x1p-24 * 4.0 / incidence + 0x1p-23;
            worst = std::max(worst, std::abs(double(hit->t) - truth.t) / bound);
        }
        EXPECT_GT(hits, cosine < 1e-6f ? 20 : 500) << cosine;
        EXPECT_LT(worst, 1.0) << cosine;
    }
}

TEST(Exactness, SliversAMillionTimesLongerThanWideAreMetWhereTheyAre) {
    Random random(13);
    int met = 0, expected = 0;
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 a = random.in_cube(1.0f), along = random.direction(),
                        across = random.direction() * 1e-6f;
        const Mesh mesh{{a, a + along, a + across}, {{0, 1, 2}}};
        const glm::vec3 p[3] = {mesh.positions[0], mesh.positions[1], mesh.positions[2]};
        rc::Ray ray{.origin = random.in_cube(3.0f)};
        ray.direction = a + along * 0.3f + across * 0.35f - ray.origin;
        const Truth truth = oracle(ray, p);
        const auto hit = test::meet_triangle(ray.origin, ray.direction, p);
        met += hit.has_value();
        expected += truth.u > 0 && truth.v > 0 && truth.u + truth.v < 1;
        if (hit) {
            EXPECT_NEAR(double(hit->t), 1.0, 1e-4);
        }
    }
    // One rounding of a metre is a sixteenth of the sliver's width, so some go either way.
    EXPECT_NEAR(met, expected, 0.15 * 3000);
    EXPECT_GT(met, 1000);
}

class Scale : public ::testing::TestWithParam<rc::Isa> {
  protected:
    test::IsaScope isa_{GetParam()};
};

TEST_P(Scale, ByAPowerOfTwoChangesNoIdAndNoBarycentric) {
    Random random(14);
    Mesh mesh = test::make_soup(random, 300, 2.0f, 0.8f);
    test::append(mesh, test::make_ball({0.3f, 0.1f, 0}, 1.0f, 6));
    std::vector<rc::Ray> rays;
    for (int i = 0; i < 1500; ++i) {
        rc::Ray ray{.origin = random.in_cube(3.0f), .direction = random.direction()};
        if (i % 3 == 0) ray.direction = mesh.positions[random.below(900)] - ray.origin;
        rays.push_back(ray);
    }
    std::vector<rc::Hit> first;
    for (const int k : {0, 20, -20, 7, -33}) {
        const float scale = std::ldexp(1.0f, k);
        Mesh scaled = mesh;
        for (glm::vec3& p : scaled.positions) p *= scale;
        rc::SceneBuilder builder;
        builder.add({rc::build_blas(scaled.view())});
        const auto scene = builder.commit();
        std::vector<rc::Ray> asked = rays;
        for (rc::Ray& ray : asked) ray.origin *= scale;  // t scales with the scene, the direction does not
        std::vector<rc::Hit> hits(asked.size());
        rc::closest_hits(*scene, asked, rc::kAllLayers, hits);
        if (k == 0) first = hits;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            rc::Hit expected = first[i];
            expected.t *= scale;
            ASSERT_TRUE(test::same_bits(hits[i], expected)) << "2^" << k << " ray " << i;
        }
        EXPECT_GT(std::count_if(hits.begin(), hits.end(), [](const rc::Hit& h) { return !h.is_miss(); }),
                  500);
    }
}

// A leaning tower of instances at 1e6 m: decided in their own frames, so as sharp as at home.
TEST_P(Scale, AnInstanceMovedFarAwayWithItsRaysKeepsItsHits) {
    const Mesh ball = test::make_ball(glm::vec3(0.0f), 2.0f, 8);
    Random random(15);
    for (const float distance : {1e3f, 1e5f, 1e6f}) {
        rc::SceneBuilder builder;
        glm::mat4x3 far(1.0f);
        far[3] = glm::vec3(distance, -distance, 0.5f * distance);
        const auto blas = rc::build_blas(ball.view());
        builder.add({blas});
        const auto near_scene = builder.commit();
        builder.set_transform(0, far);
        const auto far_scene = builder.commit();
        for (int i = 0; i < 500; ++i) {
            rc::Ray ray{.origin = random.in_cube(4.0f), .direction = random.direction()};
            ray.origin = (ray.origin + far[3]) - far[3];  // representable there
            rc::Ray moved = ray;
            moved.origin += far[3];
            const auto here = rc::closest_hit(*near_scene, ray, 1),
                       there = rc::closest_hit(*far_scene, moved, 1);
            ASSERT_TRUE(test::same_bits(here.value_or(rc::Hit{}), there.value_or(rc::Hit{})))
                << distance << " " << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(EveryIsa, Scale, ::testing::ValuesIn(test::supported_isas()), test::isa_test_name);

}  // namespace
