// What is wrong with a mesh is counted and never met; what is wrong with a ray traps in development and is a miss in
// release.
#include "support/isas.h"
#include "support/shapes.h"

#include "raycore/query.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::shared_ptr<const rc::Scene> scene_of(const test::Mesh& mesh) {
    rc::SceneBuilder builder;
    builder.add({rc::build_blas(mesh.view())});
    return builder.commit();
}

TEST(BadMesh, EveryFaultIsCountedOnceUnderItsFirstReason) {
    test::Mesh mesh = test::make_sheet(1.0f, 0.0f, 1);
    mesh.positions.emplace_back(kNan, 0, 0);
    mesh.positions.emplace_back(0, -rc::kInfinity, 0);
    mesh.positions.emplace_back(1e19f, 0, 0);
    mesh.triangles.emplace_back(0, 1, 99);           // out of range
    mesh.triangles.emplace_back(4, 4, 0xFFFFFFFFu);  // out of range before NaN
    mesh.triangles.emplace_back(0, 1, 4);            // NaN
    mesh.triangles.emplace_back(0, 5, 1);            // infinite
    mesh.triangles.emplace_back(0, 6, 1);            // beyond 2^60
    mesh.triangles.emplace_back(0, 0, 1);            // no area
    const rc::MeshReport report = rc::check_mesh(mesh.view());
    EXPECT_EQ(report.triangles, 8u);
    EXPECT_EQ(report.index_out_of_range, 2u);
    EXPECT_EQ(report.not_finite, 3u);
    EXPECT_EQ(report.zero_area, 1u);
    EXPECT_EQ(report.kept(), 2u);

    const auto blas = rc::build_blas(mesh.view());
    EXPECT_EQ(blas->report().kept(), 2u);
    EXPECT_EQ(blas->bounds().max.x, 1.0f);
    const auto hit =
        rc::closest_hit(*scene_of(mesh), {.origin = {0.9f, 1, 0.9f}, .direction = {0, -1, 0}}, 1);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->primitive, 1u);  // ids do not move up
}

TEST(BadMesh, NothingButBadTrianglesIsAnEmptyBlas) {
    const test::Mesh mesh{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}, {0, 0, 0}}};
    const auto blas = rc::build_blas(mesh.view());
    EXPECT_EQ(blas->report().zero_area, 2u);
    EXPECT_GT(blas->bounds().min.x, blas->bounds().max.x);
    EXPECT_EQ(scene_of(mesh)->dropped_instances(), 1u);
}

TEST(BadMesh, ATriangleOfAnAtomsSizeOrAStarSystemsIsKept) {
    for (const float size : {1e-22f, 1e15f}) {
        const test::Mesh mesh{{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}}};
        const auto hit = rc::closest_hit(*scene_of(mesh), {.origin = {0.25f * size, 0.25f * size, -size}}, 1);
        ASSERT_TRUE(hit) << size;
        EXPECT_EQ(hit->u, 0.25f);
        EXPECT_EQ(hit->t, size);
    }
}

std::vector<rc::Ray> bad_rays() {
    std::vector<rc::Ray> rays;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const float bad : {kNan, rc::kInfinity, -rc::kInfinity}) {
            rc::Ray ray;
            ray.origin[axis] = bad;
            rays.push_back(ray);
            ray = {};
            ray.direction[axis] = bad;
            rays.push_back(ray);
        }
    }
    rays.push_back({.direction = glm::vec3(0.0f)});
    rays.push_back({.direction = {-0.0f, 0.0f, -0.0f}});
    rays.push_back({.t_min = 2.0f, .t_max = 1.0f});
    rays.push_back({.t_min = kNan});
    rays.push_back({.t_max = kNan});
    return rays;
}

class BadRay : public ::testing::TestWithParam<rc::Isa> {
  protected:
    test::IsaScope isa_{GetParam()};
    std::shared_ptr<const rc::Scene> scene_ = scene_of(test::make_box(glm::vec3(-1), glm::vec3(1)));
};

#ifdef RC_CONTRACTS
TEST_P(BadRay, TrapsInDevelopment) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const rc::Ray zero{.direction = glm::vec3(0.0f)}, backwards{.t_min = 2.0f, .t_max = 1.0f},
        nan{.t_max = kNan};
    EXPECT_DEATH((void)rc::closest_hit(*scene_, zero, 1), "direction that is not zero");
    EXPECT_DEATH((void)rc::any_hit(*scene_, backwards, 1), "t_min <= t_max");
    EXPECT_DEATH((void)rc::any_hit(*scene_, nan, 1), "t_min <= t_max");
    rc::Hit hit;
    EXPECT_DEATH((void)rc::crossings(*scene_, glm::vec3(1), glm::vec3(1), 1, std::span(&hit, 1)),
                 "direction");
}
#else
TEST_P(BadRay, IsAMissInRelease) {
    const std::vector<rc::Ray> rays = bad_rays();
    for (const rc::Ray& ray : rays) {
        EXPECT_FALSE(rc::closest_hit(*scene_, ray, rc::kAllLayers));
        EXPECT_FALSE(rc::any_hit(*scene_, ray, rc::kAllLayers));
    }
    std::vector<rc::Hit> hits(rays.size(), rc::Hit{.t = 1, .primitive = 7, .instance = 7});
    rc::closest_hits(*scene_, rays, rc::kAllLayers, hits);
    for (const rc::Hit& hit : hits) {
        EXPECT_TRUE(hit.is_miss());
        EXPECT_EQ(hit.t, rc::kInfinity);
        EXPECT_EQ(hit.instance, rc::kNone);
    }
    rc::Hit hit;
    EXPECT_EQ(rc::crossings(*scene_, glm::vec3(1), glm::vec3(1), 1, std::span(&hit, 1)), 0u);
}
#endif

// Whichever way the library was built, a good ray in a batch with odd intervals is answered.
TEST_P(BadRay, InfiniteIntervalsAreNotBad) {
    const rc::Ray both_ways{.origin = {0.1f, 0.2f, 0.3f}, .t_min = -rc::kInfinity, .t_max = rc::kInfinity};
    const auto hit = rc::closest_hit(*scene_, both_ways, rc::kAllLayers);
    ASSERT_TRUE(hit);
    EXPECT_FLOAT_EQ(hit->t, -1.3f);
    EXPECT_FALSE(rc::any_hit(*scene_, {.t_min = rc::kInfinity}, rc::kAllLayers));
    EXPECT_EQ(bad_rays().size(), 23u);
}

INSTANTIATE_TEST_SUITE_P(EveryIsa, BadRay, ::testing::ValuesIn(test::supported_isas()), test::isa_test_name);

}  // namespace
