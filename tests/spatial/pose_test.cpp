// A guard's joints follow its clips, its head follows what it looks for, and its eyes ride on its head.
#include "spatial/pose.h"

#include "base/det_math.h"
#include "spatial/transforms.h"
#include "support/small_level.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace gh::spatial {
namespace {

using Skin = std::array<glm::mat4x3, 3>;

Skin posed(const world::Model& model, const PoseKey& key) {
    Skin skin;
    pose_body(model, key, skin);
    return skin;
}

void expect_same_bits(const Skin& a, const Skin& b) {
    EXPECT_TRUE(a == b);
}

void expect_near(const glm::vec3& a, const glm::vec3& b, float tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

// The crown of the doll's head at rest, 0.25 m above the head joint.
const glm::vec3 kCrown(0.0f, 1.8f, 0.0f);

TEST(Pose, AClipIsExactAtItsKeysAndBendsByTheAngleBetween) {
    const world::Model model = test::doll_model(0);
    // At 0.5 s the chest has turned by 2 atan(0.6 / 0.8) about -x: the crown, 0.6 m above the chest, bows forwards.
    const double angle = 2.0 * std::atan2(0.6, 0.8);
    const glm::vec3 bowed(0.0f, static_cast<float>(1.2 + 0.6 * std::cos(angle)),
                          static_cast<float>(-0.6 * std::sin(angle)));
    const Skin at_key =
        posed(model, {.clip_time = 0.5f, .clip = world::ClipId::Walk, .clip_before = world::ClipId::Walk});
    expect_near(point_through(at_key[2], kCrown), bowed, 1e-6f);

    // Halfway between two keys a normalised lerp has exactly half the angle.
    const glm::vec3 half_bowed(0.0f, static_cast<float>(1.2 + 0.6 * std::cos(angle / 2)),
                               static_cast<float>(-0.6 * std::sin(angle / 2)));
    const Skin between =
        posed(model, {.clip_time = 0.25f, .clip = world::ClipId::Walk, .clip_before = world::ClipId::Walk});
    expect_near(point_through(between[2], kCrown), half_bowed, 1e-6f);
}

TEST(Pose, WalkingGoesRoundAndReachingHolds) {
    const world::Model model = test::doll_model(0);
    const auto walk = [&](float t) { return posed(model, {.clip_time = t, .clip = world::ClipId::Walk}); };
    expect_same_bits(walk(0.25f), walk(3.25f));
    expect_same_bits(walk(0.0f), walk(1.0f));
    const auto reach = [&](float t) { return posed(model, {.clip_time = t, .clip = world::ClipId::Reach}); };
    expect_same_bits(reach(0.5f), reach(9.0f));
    expect_near(point_through(reach(9.0f)[0], kCrown), kCrown + glm::vec3(0.0f, 0.2f, 0.0f), 1e-6f);
}

TEST(Pose, AClipThatAModelLacksIsItsRestPose) {
    const world::Model model = test::doll_model(0);
    const Skin run = posed(model, {.clip_time = 0.4f, .clip = world::ClipId::Run});
    for (const glm::mat4x3& joint : run) expect_near(point_through(joint, kCrown), kCrown, 1e-6f);
}

TEST(Pose, ABlendGoesFromOneClipToTheOther) {
    const world::Model model = test::doll_model(0);
    PoseKey key{.clip_time = 0.5f,
                .clip_before_time = 0.0f,
                .clip_blend = 0.0f,
                .head_yaw = 0.0f,
                .clip = world::ClipId::Reach,
                .clip_before = world::ClipId::Stand};
    for (const float weight : {0.0f, 0.25f, 1.0f}) {
        key.clip_blend = weight;
        expect_near(point_through(posed(model, key)[0], kCrown),
                    kCrown + glm::vec3(0.0f, 0.2f * weight, 0.0f), 1e-6f);
    }
}

TEST(Pose, AFinishedBlendForgetsTheClipBefore) {
    world::GuardState guard;
    guard.clip = world::ClipId::Walk;
    guard.clip_before = world::ClipId::Look;
    guard.clip_before_time = 0.7f;
    guard.clip_blend = 1.0f;
    world::GuardState later = guard;
    later.clip_before_time = 0.9f;
    EXPECT_TRUE(pose_key(guard) == pose_key(later)) << "a time nobody sees would cost a refit every tick";
    later.clip_blend = 0.5f;
    EXPECT_FALSE(pose_key(guard) == pose_key(later));
}

TEST(Pose, AHeadTurnsAloneAndTakesTheEyesAlong) {
    const world::Model model = test::doll_model(0);
    const Skin ahead = posed(model, {});
    const Skin turned = posed(model, {.head_yaw = kPi / 2.0f});
    EXPECT_TRUE(ahead[0] == turned[0]);
    EXPECT_TRUE(ahead[1] == turned[1]);

    const Gaze before = gaze_of(model, 0.0f, ahead);
    const Gaze after = gaze_of(model, kPi / 2.0f, turned);
    expect_near(before.look, {0.0f, 0.0f, -1.0f}, 1e-6f);
    expect_near(after.look, {-1.0f, 0.0f, 0.0f}, 1e-6f);  // to the left
    EXPECT_NEAR(before.eye.y, after.eye.y, 1e-6f);
    EXPECT_LT(before.eye.z, 0.0f) << "eyes are in front of the neck";
    EXPECT_NEAR(after.eye.x, before.eye.z, 1e-6f);
}

TEST(Pose, LookingRoundMovesTheGazeAsTheClipTurnsTheHead) {
    const world::Model model = test::doll_model(0);
    const Gaze gaze = gaze_of(model, 0.0f, posed(model, {.clip_time = 1.0f, .clip = world::ClipId::Look}));
    expect_near(gaze.look, {-1.0f, 0.0f, 0.0f}, 1e-6f);
}

TEST(Pose, AHeadTurnsAboutTheModelsUpEvenWhenTheMeshLiesDown) {
    // An armature whose own up is z, stood upright by model_from_mesh: the same turn, the same gaze.
    world::Model model = test::doll_model(0);
    const glm::mat4x3 mesh_from_model =
        rigid(rotation_about({1.0f, 0.0f, 0.0f}, kPi / 2.0f), glm::vec3(0.0f));
    model.model_from_mesh = inverse_of(mesh_from_model);
    for (world::Joint& joint : model.joints) {
        joint.joint_from_mesh = chain(joint.joint_from_mesh, model.model_from_mesh);
        if (joint.parent != world::kNoIndex) continue;
        joint.rest_translation = point_through(mesh_from_model, joint.rest_translation);
        joint.rest_rotation = rotation_about({1.0f, 0.0f, 0.0f}, kPi / 2.0f);
    }
    const Gaze gaze = gaze_of(model, 0.6f, posed(model, {.head_yaw = 0.6f}));
    const world::Model upright = test::doll_model(0);
    const Gaze expected = gaze_of(upright, 0.6f, posed(upright, {.head_yaw = 0.6f}));
    expect_near(gaze.look, expected.look, 1e-6f);
    expect_near(gaze.eye, expected.eye, 2e-6f);
}

TEST(Pose, BetweenKeysAFifthOfARadianApartNormalisedLerpIsSlerpToTwoThousandthsOfADegree) {
    world::Model model = test::doll_model(0);
    const double angle = 0.2;
    world::Channel& turn = model.clips[2].channels[0];
    turn.times = {0.0f, 1.0f};
    turn.values = {
        {0.0f, 0.0f, 0.0f, 1.0f},
        {0.0f, static_cast<float>(std::sin(angle / 2)), 0.0f, static_cast<float>(std::cos(angle / 2))}};
    double worst = 0.0;
    for (int i = 0; i <= 100; ++i) {
        const float t = 0.01f * static_cast<float>(i);
        std::array<JointPose, 3> pose;
        sample_clip(model, world::ClipId::Look, t, pose);
        const double got = 2.0 * std::atan2(static_cast<double>(pose[2].rotation.y),
                                            static_cast<double>(pose[2].rotation.w));
        worst = std::max(worst, std::abs(got - angle * static_cast<double>(t)));
    }
    EXPECT_LT(worst, 3.5e-5);
    EXPECT_GT(worst, 0.0) << "nothing was measured";
}

}  // namespace
}  // namespace gh::spatial
