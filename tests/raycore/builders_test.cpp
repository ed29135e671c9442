// Every builder, every answer: levels of quality differ in time and memory, never in what a ray meets.
#include "clip.h"
#include "collect_refs.h"
#include "data.h"
#include "dispatch.h"
#include "support/brute_force.h"
#include "support/isas.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>

namespace {

using test::Mesh;
using test::Random;

constexpr rc::BuildQuality kQualities[] = {rc::BuildQuality::Fast, rc::BuildQuality::Default,
                                           rc::BuildQuality::High};

void add_triangle(Mesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    mesh.triangles.emplace_back(first, first + 1, first + 2);
}

// Blades at every slant, hundreds of times as long as wide: what spatial splits cut most.
Mesh make_blades(Random& random, int n, float length = 3.0f) {
    Mesh mesh;
    for (int i = 0; i < n; ++i) {
        const glm::vec3 from = random.in_cube(5.0f), to = from + length * random.direction();
        add_triangle(mesh, from, to, to + 0.005f * random.direction());
    }
    return mesh;
}

std::shared_ptr<const rc::Scene> scene_of(const Mesh& mesh, rc::BuildQuality quality) {
    rc::SceneBuilder builder;
    builder.add({rc::build_blas(mesh.view(), {quality})});
    return builder.commit();
}

// Closest hit, any hit and all crossings of one ray, each in every bit as brute force has them.
void expect_truth(const rc::Scene& scene, const test::TestScene& truth, const rc::Ray& ray) {
    const std::vector<rc::Hit> expected = truth.all_hits(ray);
    const auto closest = rc::closest_hit(scene, ray, rc::kAllLayers);
    ASSERT_EQ(closest.has_value(), !expected.empty());
    ASSERT_EQ(rc::any_hit(scene, ray, rc::kAllLayers), !expected.empty());
    if (closest) {
        ASSERT_TRUE(test::same_bits(*closest, expected.front()));
    }
    const glm::vec3 to = ray.origin + ray.direction;
    const std::vector<rc::Hit> between =
        truth.all_hits({.origin = ray.origin, .direction = to - ray.origin, .t_max = 1.0f});
    std::array<rc::Hit, 64> hits;
    const std::size_t count = rc::crossings(scene, ray.origin, to, rc::kAllLayers, hits);
    ASSERT_EQ(count, std::min(hits.size(), between.size()));  // a triangle in pieces is crossed once
    for (std::size_t i = 0; i < count; ++i) ASSERT_TRUE(test::same_bits(hits[i], between[i])) << i;
}

void expect_all_qualities_true(const Mesh& mesh, std::uint64_t seed, int rays) {
    test::TestScene truth;
    truth.add(mesh);
    truth.commit();
    for (const rc::BuildQuality quality : kQualities) {
        const auto scene = scene_of(mesh, quality);
        Random random(seed);
        for (int i = 0; i < rays; ++i) {
            rc::Ray ray{.origin = random.in_cube(6.0f), .direction = 12.0f * random.direction()};
            if (i % 3 == 0) {  // exactly at a corner
                const auto n = static_cast<std::uint32_t>(mesh.positions.size());
                ray.direction = 2.0f * (mesh.positions[random.below(n)] - ray.origin);
            }
            SCOPED_TRACE("quality " + std::to_string(int(quality)) + ", ray " + std::to_string(i));
            ASSERT_NO_FATAL_FAILURE(expect_truth(*scene, truth, ray));
        }
    }
}

// Triangles of all leaves: more than the mesh has where some were cut.
std::size_t pieces_in(const rc::Blas& blas) {
    std::size_t pieces = 0;
    for (const rc::kernel::WideNode& node : blas.data().nodes)
        for (int lane = 0; lane < rc::kernel::kWidth; ++lane)
            if (node.layers[lane] != 0 && (node.child[lane] & rc::kernel::kLeafBit) != 0)
                pieces += rc::Leaf(blas.data().leaves.data(), node.child[lane]).size();
    return pieces;
}

// Walls and beams across a room full of small things: boxes overlap wherever the large are kept whole.
Mesh make_hall(Random& random, int small, int large) {
    Mesh hall = test::make_soup(random, static_cast<std::uint32_t>(small), 5.0f, 0.1f);
    for (int i = 0; i < large; ++i)
        add_triangle(hall, random.in_cube(5.0f), random.in_cube(5.0f), random.in_cube(5.0f));
    return hall;
}

TEST(Builders, BladesAndBeamsAreMetWhateverTheTree) {
    Random random(11);
    const Mesh hall = make_hall(random, 600, 60);
    const auto high = rc::build_blas(hall.view(), {rc::BuildQuality::High});
    EXPECT_GT(pieces_in(*high), hall.triangles.size() + 30);  // they were cut indeed
    expect_all_qualities_true(hall, 12, 300);
    expect_all_qualities_true(make_blades(random, 300), 13, 300);
    expect_all_qualities_true(make_blades(random, 200, 30.0f), 14, 200);
}

TEST(Builders, CoplanarDuplicatesAreMetByTheLowestWhateverTheTree) {
    Random random(13);
    Mesh mesh = make_blades(random, 60);
    const Mesh once = mesh;
    for (int copies = 0; copies < 3; ++copies) test::append(mesh, once);
    test::append(mesh, test::make_sheet(5.0f, 0.0f, 4));
    test::append(mesh, test::make_sheet(5.0f, 0.0f, 4));
    expect_all_qualities_true(mesh, 14, 300);
}

// One huge triangle among tiny ones, sizes from 2^-20 to 2^20, flat meshes, a single triangle.
TEST(Builders, UnevenAndFlatMeshesAreMetWhateverTheTree) {
    Random random(15);
    Mesh uneven = test::make_soup(random, 300, 0.01f, 0.001f);
    add_triangle(uneven, {-500, -400, 1}, {600, -300, 2}, {20, 700, -3});
    for (int k = -20; k <= 20; ++k) {
        const float s = std::ldexp(1.0f, k);
        add_triangle(uneven, {s, 0, 0}, {0, s, 0}, {0, 0, s});
    }
    expect_all_qualities_true(uneven, 16, 200);
    expect_all_qualities_true(test::make_sheet(5.0f, 0.5f, 12), 17, 200);
    Mesh single;
    add_triangle(single, {-4, -4, 0}, {4, -4, 1}, {0, 4, -1});
    expect_all_qualities_true(single, 18, 100);
}

TEST(Builders, SpatialSplitsCostRaysLessAmongBeams) {
    Random random(19);
    const Mesh hall = make_hall(random, 6000, 100);
    const auto plain = rc::build_blas(hall.view()),
               high = rc::build_blas(hall.view(), {rc::BuildQuality::High});
    EXPECT_LT(high->sah_cost(), 0.9f * plain->sah_cost());
    EXPECT_LE(pieces_in(*high), std::size_t(1.3 * 6100));
}

TEST(Builders, RefittingATreeOfPiecesAnswersAsARebuild) {
    Random random(20);
    Mesh blades = make_hall(random, 300, 40);
    const auto blas = rc::build_blas(blades.view(), {rc::BuildQuality::High, true});
    for (glm::vec3& p : blades.positions) p = glm::vec3(p.y, 0.5f * p.x + 0.3f * p.z, p.z - 0.2f * p.y);
    ASSERT_TRUE(rc::refit_blas(*blas, blades.positions));
    rc::SceneBuilder builder;
    builder.add({blas});
    const auto refitted = builder.commit(), rebuilt = scene_of(blades, rc::BuildQuality::Default);
    for (int i = 0; i < 1000; ++i) {
        const rc::Ray ray{.origin = random.in_cube(6.0f), .direction = random.direction()};
        EXPECT_TRUE(test::same_bits(rc::closest_hit(*refitted, ray, 1).value_or(rc::Hit{}),
                                    rc::closest_hit(*rebuilt, ray, 1).value_or(rc::Hit{})));
    }
}

// The same machine code is not the same bits: every ISA's inner loops must lead to one tree.
TEST(Builders, EveryIsaGrowsTheSameTree) {
    Random random(21);
    Mesh mesh = make_hall(random, 2000, 50);
    test::append(mesh, test::make_soup(random, 3000, 5.0f, 0.2f));
    for (const rc::BuildQuality quality : kQualities) {
        std::shared_ptr<rc::Blas> first;
        for (const rc::Isa isa : test::supported_isas()) {
            const test::IsaScope scope(isa);
            const auto blas = rc::build_blas(mesh.view(), {quality, true});
            (void)rc::refit_blas(*blas, mesh.positions);
            if (!first) first = blas;
            const rc::Blas::Data &a = first->data(), &b = blas->data();
            ASSERT_EQ(a.nodes.size(), b.nodes.size());
            EXPECT_EQ(std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(a.nodes[0])), 0);
            ASSERT_EQ(a.leaves.size(), b.leaves.size());
            EXPECT_EQ(std::memcmp(a.leaves.data(), b.leaves.data(), a.leaves.size() * sizeof(float)), 0);
            EXPECT_EQ(a.cost, b.cost);
        }
    }
}

