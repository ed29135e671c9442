// A skinned guard moves every tick: his refitted tree answers exactly as a tree built anew would.
#include "support/brute_force.h"
#include "support/isas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using test::Mesh;
using test::Random;

std::shared_ptr<const rc::Scene> scene_of(std::shared_ptr<const rc::Blas> blas) {
    rc::SceneBuilder builder;
    builder.add({std::move(blas)});
    return builder.commit();
}

int differing_answers(const rc::Scene& a, const rc::Scene& b, std::uint64_t seed, int* met = nullptr) {
    Random random(seed);
    int differing = 0;
    for (int i = 0; i < 2000; ++i) {
        const rc::Ray ray{.origin = random.in_cube(3.0f), .direction = random.direction()};
        const auto ha = rc::closest_hit(a, ray, rc::kAllLayers), hb = rc::closest_hit(b, ray, rc::kAllLayers);
        differing += !test::same_bits(ha.value_or(rc::Hit{}), hb.value_or(rc::Hit{}));
        if (met != nullptr) *met += ha.has_value();
    }
    return differing;
}

Mesh bent(const Mesh& mesh, float amount) {
    Mesh out = mesh;
    for (glm::vec3& p : out.positions) p += glm::vec3(amount * p.y * p.y, amount * p.x * p.z, -amount * p.x);
    return out;
}

TEST(Refit, AnswersAsARebuildInEveryBit) {
    const Mesh ball = test::make_ball(glm::vec3(0.0f), 1.5f, 12);
    const auto blas = rc::build_blas(ball.view());
    for (const float amount : {0.1f, 0.7f, -1.3f, 0.0f}) {
        const Mesh moved = bent(ball, amount);
        rc::refit_blas(*blas, moved.positions);
        int met = 0;
        EXPECT_EQ(differing_answers(*scene_of(blas), *scene_of(rc::build_blas(moved.view())), 1, &met), 0)
            << amount;
        EXPECT_GT(met, 200);
    }
    EXPECT_FLOAT_EQ(blas->refit_degradation(), 1.0f);  // back where it was built
}

// A door's leaf and its frame meet where the door is shut, corner on corner; corners that are several vertices must not
// stick together when it opens.
TEST(Refit, CornersThatLieAtOnePlaceMayPart) {
    Random random(8);
    Mesh apart = test::parted(test::make_ball(glm::vec3(0.0f), 1.5f, 6));
    const auto blas = rc::build_blas(apart.view(), {rc::BuildQuality::High, true});
    for (std::size_t i = 0; i < apart.positions.size(); i += 3) {
        const glm::vec3 away = random.in_cube(0.3f);
        for (std::size_t k = 0; k < 3; ++k) apart.positions[i + k] += away;
    }
    ASSERT_TRUE(rc::refit_blas(*blas, apart.positions));
    int met = 0;
    EXPECT_EQ(differing_answers(*scene_of(blas), *scene_of(rc::build_blas(apart.view())), 3, &met), 0);
    EXPECT_GT(met, 200);
}

TEST(Refit, DegradationTellsWhenToRebuild) {
    Random random(2);
    Mesh soup = test::make_soup(random, 2000, 2.0f, 0.1f);
    const auto blas = rc::build_blas(soup.view());
    for (std::size_t i = 0; i < soup.positions.size(); i += 3) {  // every triangle flies somewhere else
        const glm::vec3 away = random.in_cube(2.0f);
        for (std::size_t k = 0; k < 3; ++k) soup.positions[i + k] += away;
    }
    rc::refit_blas(*blas, soup.positions);
    EXPECT_GT(blas->refit_degradation(), 1.3f);
    EXPECT_EQ(differing_answers(*scene_of(blas), *scene_of(rc::build_blas(soup.view())), 3), 0);
}

TEST(Refit, ATriangleIsNotMetWhileItIsNotFinite) {
    Mesh ball = test::make_ball(glm::vec3(0.0f), 1.0f, 4);
    const auto blas = rc::build_blas(ball.view());
    const rc::Ray ray{.origin = {0.1f, 0.2f, 0.3f}, .direction = {0.3f, 0.9f, 0.1f}};
    const auto before = rc::closest_hit(*scene_of(blas), ray, rc::kAllLayers);
    ASSERT_TRUE(before);
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), rc::kInfinity, -rc::kInfinity, 1e30f}) {
        Mesh broken = ball;
        broken.positions[broken.triangles[before->primitive].y].x = bad;
        rc::refit_blas(*blas, broken.positions);
        const auto scene = scene_of(blas);
        EXPECT_FALSE(rc::closest_hit(*scene, ray, rc::kAllLayers));
        EXPECT_LE(scene->bounds().max.x, 1.01f);
        EXPECT_EQ(differing_answers(*scene, *scene_of(rc::build_blas(broken.view())), 4), 0) << bad;
    }
    rc::refit_blas(*blas, ball.positions);
    EXPECT_TRUE(test::same_bits(*rc::closest_hit(*scene_of(blas), ray, rc::kAllLayers), *before));
}

TEST(Refit, SurvivesCollapseToAPointAndFlyingAway) {
    const Mesh ball = test::make_ball(glm::vec3(0.0f), 1.0f, 6);
    const auto blas = rc::build_blas(ball.view());
    const std::vector<glm::vec3> point(ball.positions.size(), glm::vec3(0.5f));
    rc::refit_blas(*blas, point);
    EXPECT_GT(blas->bounds().min.x, blas->bounds().max.x);
    EXPECT_EQ(scene_of(blas)->dropped_instances(), 1u);

    Mesh away = ball;
    for (glm::vec3& p : away.positions) p += glm::vec3(1e6f);
    rc::refit_blas(*blas, away.positions);
    EXPECT_EQ(differing_answers(*scene_of(blas), *scene_of(rc::build_blas(away.view())), 5), 0);
    rc::refit_blas(*blas, ball.positions);
    EXPECT_EQ(differing_answers(*scene_of(blas), *scene_of(rc::build_blas(ball.view())), 6), 0);
}

TEST(Refit, ADroppedTriangleStaysDropped) {
    Mesh mesh = test::make_sheet(1.0f, 0.0f, 2);
    const std::vector<glm::vec3> flat = mesh.positions;
    mesh.positions[0] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
    const auto blas = rc::build_blas(mesh.view());
    const std::size_t dropped = blas->report().dropped();
    ASSERT_GT(dropped, 0u);
    rc::refit_blas(*blas, flat);
    EXPECT_FALSE(rc::any_hit(*scene_of(blas), {.origin = {-0.9f, 1, -0.9f}, .direction = {0, -1, 0}}, 1));
    EXPECT_TRUE(rc::any_hit(*scene_of(blas), {.origin = {0.9f, 1, 0.9f}, .direction = {0, -1, 0}}, 1));
    EXPECT_EQ(blas->report().dropped(), dropped);
}

TEST(Refit, ACopyIsDeep) {
    const Mesh ball = test::make_ball(glm::vec3(0.0f), 1.0f, 4);
    const auto first = rc::build_blas(ball.view());
    const auto second = std::make_shared<rc::Blas>(*first);
    const auto scene = scene_of(first);
    const std::vector<glm::vec3> point(ball.positions.size(), glm::vec3(0.5f));
    rc::refit_blas(*second, point);
    EXPECT_EQ(differing_answers(*scene, *scene_of(rc::build_blas(ball.view())), 7), 0);
}

}  // namespace
