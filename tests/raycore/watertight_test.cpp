// A guard inside a sealed room sees no light through its seams: near the world's origin, far from it, tiny or huge.
#include "support/isas.h"
#include "support/shapes.h"

#include "raycore/query.h"

#include <gtest/gtest.h>

namespace {

using test::Mesh;
using test::Random;

struct Ball {
    const char* name;
    glm::vec3 mesh_centre;
    float radius;
    glm::vec3 stands_at;  // of the instance
};

const Ball kBalls[] = {
    {"unit ball", glm::vec3(0.0f), 1.0f, glm::vec3(0.0f)},
    {"radius 1e-4", glm::vec3(0.0f), 1e-4f, glm::vec3(0.0f)},
    {"unit ball as an instance 1 km away", glm::vec3(0.0f), 1.0f, glm::vec3(731.3f, 12.7f, -405.9f)},
    {"radius 100, its vertices 1e6 m away", glm::vec3(1e6f, -1e6f, 1e6f), 100.0f, glm::vec3(0.0f)},
    {"unit ball, its vertices 731 m away", glm::vec3(731.3f, 12.7f, -405.9f), 1.0f, glm::vec3(0.0f)},
    {"radius 1e15", glm::vec3(0.0f), 1e15f, glm::vec3(0.0f)},
    {"radius 1e-25, whose products underflow", glm::vec3(0.0f), 1e-25f, glm::vec3(0.0f)},
};

class Watertight : public ::testing::TestWithParam<rc::Isa> {
  protected:
    test::IsaScope isa_{GetParam()};
};

// Aims at vertices, edges and faces in turn.
glm::vec3 target_on(const Mesh& mesh, Random& random, int i) {
    const glm::uvec3& t = mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
    const glm::vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
    if (i % 3 == 0) return a;
    const float share = i % 3 == 1 ? 0.5f : random.unit();
    const glm::vec3 on_edge = a + (b - a) * share;
    return i % 3 == 1 ? on_edge : on_edge + (c - on_edge) * random.unit();
}

TEST_P(Watertight, NoRayLeavesAClosedMeshThroughAnEdgeOrACorner) {
    for (const Ball& ball : kBalls) {
        const Mesh mesh = test::make_ball(ball.mesh_centre, ball.radius, 8);
        rc::SceneBuilder builder;
        glm::mat4x3 place(1.0f);
        place[3] = ball.stands_at;
        builder.add({rc::build_blas(mesh.view()), place});
        const auto scene = builder.commit();

        Random random(42);
        std::vector<rc::Ray> rays;
        for (int i = 0; i < 30'000; ++i) {
            const bool from_centre = i % 10 == 0;
            const glm::vec3 from =
                ball.mesh_centre + (from_centre ? glm::vec3(0.0f) : random.in_cube(0.4f * ball.radius));
            rc::Ray ray{.origin = from + ball.stands_at};
            ray.direction = (target_on(mesh, random, i) + ball.stands_at) - ray.origin;
            rays.push_back(ray);
        }
        std::vector<rc::Hit> hits(rays.size());
        std::vector<std::uint8_t> is_hit(rays.size());
        rc::closest_hits(*scene, rays, rc::kAllLayers, hits);
        rc::any_hits(*scene, rays, rc::kAllLayers, is_hit);
        int leaks = 0, disagreements = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            leaks += hits[i].is_miss();
            disagreements += hits[i].is_miss() == (is_hit[i] != 0);
        }
        EXPECT_EQ(leaks, 0) << "rays through the skin of a closed mesh: " << ball.name;
        EXPECT_EQ(disagreements, 0) << "any and closest differ: " << ball.name;
    }
}

// A lattice of axis-parallel rays exactly onto the vertices, edges and diagonals of a tiled floor.
TEST_P(Watertight, AxisParallelRaysMeetATiledFloorAtEveryJoint) {
    const Mesh floor = test::make_sheet(4.0f, 0.0f, 16);
    rc::SceneBuilder builder;
    builder.add({rc::build_blas(floor.view())});
    const auto scene = builder.commit();
    int leaks = 0;
    for (int j = 0; j <= 128; ++j) {
        for (int i = 0; i <= 128; ++i) {
            const glm::vec3 from(-4.0f + 0.0625f * static_cast<float>(i), 2.0f,
                                 -4.0f + 0.0625f * static_cast<float>(j));
            for (const float zero : {0.0f, -0.0f}) {
                const rc::Ray down{.origin = from, .direction = {zero, -1.0f, -zero}};
                const auto hit = rc::closest_hit(*scene, down, rc::kAllLayers);
                leaks += !hit || hit->t != 2.0f;
            }
        }
    }
    EXPECT_EQ(leaks, 0);
}

INSTANTIATE_TEST_SUITE_P(EveryIsa, Watertight, ::testing::ValuesIn(test::supported_isas()),
                         test::isa_test_name);

}  // namespace
