// What a ray meets of a guard is where its joints have carried its skin.
#include "spatial/skinning.h"

#include "base/random.h"
#include "spatial/pose.h"
#include "spatial/transforms.h"
#include "support/small_level.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace gh::spatial {
namespace {

glm::mat4x3 random_affine(Random& random) {
    const glm::vec3 axis = glm::normalize(
        glm::vec3(random.in_range(-1.0f, 1.0f), random.in_range(-1.0f, 1.0f), random.in_range(0.1f, 1.0f)));
    glm::mat4x3 m =
        rigid(rotation_about(axis, random.in_range(-0.8f, 0.8f)),
              {random.in_range(-2.0f, 2.0f), random.in_range(-2.0f, 2.0f), random.in_range(-2.0f, 2.0f)});
    for (glm::length_t c = 0; c < 3; ++c) m[c] *= random.in_range(0.5f, 1.5f);
    return m;
}

// Against the textbook in double precision: sum of weighted matrices; normals by its inverse transpose.
TEST(Skinning, FollowsADoublePrecisionReference) {
    Random random(7);
    std::array<glm::mat4x3, 6> skin;
    for (glm::mat4x3& joint : skin) joint = random_affine(random);
    world::Mesh mesh;
    for (int i = 0; i < 500; ++i) {
        mesh.positions.emplace_back(random.in_range(-1.0f, 1.0f), random.in_range(0.0f, 2.0f),
                                    random.in_range(-1.0f, 1.0f));
        mesh.normals.push_back(glm::normalize(glm::vec3(
            random.in_range(-1.0f, 1.0f), random.in_range(-1.0f, 1.0f), random.in_range(0.05f, 1.0f))));
        mesh.joints.emplace_back(random.below(6), random.below(6), random.below(6), random.below(6));
        glm::vec4 weights(random.unit(), random.unit(), i % 3 == 0 ? 0.0f : random.unit(),
                          i % 2 == 0 ? 0.0f : random.unit());
        mesh.weights.push_back(weights / (weights.x + weights.y + weights.z + weights.w));
    }
    world::PosedMesh out;
    skin_mesh(mesh, skin, out);
    ASSERT_EQ(out.positions.size(), mesh.positions.size());
    ASSERT_EQ(out.normals.size(), mesh.normals.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        glm::dmat4x3 sum(0.0);
        for (glm::length_t k = 0; k < 4; ++k) {
            sum += glm::dmat4x3(skin[mesh.joints[i][k]]) * static_cast<double>(mesh.weights[i][k]);
        }
        const glm::dvec3 position = sum * glm::dvec4(glm::dvec3(mesh.positions[i]), 1.0);
        const glm::dvec3 normal =
            glm::normalize(glm::transpose(glm::inverse(glm::dmat3(sum))) * glm::dvec3(mesh.normals[i]));
        // A few roundings of terms no larger than 5.
        EXPECT_LT(glm::length(glm::dvec3(out.positions[i]) - position), 3e-6);
        EXPECT_LT(glm::length(glm::dvec3(out.normals[i]) - normal), 3e-6);
    }
}

TEST(Skinning, AnElbowBentByAQuarterPutsTheHandBesideTheShoulder) {
    // Upper arm from 0 to 1 along +x, forearm from 1 to 2; the elbow turns the forearm up.
    world::Model arm;
    arm.joints.resize(2);
    arm.joints[1].parent = 0;
    arm.joints[1].rest_translation = {1.0f, 0.0f, 0.0f};
    arm.joints[1].joint_from_mesh = test::moved_by({-1.0f, 0.0f, 0.0f});
    const float s = std::sqrt(0.5f);
    arm.clips.push_back({.name = "walk",
                         .duration = 1.0f,
                         .channels = {{.joint = 1,
                                       .path = world::ChannelPath::Rotation,
                                       .is_step = true,
                                       .times = {0.0f},
                                       .values = {{0.0f, 0.0f, s, s}}}}});
    arm.clip[1] = 0;
    world::Mesh mesh;
    mesh.positions = {{0.5f, 0.1f, 0.0f}, {2.0f, 0.0f, 0.0f}, {1.0f, 0.2f, 0.0f}};
    mesh.joints = {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}};
    mesh.weights = {{1, 0, 0, 0}, {1, 0, 0, 0}, {0.5f, 0.5f, 0, 0}};
    std::array<glm::mat4x3, 2> skin;
    pose_body(arm, {.clip = world::ClipId::Walk}, skin);
    world::PosedMesh out;
    skin_mesh(mesh, skin, out);
    EXPECT_TRUE(out.normals.empty());
    EXPECT_LT(glm::length(out.positions[0] - glm::vec3(0.5f, 0.1f, 0.0f)), 1e-6f);
    EXPECT_LT(glm::length(out.positions[1] - glm::vec3(1.0f, 1.0f, 0.0f)), 1e-6f);
    // Owned by both: halfway between staying at (1, .2) and turning to (.8, 0).
    EXPECT_LT(glm::length(out.positions[2] - glm::vec3(0.9f, 0.1f, 0.0f)), 1e-6f);
}

}  // namespace
}  // namespace gh::spatial
