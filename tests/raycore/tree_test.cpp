// The tree itself: one per input whatever the thread count, never deeper than the stacks are high, every triangle in it.
#include "data.h"
#include "support/shapes.h"
#include "visit.h"

#include "raycore/every_way.h"
#include "raycore/query.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <set>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

using test::Mesh;
using test::Random;

std::shared_ptr<rc::Blas> build_with(const Mesh& mesh, std::size_t threads, rc::BuildQuality quality) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return rc::build_blas(mesh.view(), {quality, true});
}

bool same_tree(const rc::Blas::Data& a, const rc::Blas::Data& b) {
    const auto same = [](const auto& x, const auto& y) {
        return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0;
    };
    return a.root == b.root && same(a.nodes, b.nodes) && same(a.leaves, b.leaves) && a.cost == b.cost &&
           same(a.leaf_of_primitive, b.leaf_of_primitive);
}

// Levels below `item`; counts every triangle met on the way.
int depth_of(const rc::Blas::Data& tree, std::uint32_t item, std::multiset<std::uint32_t>& primitives) {
    if (item & rc::kernel::kLeafBit) {
        const rc::Leaf leaf(tree.leaves.data(), item);
        for (std::uint32_t i = 0; i < leaf.size(); ++i) primitives.insert(leaf.primitive(i));
        return 0;
    }
    int deepest = 0;
    const rc::kernel::WideNode& node = tree.nodes[item];
    for (int i = 0; i < rc::kernel::kWidth; ++i)
        if (node.layers[i] != 0) deepest = std::max(deepest, depth_of(tree, node.child[i], primitives));
    return deepest + 1;
}

class Tree : public ::testing::TestWithParam<rc::BuildQuality> {};

