// Panels, panes and shells are measured from triangles.
#include "level_bytes.h"
#include "load/flat_face.h"
#include "load/open_edges.h"

#include <glm/geometric.hpp>

namespace gh {
namespace {

using test::expect_near;

TEST(FlatFace, IsTheLeastRectangleAlongTheFacesOwnEdges) {
    // 2 x 1 m, turned by the angle whose cosine is 0.8, beside a small triangle in another plane.
    const glm::vec3 u(0.8f, 0.6f, 0.0f), v(-0.6f, 0.8f, 0.0f), c(3.0f, 2.0f, 1.0f);
    const std::vector<glm::vec3> p{c - u - 0.5f * v, c + u - 0.5f * v, c + u + 0.5f * v, c - u + 0.5f * v,
                                   {0, 0, 0},        {0.1f, 0, 0},     {0, 0, 0.1f}};
    const std::vector<glm::uvec3> triangles{{4, 5, 6}, {0, 1, 2}, {0, 2, 3}};
    const auto face = load::largest_flat_face(p, triangles);
    ASSERT_TRUE(face);
    expect_near(face->centre, c);
    expect_near(face->normal, {0.0f, 0.0f, 1.0f});
    EXPECT_NEAR(face->area, 2.0f, 1e-5f);
    EXPECT_NEAR(face->whole_area, 2.005f, 1e-5f);
    EXPECT_NEAR(glm::length(face->half_u) * glm::length(face->half_v), 0.5f, 1e-5f);
    EXPECT_NEAR(glm::dot(face->half_u, face->half_v), 0.0f, 1e-6f);
    expect_near(glm::normalize(glm::cross(face->half_u, face->half_v)), face->normal);
    EXPECT_NE(face->triangle, 0u);
}

TEST(FlatFace, JoinsManySmallTrianglesBeforeItTakesOneLargeOne) {
    std::vector<glm::vec3> p{{0, 5, 0}, {0, 5, 1.2f}, {1.2f, 5, 0}};  // one of 0.72 m2, facing up
    std::vector<glm::uvec3> triangles{{0, 1, 2}};
    constexpr int kSide = 10;  // a panel of 1 m2 in 200 triangles, facing -z
    for (int y = 0; y <= kSide; ++y) {
        for (int x = 0; x <= kSide; ++x)
            p.emplace_back(0.1f * static_cast<float>(x), 0.1f * static_cast<float>(y), 0.0f);
    }
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const std::uint32_t a = 3 + y * (kSide + 1) + x, b = a + 1, c = a + kSide + 1, d = c + 1;
            triangles.emplace_back(a, c, b);
            triangles.emplace_back(b, c, d);
        }
    }
    const auto face = load::largest_flat_face(p, triangles);
    ASSERT_TRUE(face);
    EXPECT_NEAR(face->area, 1.0f, 1e-4f);
    expect_near(face->normal, {0.0f, 0.0f, -1.0f});
    expect_near(face->centre, {0.5f, 0.5f, 0.0f});
}

TEST(FlatFace, IsNothingWhereThereIsNoArea) {
    const std::vector<glm::vec3> p{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 0, 1}};
    EXPECT_FALSE(load::largest_flat_face(p, triangles));
    EXPECT_FALSE(load::largest_flat_face(p, {}));
}

// The shell of the tiny level: every side has corners of its own, so closedness must be seen by position.
TEST(OpenEdges, AreNoneInAClosedShellAndFourAroundAMissingSide) {
    const Result<world::Level> level = test::load_quickly(test::tiny_level_glb());
    ASSERT_TRUE(level);
    world::Mesh shell = level->meshes.at(test::named(level->parts, "shell")->mesh);
    EXPECT_EQ(load::find_open_edges(shell).count, 0u);
    shell.triangles.resize(10);  // the last side, at z = 0.5, is gone
    const load::OpenEdges open = load::find_open_edges(shell);
    EXPECT_EQ(open.count, 4u);
    for (const glm::vec3& middle : open.middles) EXPECT_FLOAT_EQ(middle.z, 0.5f);
}

TEST(OpenEdges, ShowTJoints) {
    // A square of two triangles above, of three below: their common side has a corner in its middle on one
    // side only.
    world::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}, {1, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 4}, {4, 3, 1}};
    EXPECT_EQ(load::find_open_edges(mesh).count, 7u);  // 4 outside, and 0-1 against 0-4 and 4-1
}

}  // namespace
}  // namespace gh
