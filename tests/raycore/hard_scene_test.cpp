// Scenes chosen to break a tree, a box test or a rounding, each asked in every way, for every quality of tree.
#include "raycore/every_way.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace test {
namespace {

class HardScene : public ::testing::TestWithParam<rc::BuildQuality> {
  protected:
    TestScene scene_{GetParam()};

    int ask(const Mesh& mesh, const glm::vec3& centre, float half, const char* what, int rays = 240) {
        Random random(91);
        return expect_every_way(scene_, searching_rays(random, mesh, centre, half, rays), what);
    }
    int ask_alone(const Mesh& mesh, const glm::vec3& centre, float half, const char* what, int rays = 240) {
        scene_.add(mesh);
        scene_.commit();
        return ask(mesh, centre, half, what, rays);
    }
};

Mesh fans_of_slivers(Random& random, int n, float length, float width) {
    Mesh mesh;
    for (int i = 0; i < n; ++i) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const glm::vec3 a = random.in_cube(length);
        mesh.positions.insert(mesh.positions.end(),
                              {a, a + random.direction() * length, a + random.direction() * width});
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    return mesh;
}

TEST_P(HardScene, DenormalCoordinates) {
    Random random(1);
    // 1e-38 is the least normal float: edges, differences and products below it lose bits or vanish.
    const float sizes[] = {1e-37f, 1e-39f, 1e-42f};
    for (const float size : sizes) {
        Mesh mesh = make_soup(random, 60, size, 0.7f * size);
        TestScene scene(GetParam());
        scene.add(mesh);
        scene.commit();
        (void)expect_every_way(scene, searching_rays(random, mesh, glm::vec3(0.0f), 2.0f * size, 150),
                               "denormals");
    }
}

TEST_P(HardScene, SliversAMillionTimesLongerThanWide) {
    Random random(2);
    const Mesh mesh = fans_of_slivers(random, 250, 1.0f, 1e-6f);
    EXPECT_GT(ask_alone(mesh, glm::vec3(0.0f), 2.0f, "slivers"), 20);
}

// From inside, at every kind of seam a closed mesh has: nobody looks out, whatever the tree.
TEST_P(HardScene, CornersAndEdgesOfAClosedBallFromInside) {
    Random random(3);
    const glm::vec3 centre(31.4f, -2.7f, 1.6f);
    const Mesh ball = make_ball(centre, 1.5f, 12);
    std::vector<rc::Ray> rays;
    for (std::size_t i = 0; i < ball.triangles.size(); i += 3) {
        const glm::uvec3& t = ball.triangles[i];
        const glm::vec3 a = ball.positions[t.x], b = ball.positions[t.y],
                        from = centre + random.in_cube(0.7f);
        for (const glm::vec3& seam : {a, 0.5f * (a + b), a + random.unit() * (b - a)})
            rays.push_back({.origin = from, .direction = seam - from});
        rays.push_back({.origin = centre, .direction = a - centre});
    }
    scene_.add(ball);
    scene_.commit();
    EXPECT_EQ(expect_every_way(scene_, rays, "a closed ball"), static_cast<int>(rays.size()));
}

// Along the tiles of a turned floor at 1e-2 ... 1e-7 of a right angle: the specification is right to a few units in the last
// place (exactness_test.cpp), and everyone tells the same.
TEST_P(HardScene, GrazingRays) {
    Random random(4);
    scene_.add(make_sheet(4.0f, 0.0f, 24), glm::mat4x3(0.6f, 0.8f, 0, -0.8f, 0.6f, 0, 0, 0, 1, 3, -2, 0.5f));
    scene_.commit();
    std::vector<rc::Ray> rays;
    for (int i = 0; i < 240; ++i) {
        const glm::vec3 on(random.between(-3, 3), 0, random.between(-3, 3));
        const glm::vec3 along(random.between(-1, 1), -std::pow(10.0f, -2.0f - float(i % 6)),
                              random.between(-1, 1));
        const glm::vec3 from = on - 2.0f * along;
        const auto turned = [](const glm::vec3& p) {
            return glm::vec3(0.6f * p.x - 0.8f * p.y, 0.8f * p.x + 0.6f * p.y, p.z);
        };
        rays.push_back({.origin = turned(from) + glm::vec3(3, -2, 0.5f), .direction = turned(along)});
    }
    EXPECT_GT(expect_every_way(scene_, rays, "grazing"), 150);
}

TEST_P(HardScene, FromATenthOfAMillimetreToAThousandKilometres) {
    Random random(3);
    Mesh mesh = make_soup(random, 40, 1e6f, 4e5f);
    append(mesh, make_soup(random, 120, 1e-3f, 1e-4f));
    append(mesh, make_ball(glm::vec3(0.0f), 1.0f, 3));
    append(mesh, make_sheet(1e5f, 0.0f, 3));
    EXPECT_GT(ask_alone(mesh, glm::vec3(0.0f), 1.0f, "around the middle"), 60);
    EXPECT_GT(ask(mesh, glm::vec3(0.0f), 1e6f, "from afar"), 60);
}

TEST_P(HardScene, CoplanarDuplicatesInOneMeshAndInMany) {
    Mesh mesh = make_sheet(2.0f, 0.0f, 4);
    append(mesh, make_sheet(2.0f, 0.0f, 4));
    append(mesh, make_box(glm::vec3(-1), glm::vec3(1, 0, 1)));  // its lid lies in the sheets
    scene_.add(mesh);
    scene_.add_instance_of_last(glm::mat4x3(1.0f));
    scene_.add(make_sheet(2.0f, 0.0f, 4));
    scene_.commit();
    EXPECT_GT(ask(mesh, glm::vec3(0.0f), 2.0f, "duplicates"), 100);
}

TEST_P(HardScene, MirroredShearedSqueezedAndVanishedInstances) {
    Random random(5);
    const Mesh ball = make_ball({0.2f, 0, 0}, 1.0f, 3);
    scene_.add(ball, glm::mat4x3(-1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0));
    scene_.add_instance_of_last(glm::mat4x3(1, 5, 0, 0, 1, 0, -7, 0, 1, -2, 0, 0));
    scene_.add_instance_of_last(glm::mat4x3(30, 0, 0, 0, 0.01f, 0, 0, 0, 1, 0, 1, 0));
    scene_.add_instance_of_last(glm::mat4x3(0.6f, 0.8f, 0, -0.8f, 0.6f, 0, 0, 0, 1, 0, 0, 2));
    // No volume left: kept under their ids, never met. The oracle's determinant is zero for these as well.
    scene_.add_instance_of_last(glm::mat4x3(0.0f));
    scene_.add_instance_of_last(glm::mat4x3(1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0));
    scene_.add_instance_of_last(glm::mat4x3(1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0));
    scene_.commit();
    EXPECT_EQ(scene_.scene().dropped_instances(), 3u);
    EXPECT_GT(ask(ball, glm::vec3(0.0f), 3.0f, "instances"), 120);
}

TEST_P(HardScene, EmptyMeshesAmongOthers) {
    TestScene empty(GetParam());
    empty.add({});
    empty.add({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}});
    empty.commit();
    Random random(6);
    const Mesh ball = make_ball(glm::vec3(0.0f), 1.0f, 2);
    EXPECT_EQ(expect_every_way(empty, searching_rays(random, ball, glm::vec3(0.0f), 2.0f, 60), "nothing"), 0);
    scene_.add({});
    scene_.add(ball);
    scene_.add({});
    scene_.commit();
    EXPECT_GT(ask(ball, glm::vec3(0.0f), 2.0f, "a ball between nothings"), 80);
}