TEST_P(Tree, IsTheSameForAnyNumberOfThreads) {
    Random random(1);
    Mesh mesh = test::make_soup(random, 70'000, 5.0f, 0.05f);  // enough for several threads to part one range
    test::append(mesh, test::make_ball(glm::vec3(-0.0f), 2.0f, 60));
    const auto one = build_with(mesh, 1, GetParam());
    for (const std::size_t threads : {2u, 3u, 8u})
        EXPECT_TRUE(same_tree(one->data(), build_with(mesh, threads, GetParam())->data()))
            << threads << " threads";
}

TEST_P(Tree, IsRefittedTheSameByAnyNumberOfThreads) {
    Random random(4);
    Mesh mesh = test::make_soup(random, 20'000, 5.0f, 0.3f);
    const auto one = build_with(mesh, 1, GetParam());
    for (glm::vec3& p : mesh.positions) p += random.in_cube(0.2f);
    (void)rc::refit_blas(*one, mesh.positions);  // several threads
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    const rc::Blas copy(*one);
    (void)rc::refit_blas(*one, mesh.positions);
    EXPECT_TRUE(same_tree(one->data(), copy.data()));
}

TEST_P(Tree, HoldsEveryTriangleThatWasKept) {
    Random random(2);
    const Mesh mesh = test::make_soup(random, 5000, 5.0f, 0.3f);
    const auto blas = rc::build_blas(mesh.view(), {GetParam()});
    std::multiset<std::uint32_t> primitives;
    (void)depth_of(blas->data(), blas->data().root, primitives);
    const std::set<std::uint32_t> once(primitives.begin(), primitives.end());
    EXPECT_EQ(once.size(), 5000u);
    EXPECT_LE(primitives.size(), 2 * once.size());  // spatial splits repeat some
}

// What is read of a lane that nothing is in must be a block of triangles, laid out as its leaf says.
TEST_P(Tree, EmptyLanesNameALeafThatExists) {
    Random random(6);
    const auto blas = rc::build_blas(test::make_soup(random, 3000, 5.0f, 0.3f).view(), {GetParam()});
    std::set<std::uint32_t> leaves;
    for (const rc::kernel::WideNode& node : blas->data().nodes)
        for (int i = 0; i < rc::kernel::kWidth; ++i)
            if (node.layers[i] != 0 && (node.child[i] & rc::kernel::kLeafBit) != 0)
                leaves.insert(node.child[i]);
    int empty = 0;
    for (const rc::kernel::WideNode& node : blas->data().nodes) {
        for (int i = 0; i < rc::kernel::kWidth; ++i) {
            if (node.layers[i] != 0) continue;
            ++empty;
            EXPECT_TRUE(leaves.contains(node.child[i]));
        }
    }
    EXPECT_GT(empty, 100);
}

// Sizes and places that grow by a constant factor tempt every step to split one triangle off.
TEST_P(Tree, IsNeverDeeperThanTheStacksAreHigh) {
    Mesh spiral;
    for (std::uint32_t i = 0; i < 4000; ++i) {
        const float x =
            std::ldexp(1.0f, static_cast<int>(i % 100) - 50) * (1.0f + 1e-3f * static_cast<float>(i / 100));
        for (const glm::vec3& p :
             {glm::vec3(x, 0, 0), glm::vec3(1.01f * x, 0, 0), glm::vec3(x, 0.01f * x, 0)})
            spiral.positions.push_back(p);
        spiral.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    const auto blas = rc::build_blas(spiral.view(), {GetParam()});
    std::multiset<std::uint32_t> primitives;
    const int depth = depth_of(blas->data(), blas->data().root, primitives);
    EXPECT_LE(depth, rc::kernel::kMaxDepth);
    EXPECT_GE(primitives.size(), 4000u);
}

TEST_P(Tree, AHundredThousandIdenticalTrianglesStayShallow) {
    Mesh pile{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    pile.triangles.assign(100'000, {0, 1, 2});
    const auto blas = rc::build_blas(pile.view(), {GetParam()});
    std::multiset<std::uint32_t> primitives;
    EXPECT_LE(depth_of(blas->data(), blas->data().root, primitives), 17);
    EXPECT_EQ(primitives.size(), 100'000u);
}

INSTANTIATE_TEST_SUITE_P(EveryQuality, Tree,
                         ::testing::Values(rc::BuildQuality::Fast, rc::BuildQuality::Default,
                                           rc::BuildQuality::High),
                         test::quality_test_name);

// The lane of a ray's frame that means nothing is computed along: denormal, it would make every ray wait.
TEST(Views, HoldNothingOfWhatMemoryHeldBefore) {
#ifdef __GLIBC__
    mallopt(M_PERTURB, 0x55);  // new memory is full of something
#endif
    rc::SceneBuilder builder;
    builder.add({rc::build_blas(test::make_ball(glm::vec3(0.0f), 1.0f, 3).view())});
    const auto scene = builder.commit();
#ifdef __GLIBC__
    mallopt(M_PERTURB, 0);
#endif
    for (const auto& column : scene->data().view.instances[0].local_from_world) EXPECT_EQ(column[3], 0.0);
}

// Everything a swept body could touch is offered to it: a triangle with a corner in the box is always visited.
TEST(Visit, OffersEveryTriangleThatReachesIntoTheBox) {
    Random random(3);
    const Mesh mesh = test::make_soup(random, 800, 3.0f, 0.4f);
    const glm::mat4x3 places[] = {glm::mat4x3(1.0f), glm::mat4x3(-2, 0, 0, 0, 1, 0.5f, 0, 0, 0.3f, 1, 2, 3)};
    rc::SceneBuilder builder;
    for (const glm::mat4x3& place : places)
        builder.add({rc::build_blas(mesh.view()), place, 1u << builder.size()});
    const auto scene = builder.commit();
    std::size_t inside = 0, visits = 0;
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 centre = random.in_cube(4.0f), half = glm::abs(random.in_cube(1.5f));
        const rc::Box box{centre - half, centre + half};
        std::set<std::pair<std::uint32_t, std::uint32_t>> visited;
        rc::visit_triangles(
            *scene, box, rc::kAllLayers, [&](std::uint32_t id, std::uint32_t primitive, const auto& p) {
                visited.insert({id, primitive});
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_EQ(p[c], rc::world_corner(places[id], mesh.positions[3 * primitive + c]));
                return false;
            });
        rc::visit_triangles(*scene, box, 2, [&](std::uint32_t id, std::uint32_t, const auto&) {
            EXPECT_EQ(id, 1u);  // the other instance is not on this layer
            return false;
        });
        for (std::uint32_t id = 0; id < 2; ++id) {
            for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
                const glm::vec3 p = rc::world_corner(places[id], mesh.positions[v]);
                if (!rc::overlaps({p, p}, box)) continue;
                ++inside;
                EXPECT_TRUE(visited.contains({id, v / 3})) << "instance " << id << " triangle " << v / 3;
            }
        }
        visits += visited.size();
    }
    EXPECT_GT(inside, 4000u);
    EXPECT_LT(visits, 200u * 1600u / 4);  // it does prune
}

TEST(Visit, AShrinkingBoxIsAskedForLess) {
    const Mesh floor = test::make_sheet(8.0f, 0.0f, 64);
    rc::SceneBuilder builder;
    builder.add({rc::build_blas(floor.view())});
    const auto scene = builder.commit();
    rc::Box box{glm::vec3(-8.0f), glm::vec3(8.0f)};
    int visits = 0;
    rc::visit_triangles(*scene, box, rc::kAllLayers, [&](std::uint32_t, std::uint32_t, const auto&) {
        box = {glm::vec3(-0.1f), glm::vec3(0.1f)};
        return ++visits == 1;
    });
    EXPECT_GT(visits, 4);
    EXPECT_LT(visits, 40);
}

}  // namespace
