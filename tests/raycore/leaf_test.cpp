// Leaves keep a corner once, however many of their triangles share it, and no more of them than a block holds.
#include "data.h"
#include "support/shapes.h"

#include "raycore/blas.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <tuple>

namespace {

using test::Mesh;
using test::Random;

std::vector<std::uint32_t> leaves_of(const rc::Blas::Data& tree) {
    if (tree.root & rc::kernel::kLeafBit) return {tree.root};
    std::vector<std::uint32_t> leaves;
    for (const rc::kernel::WideNode& node : tree.nodes)
        for (int lane = 0; lane < rc::kernel::kWidth; ++lane)
            if (node.layers[lane] != 0 && (node.child[lane] & rc::kernel::kLeafBit) != 0)
                leaves.push_back(node.child[lane]);
    return leaves;
}

// As many corners as the leaf's triangles have, counted apart from the builder, and each where the mesh has it.
void expect_shared(const rc::Blas& blas, const Mesh& mesh, bool by_vertex) {
    for (const std::uint32_t code : leaves_of(blas.data())) {
        const rc::Leaf leaf(blas.data().leaves.data(), code);
        std::set<std::uint32_t> vertices;
        std::set<std::tuple<float, float, float>> places;
        for (std::uint32_t i = 0; i < leaf.size(); ++i) {
            const glm::uvec3& triangle = mesh.triangles[leaf.primitive(i)];
            for (std::uint32_t c = 0; c < 3; ++c) {
                const glm::vec3& at = mesh.positions[triangle[static_cast<glm::length_t>(c)]];
                EXPECT_EQ(leaf.corner(i, c), at);
                vertices.insert(triangle[static_cast<glm::length_t>(c)]);
                places.emplace(at.x, at.y, at.z);
            }
        }
        EXPECT_EQ(rc::corners_of(code), by_vertex ? vertices.size() : places.size());
    }
}

TEST(Leaves, KeepACornerOnce) {
    const Mesh ball = test::make_ball(glm::vec3(3.0f), 1.0f, 12), pieces = test::parted(ball);
    for (const rc::BuildQuality quality :
         {rc::BuildQuality::Fast, rc::BuildQuality::Default, rc::BuildQuality::High}) {
        for (const bool can_refit : {false, true}) {
            expect_shared(*rc::build_blas(ball.view(), {quality, can_refit}), ball, can_refit);
            expect_shared(*rc::build_blas(pieces.view(), {quality, can_refit}), pieces, can_refit);
        }
    }
}

// Flat walls come with a vertex for each of their normals; that costs no memory where nothing moves.
TEST(Leaves, AreTheSameHoweverOftenAVertexIsRepeated) {
    const Mesh ball = test::make_ball(glm::vec3(3.0f), 1.0f, 12);
    const auto one = rc::build_blas(ball.view(), {rc::BuildQuality::High, false}),
               other = rc::build_blas(test::parted(ball).view(), {rc::BuildQuality::High, false});
    const auto &a = one->data().leaves, &b = other->data().leaves;
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(float)), 0);
}

// Eight triangles at one place have twenty-four corners, and no builder can tell them apart.
TEST(Leaves, OfTrianglesThatShareNothingAreSmall) {
    Random random(5);
    Mesh pile;
    const glm::vec3 corner[3] = {random.in_cube(1.0f), random.in_cube(1.0f), random.in_cube(1.0f)};
    for (std::uint32_t i = 0; i < 64; ++i) {
        for (const glm::vec3& p : corner) pile.positions.push_back(p + random.in_cube(1e-4f));
        pile.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    for (const rc::BuildQuality quality :
         {rc::BuildQuality::Fast, rc::BuildQuality::Default, rc::BuildQuality::High}) {
        const auto blas = rc::build_blas(pile.view(), {quality, true});
        expect_shared(*blas, pile, true);
        std::set<std::uint32_t> held;
        for (const std::uint32_t code : leaves_of(blas->data())) {
            const rc::Leaf leaf(blas->data().leaves.data(), code);
            EXPECT_LE(3 * leaf.size(), rc::kernel::kMaxCorners);
            for (std::uint32_t i = 0; i < leaf.size(); ++i) held.insert(leaf.primitive(i));
        }
        EXPECT_EQ(held.size(), 64u);
    }
}

}  // namespace
