// spatial/pose.h - where the joints of a body are at one moment of its clips.
//
// A pose is sampled (linear; rotations by normalised lerp along the shorter arc), two are blended, the head is turned,
// and the hierarchy is multiplied out. No libm: between keys 0.2 rad apart, normalised lerp differs from slerp by less
// than 3.5e-5 rad.
//
// Frames    "mesh" is the frame of the skin's rest vertices (the armature's); joints hang in it. "model" is the body
//           as it stands in the game: feet at the origin, facing -z, +y up.
// Cost      a few microseconds for 30 joints.
// Threads   pure.
// Bad input checked Levels. A clip that a model lacks is its rest pose.
#pragma once

#include "world/level.h"
#include "world/state.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace gh::spatial {

struct JointPose {  // relative to the parent joint
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 translation{0.0f};
    glm::vec3 scale{1.0f};
};

// What a guard's shape depends on, and nothing else: equal keys are equal shapes.
struct PoseKey {
    float clip_time = 0.0f;  // seconds
    float clip_before_time = 0.0f;
    float clip_blend = 1.0f;  // weight of clip over clip_before
    float head_yaw = 0.0f;
    world::ClipId clip = world::ClipId::Stand;
    world::ClipId clip_before = world::ClipId::Stand;

    bool operator==(const PoseKey&) const = default;
};
[[nodiscard]] PoseKey pose_key(const world::GuardState& guard);

// Joint i's pose `seconds` into a clip, into out[i]. Clips go round, except Reach, which holds its last pose.
void sample_clip(const world::Model& model, world::ClipId clip, float seconds, std::span<JointPose> out);

// into = (1 - weight) * from + weight * into, joint by joint.
void blend_over(std::span<const JointPose> from, float weight, std::span<JointPose> into);

// Multiplies the hierarchy out, with the head turned by head_yaw about the model's up axis (positive: left):
// mesh_from_joint[i] for every joint.
void place_joints(const world::Model& model, std::span<const JointPose> pose, float head_yaw,
                  std::span<glm::mat4x3> mesh_from_joint);

// The whole of the above for a key. skin[i] carries rest vertices that joint i owns to where they are now,
// both in the mesh's frame. skin.size() == model.joints.size().
void pose_body(const world::Model& model, const PoseKey& key, std::span<glm::mat4x3> skin);

struct Gaze {
    glm::vec3 eye{0.0f};   // metres
    glm::vec3 look{0.0f};  // unit
};

// Where a posed body looks from and to, in the model's frame; a model without a head looks from 1.66 m,
// ahead.
[[nodiscard]] Gaze gaze_of(const world::Model& model, float head_yaw, std::span<const glm::mat4x3> skin);

}  // namespace gh::spatial