TEST(Builders, ATreeNotToBeRefittedIsSmallerAndRefuses) {
    const Mesh ball = test::make_ball(glm::vec3(0.0f), 1.0f, 20);
    const auto fixed = rc::build_blas(ball.view(), {.can_refit = false}),
               supple = rc::build_blas(ball.view());
    // A word a corner, of which a triangle among others has one or two.
    EXPECT_GT(supple->byte_size(), fixed->byte_size() + 4 * ball.triangles.size());
    EXPECT_LT(supple->byte_size(), fixed->byte_size() + 8 * ball.triangles.size());
#ifndef RC_CONTRACTS
    EXPECT_FALSE(rc::refit_blas(*fixed, ball.positions));
#endif
    EXPECT_TRUE(rc::refit_blas(*supple, ball.positions));
}

TEST(Builders, OnlyTheBestTreesAreNotToBeRefittedUnlessAskedFor) {
    EXPECT_TRUE(rc::BuildOptions{}.can_refit);
    EXPECT_TRUE((rc::BuildOptions{.quality = rc::BuildQuality::Fast}.can_refit));
    EXPECT_FALSE((rc::BuildOptions{.quality = rc::BuildQuality::High}.can_refit));
    EXPECT_TRUE((rc::BuildOptions{.quality = rc::BuildQuality::High, .can_refit = true}.can_refit));
}