TEST_P(HardScene, OneTwoAndNineTriangles) {
    Random random(7);
    for (const std::uint32_t n : {1u, 2u, 7u, 8u, 9u, 17u, 65u}) {
        const Mesh mesh = make_soup(random, n, 1.0f, 1.5f);
        TestScene scene(GetParam());
        scene.add(mesh);
        scene.commit();
        EXPECT_GT(expect_every_way(scene, searching_rays(random, mesh, glm::vec3(0.0f), 2.0f, 80), "few"), 5)
            << n;
    }
}

// Sizes and places that grow by a constant factor make the deepest trees.
TEST_P(HardScene, ASpiralThatTemptsTheTreeToBeDeep) {
    Mesh spiral;
    for (std::uint32_t i = 0; i < 400; ++i) {
        const float x =
            std::ldexp(1.0f + 1e-3f * static_cast<float>(i / 100), static_cast<int>(i % 100) - 50);
        spiral.positions.insert(spiral.positions.end(),
                                {{x, 0, 0}, {1.01f * x, 0, 0}, {x, 0.01f * x, 0.003f * x}});
        spiral.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    EXPECT_GT(ask_alone(spiral, glm::vec3(0.0f), 10.0f, "spiral"), 30);
}

// Everything overlaps everything: no split helps, and a ray meets hundreds of boxes.
TEST_P(HardScene, AUrchinOfTrianglesThatAllMeetInTheMiddle) {
    Random random(9);
    Mesh urchin;
    for (std::uint32_t i = 0; i < 300; ++i) {
        const glm::vec3 tip = random.direction() * 2.0f;
        urchin.positions.insert(urchin.positions.end(), {-tip, tip, tip + random.in_cube(0.05f)});
        urchin.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    EXPECT_GT(ask_alone(urchin, glm::vec3(0.0f), 2.0f, "urchin"), 60);
}

TEST_P(HardScene, BadVerticesAndTrianglesAmongGoodOnes) {
    Random random(10);
    Mesh mesh = make_soup(random, 120, 2.0f, 1.0f);
    constexpr float kBad[] = {std::numeric_limits<float>::quiet_NaN(), rc::kInfinity, -rc::kInfinity, 1e30f};
    for (std::uint32_t i = 0; i < 60; ++i) mesh.positions[random.below(360)][random.below(3)] = kBad[i % 4];
    for (std::uint32_t i = 0; i < 20; ++i)
        mesh.triangles[random.below(120)][random.below(3)] = 1u << (i % 32);
    for (std::uint32_t i = 0; i < 20; ++i) {
        glm::uvec3& t = mesh.triangles[random.below(120)];
        t.y = t.x;
    }
    EXPECT_GT(ask_alone(mesh, glm::vec3(0.0f), 2.0f, "bad vertices"), 40);
}

TEST_P(HardScene, NearlyFlatLayersAHairApart) {
    Mesh mesh;
    for (int i = 0; i < 12; ++i)
        append(
            mesh,
            make_sheet(
                1.0f, std::nextafter(1.0f, 2.0f + static_cast<float>(i)) + 1e-6f * static_cast<float>(i), 2));
    EXPECT_GT(ask_alone(mesh, glm::vec3(0, 1, 0), 0.5f, "layers"), 100);
}

TEST_P(HardScene, AHundredThousandIdenticalTriangles) {
    Mesh pile{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    pile.triangles.assign(100'000, {0, 1, 2});
    scene_.add(pile);
    scene_.commit();
    const std::vector<rc::Ray> rays{{.origin = {0.25f, 0.25f, 1}, .direction = {0, 0, -1}, .t_max = 1.0f},
                                    {.origin = {0, 0, 1}, .direction = {0, 0, -1}},
                                    {.origin = {0.75f, 0.5f, 1}, .direction = {0, 0, -1}}};
    EXPECT_EQ(expect_every_way(scene_, rays, "pile"), 2);
}

// A guard's sight, a shadow and a footstep on different layers.
TEST_P(HardScene, LayersAreHonouredInEveryWay) {
    Random random(13);
    const Mesh soup = make_soup(random, 40, 2.0f, 1.5f);
    for (std::uint32_t i = 0; i < 12; ++i) {
        glm::mat4x3 place(1.0f);
        place[3] = random.in_cube(1.0f);
        if (i == 0)
            scene_.add(soup, place, 1u << 31);
        else
            scene_.add_instance_of_last(place, (1u << (i % 3)) | (1u << 31));
    }
    scene_.commit();
    const std::vector<rc::Ray> rays = searching_rays(random, soup, glm::vec3(0.0f), 3.0f, 80);
    for (const rc::LayerMask layers : {1u, 2u, 6u, 1u << 31, 8u}) {
        const int met = expect_every_way(scene_, rays, "layers", layers);
        if (layers == 8u) {
            EXPECT_EQ(met, 0);
        } else {
            EXPECT_GT(met, 30);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(EveryQuality, HardScene, ::testing::ValuesIn(kQualities), quality_test_name);

// More triangles than an index can name are refused before one of them is read.
TEST(HardScenes, AMeshLargerThanTheLimitIsRefused) {
    const Mesh one = make_box(glm::vec3(-1), glm::vec3(1));
    const rc::MeshView huge{one.positions, std::span(one.triangles.data(), rc::kMaxTriangles + 1)};
#ifdef RC_CONTRACTS
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_DEATH((void)rc::build_blas(huge), "kMaxTriangles");
#else
    const auto blas = rc::build_blas(huge);
    EXPECT_GT(blas->bounds().min.x, blas->bounds().max.x);
    EXPECT_EQ(blas->report().kept(), 0u);
#endif
}

TEST(HardScenes, IndicesOfTwoToTheThirtyFirstAndBeyondAreOutOfRange) {
    const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                    {{0, 1, 2}, {0, 1, 0x80000000u}, {0x7FFFFFFFu, 1, 2}, {0, 0xFFFFFFFFu, 2}, {0, 1, 3}}};
    const rc::MeshReport report = rc::build_blas(mesh.view())->report();
    EXPECT_EQ(report.index_out_of_range, 4u);
    EXPECT_EQ(report.kept(), 1u);
}

}  // namespace
}  // namespace test
