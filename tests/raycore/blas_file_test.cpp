// A saved tree is the tree, or is refused with a sentence; whatever its bytes hold, nothing crashes.
#include "raycore/blas_file.h"

#include "data.h"
#include "support/brute_force.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace {

using test::Mesh;
using test::Random;

Mesh make_mesh() {
    Random random(31);
    Mesh mesh = test::make_soup(random, 700, 3.0f, 0.8f);
    test::append(mesh, test::make_ball(glm::vec3(0.0f), 1.0f, 8));
    mesh.positions.front().x = std::numeric_limits<float>::quiet_NaN();  // one triangle that is dropped
    return mesh;
}

template <class Vector>
bool same(const Vector& a, const Vector& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

class BlasFile : public ::testing::TestWithParam<rc::BuildQuality> {};

TEST_P(BlasFile, ALoadedTreeIsTheSavedOneInEveryByte) {
    const Mesh mesh = make_mesh();
    for (const bool can_refit : {true, false}) {
        const auto saved = rc::build_blas(mesh.view(), {GetParam(), can_refit});
        const rc::LoadedBlas loaded = rc::load_blas(rc::save_blas(*saved, mesh.view()), mesh.view());
        ASSERT_TRUE(loaded.blas) << loaded.refusal;
        const rc::Blas::Data &a = saved->data(), &b = loaded.blas->data();
        EXPECT_TRUE(same(a.nodes, b.nodes));
        EXPECT_TRUE(same(a.leaves, b.leaves));
        EXPECT_TRUE(same(a.leaf_of_primitive, b.leaf_of_primitive));
        EXPECT_EQ(a.root, b.root);
        EXPECT_EQ(a.cost, b.cost);
        EXPECT_EQ(a.report.dropped(), b.report.dropped());
        EXPECT_EQ(a.bounds.max, b.bounds.max);
    }
}

TEST_P(BlasFile, SmallAndEmptyMeshesAreSavedAsWell) {
    Mesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    const Mesh none, flat{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
    for (const Mesh* mesh : {&none, &flat, static_cast<const Mesh*>(&one)}) {
        const auto saved = rc::build_blas(mesh->view(), {GetParam()});
        const rc::LoadedBlas loaded = rc::load_blas(rc::save_blas(*saved, mesh->view()), mesh->view());
        ASSERT_TRUE(loaded.blas) << loaded.refusal;
        EXPECT_EQ(loaded.blas->data().root, saved->data().root);
    }
}

// What save_blas hands out can be loaded: a refitted tree too, and one that no longer fits its mesh is not handed out.
TEST_P(BlasFile, ARefittedTreeIsSavedUnlessItsTrianglesHaveTurnedBadOrGood) {
    const Mesh built = make_mesh();
    const rc::BuildOptions options{GetParam(), true};
    const auto is_saved = [&](const Mesh& mesh) {
        const auto blas = rc::build_blas(built.view(), options);
        EXPECT_TRUE(rc::refit_blas(*blas, mesh.positions));
        const std::vector<std::byte> bytes = rc::save_blas(*blas, mesh.view());
        const rc::LoadedBlas loaded = rc::load_blas(bytes, mesh.view());
        EXPECT_EQ(loaded.blas != nullptr, !bytes.empty()) << loaded.refusal;
        return !bytes.empty();
    };
    Mesh moved = built;
    for (glm::vec3& p : moved.positions) p.y *= 1.5f;
    EXPECT_TRUE(is_saved(moved));

    Mesh bad = moved, flat = moved, mended = moved;
    const glm::uvec3& last = built.triangles.back();
    bad.positions[last.x].z = std::numeric_limits<float>::quiet_NaN();
    flat.positions[last.x] = flat.positions[last.y];
    mended.positions.front().x = 0.0f;
    EXPECT_FALSE(is_saved(bad));
    EXPECT_FALSE(is_saved(flat));
    EXPECT_FALSE(is_saved(mended));
}

INSTANTIATE_TEST_SUITE_P(EveryQuality, BlasFile,
                         ::testing::Values(rc::BuildQuality::Fast, rc::BuildQuality::Default,
                                           rc::BuildQuality::High));

TEST(BlasFileRefused, AnotherMeshVersionOrLengthIsNamed) {
    const Mesh mesh = make_mesh();
    const std::vector<std::byte> bytes = rc::save_blas(*rc::build_blas(mesh.view()), mesh.view());
    Mesh moved = mesh;
    moved.positions.back().y += 0.25f;
    EXPECT_NE(rc::load_blas(bytes, moved.view()).refusal.find("another mesh"), std::string::npos);
    Mesh turned = mesh;
    std::swap(turned.triangles.back().x, turned.triangles.back().y);
    EXPECT_NE(rc::load_blas(bytes, turned.view()).refusal.find("another mesh"), std::string::npos);

    std::vector<std::byte> older = bytes;
    for (const int version :
         {0, 1, 2}) {  // the last is that of leaves with corners of their own for every triangle
        older[8] = static_cast<std::byte>(version);
        EXPECT_NE(rc::load_blas(older, mesh.view()).refusal.find("version"), std::string::npos);
    }
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{7}, std::size_t{103}, std::size_t{104}, bytes.size() - 1}) {
        const rc::LoadedBlas cut = rc::load_blas(std::span(bytes).first(size), mesh.view());
        EXPECT_FALSE(cut.blas) << size;
        EXPECT_FALSE(cut.refusal.empty());
    }
}