// Points anywhere on a triangle lie in one of the boxes of its halves, cut wherever: in double, with no tolerance.
TEST(Clip, EveryPointOfATriangleLiesInABoxOfOneOfItsPieces) {
    Random random(22);
    for (int i = 0; i < 3000; ++i) {
        const float scale = std::ldexp(1.0f, static_cast<int>(random.below(60)) - 30);
        const glm::vec3 offset = i % 2 ? glm::vec3(0.0f) : 1000.0f * scale * random.direction();
        glm::vec3 p[3];
        for (glm::vec3& corner : p) corner = offset + scale * random.in_cube(1.0f);
        if (i % 5 == 0) p[2] = p[1] + 1e-6f * (p[1] - p[0]);  // a sliver
        rc::BuildRef ref{};
        for (std::size_t a = 0; a < 3; ++a) {
            ref.neg_min[a] = -std::min(p[0][a], std::min(p[1][a], p[2][a]));
            ref.max[a] = std::max(p[0][a], std::max(p[1][a], p[2][a]));
        }
        const int axis = static_cast<int>(random.below(3));
        const float low = -ref.neg_min[axis], plane = low + random.between(0, 1) * (ref.max[axis] - low);
        rc::BuildRef left{}, right{};
        rc::build::clip(ref, p, axis, plane, left, right);
        const auto holds = [](const rc::BuildRef& box, const double(&q)[3]) {
            bool inside = true;
            for (int a = 0; a < 3; ++a)
                inside = inside && -double(box.neg_min[a]) <= q[a] && q[a] <= double(box.max[a]);
            return inside;
        };
        for (int k = 0; k < 50; ++k) {
            // Multiples of 2^-12 keep the blend of floats exact in double, short of coordinates far apart in size.
            const double u = double(random.below(4097)) / 4096.0;
            const double v = double(random.below(4097)) / 4096.0 * (1.0 - u);
            double q[3];
            for (std::size_t a = 0; a < 3; ++a)
                q[a] = double(p[0][a]) + (double(p[1][a]) - double(p[0][a])) * u +
                       (double(p[2][a]) - double(p[0][a])) * v;
            const double blend_error = 0x1p-48 * (std::abs(q[0]) + std::abs(q[1]) + std::abs(q[2]));
            double towards[3] = {q[0], q[1],
                                 q[2]};  // the oracle's own rounding, taken back towards the middle
            for (std::size_t a = 0; a < 3; ++a) {
                const double middle = (double(p[0][a]) + double(p[1][a]) + double(p[2][a])) / 3.0;
                towards[a] += q[a] < middle ? blend_error : -blend_error;
            }
            EXPECT_TRUE(holds(left, q) || holds(right, q) || holds(left, towards) || holds(right, towards))
                << "triangle " << i << " axis " << axis;
        }
        const float slack = rc::slack_of(p[0], p[1], p[2]);
        EXPECT_TRUE(left.max[axis] <= plane + slack || left.max[axis] == ref.max[axis]);
    }
}

}  // namespace