TEST(BlasFileRefused, EveryFlippedBitIsNoticed) {
    Random random(32);
    const Mesh mesh = test::make_soup(random, 60, 3.0f, 0.8f);
    std::vector<std::byte> bytes =
        rc::save_blas(*rc::build_blas(mesh.view(), {rc::BuildQuality::High}), mesh.view());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const std::byte before = bytes[i];
        bytes[i] ^= std::byte{1} << (i % 8);
        EXPECT_FALSE(rc::load_blas(bytes, mesh.view()).blas) << "byte " << i;
        bytes[i] = before;
    }
}

// As if somebody had damaged the tree and mended the checksum: the tree's own links are checked before they are
// followed. What is accepted answers every ray without a crash.
TEST(BlasFileRefused, ATreeThatContradictsItselfLeadsNobodyAstray) {
    Random random(33);
    const Mesh mesh = test::make_soup(random, 200, 3.0f, 0.8f);
    const auto blas = rc::build_blas(mesh.view());
    int accepted = 0, refused = 0;
    for (int i = 0; i < 3000; ++i) {
        rc::Blas broken(*blas);
        rc::kernel::WideNode& node =
            broken.data().nodes[random.below(static_cast<std::uint32_t>(broken.data().nodes.size()))];
        const std::uint32_t lane = random.below(8);
        std::uint32_t& word = random.below(4) ? node.child[lane] : node.layers[lane];
        word = random.below(2) ? word ^ 1u << random.below(32) : random.below(300);
        // save_blas reads leaves through these very words: only those that stay inside can be written at all.
        const std::uint32_t code = node.child[lane];
        if (node.layers[lane] != 0 && (code & rc::kernel::kLeafBit) != 0 &&
            rc::unit_of(code) * rc::kernel::kWordsPerUnit + rc::kernel::kLeafPadding >
                broken.data().leaves.size())
            continue;
        const rc::LoadedBlas loaded = rc::load_blas(rc::save_blas(broken, mesh.view()), mesh.view());
        if (!loaded.blas) {
            ++refused;
            continue;
        }
        ++accepted;
        rc::SceneBuilder builder;
        builder.add({loaded.blas});
        const auto scene = builder.commit();
        for (int k = 0; k < 20; ++k)
            (void)rc::closest_hit(*scene, {.origin = random.in_cube(4.0f), .direction = random.direction()},
                                  1);
    }
    EXPECT_GT(refused, 1000);
    EXPECT_LT(accepted, 1000);  // a flipped bit can name another leaf for an empty lane
}

// Eight triangles at one place are a leaf of three corners where nothing moves, and of twenty-four, which no block holds,
// where a refit may part them. A file that says the one for the other is not believed.
TEST(BlasFileRefused, LeavesWithMoreCornersThanFit) {
    Mesh apart;
    for (int i = 0; i < 8; ++i) test::append(apart, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
    const auto blas = rc::build_blas(apart.view(), {rc::BuildQuality::High, false});
    EXPECT_TRUE(rc::load_blas(rc::save_blas(*blas, apart.view()), apart.view()).blas);
    blas->data().can_refit = true;
    const rc::LoadedBlas loaded = rc::load_blas(rc::save_blas(*blas, apart.view()), apart.view());
    EXPECT_FALSE(loaded.blas);
    EXPECT_NE(loaded.refusal.find("contradicts"), std::string::npos);
}

}  // namespace
