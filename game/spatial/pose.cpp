#include "spatial/pose.h"

#include "base/contracts.h"
#include "base/vectors.h"
#include "spatial/transforms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gh::spatial {
namespace {

const glm::vec3 kForward(0.0f, 0.0f, -1.0f);
const glm::vec3 kEyeFromHead(0.0f, 0.1f, -0.1f);  // from the head joint, at the top of the neck, to the eyes
constexpr glm::vec3 kEyeWithoutHead(0.0f, 1.66f, 0.0f);  // of a grown man

glm::vec3 unit(const glm::vec3& v) {
    const float length = std::sqrt((v.x * v.x + v.y * v.y) + v.z * v.z);
    return length > 0.0f ? v / length : kForward;
}

glm::quat unit(const glm::quat& q) {
    const float length = std::sqrt(((q.x * q.x + q.y * q.y) + q.z * q.z) + q.w * q.w);
    if (!(length > 0.0f)) return {1.0f, 0.0f, 0.0f, 0.0f};
    return {q.w / length, q.x / length, q.y / length, q.z / length};
}

// Normalised lerp along the shorter of the two arcs.
glm::quat nlerp(const glm::quat& a, const glm::quat& b, float t) {
    const float cosine = ((a.x * b.x + a.y * b.y) + a.z * b.z) + a.w * b.w;
    const float s = 1.0f - t;
    const float to_b = cosine < 0.0f ? -t : t;
    return unit(
        glm::quat(s * a.w + to_b * b.w, s * a.x + to_b * b.x, s * a.y + to_b * b.y, s * a.z + to_b * b.z));
}

template <class Vector>
Vector lerp(const Vector& a, const Vector& b, float t) {
    return a * (1.0f - t) + b * t;
}

// Brings a time into [0, duration]: round and round, or held at the end.
float time_in_clip(const world::Clip& clip, bool is_looping, float seconds) {
    if (!(clip.duration > 0.0f) || !(seconds > 0.0f)) return 0.0f;
    if (!is_looping) return std::min(seconds, clip.duration);
    const float rounds = std::floor(seconds / clip.duration);
    return std::clamp(seconds - rounds * clip.duration, 0.0f, clip.duration);
}

struct Keys {  // the two keys around a time, and how far it is from the first to the second
    std::size_t before = 0;
    std::size_t after = 0;
    float share = 0.0f;
};

Keys keys_around(const world::Channel& channel, float seconds) {
    const auto next = std::upper_bound(channel.times.begin(), channel.times.end(), seconds);
    const auto after = static_cast<std::size_t>(next - channel.times.begin());
    if (after == 0) return {};
    if (after == channel.times.size()) return {.before = after - 1, .after = after - 1, .share = 0.0f};
    const float t0 = channel.times[after - 1];
    const float t1 = channel.times[after];
    const float share = channel.is_step ? 0.0f : (seconds - t0) / (t1 - t0);
    return {.before = after - 1, .after = after, .share = share};
}

void apply_channel(const world::Channel& channel, float seconds, JointPose& joint) {
    if (channel.times.empty()) return;
    const Keys keys = keys_around(channel, seconds);
    const glm::vec4& a = channel.values[keys.before];
    const glm::vec4& b = channel.values[keys.after];
    switch (channel.path) {
        case world::ChannelPath::Translation:
            joint.translation = lerp(glm::vec3(a), glm::vec3(b), keys.share);
            break;
        case world::ChannelPath::Scale:
            joint.scale = lerp(glm::vec3(a), glm::vec3(b), keys.share);
            break;
        case world::ChannelPath::Rotation:
            joint.rotation = nlerp(glm::quat(a.w, a.x, a.y, a.z), glm::quat(b.w, b.x, b.y, b.z), keys.share);
            break;
    }
}

glm::mat4x3 parent_from_joint(const JointPose& pose) {
    glm::mat4x3 matrix = rigid(pose.rotation, pose.translation);
    matrix[0] *= pose.scale.x;
    matrix[1] *= pose.scale.y;
    matrix[2] *= pose.scale.z;
    return matrix;
}

// Turned by `radians` about an axis through a point.
glm::mat4x3 turned_about(const glm::vec3& point, const glm::vec3& axis, float radians) {
    glm::mat4x3 turn = rigid(rotation_about(axis, radians), glm::vec3(0.0f));
    turn[3] = point - vector_through(turn, point);
    return turn;
}

}  // namespace

PoseKey pose_key(const world::GuardState& guard) {
    PoseKey key{.clip_time = guard.clip_time,
                .clip_before_time = guard.clip_before_time,
                .clip_blend = guard.clip_blend,
                .head_yaw = guard.head_yaw,
                .clip = guard.clip,
                .clip_before = guard.clip_before};
    if (key.clip_blend >= 1.0f) {  // the clip before is no longer seen: its time must not cost a refit
        key.clip_blend = 1.0f;
        key.clip_before = key.clip;
        key.clip_before_time = 0.0f;
    }
    return key;
}

void sample_clip(const world::Model& model, world::ClipId clip, float seconds, std::span<JointPose> out) {
    EXPECTS(out.size() == model.joints.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const world::Joint& rest = model.joints[i];
        out[i] = {
            .rotation = rest.rest_rotation, .translation = rest.rest_translation, .scale = rest.rest_scale};
    }
    const std::uint32_t index = model.clip[static_cast<std::size_t>(clip)];
    if (index == world::kNoIndex) return;
    const world::Clip& keys = model.clips[index];
    const float at = time_in_clip(keys, clip != world::ClipId::Reach, seconds);
    for (const world::Channel& channel : keys.channels) apply_channel(channel, at, out[channel.joint]);
}

void blend_over(std::span<const JointPose> from, float weight, std::span<JointPose> into) {
    EXPECTS(from.size() == into.size());
    for (std::size_t i = 0; i < into.size(); ++i) {
        into[i].rotation = nlerp(from[i].rotation, into[i].rotation, weight);
        into[i].translation = lerp(from[i].translation, into[i].translation, weight);
        into[i].scale = lerp(from[i].scale, into[i].scale, weight);
    }
}

void place_joints(const world::Model& model, std::span<const JointPose> pose, float head_yaw,
                  std::span<glm::mat4x3> mesh_from_joint) {
    EXPECTS(pose.size() == model.joints.size() && mesh_from_joint.size() == model.joints.size());
    const glm::vec3 up_in_mesh = unit(vector_through(inverse_of(model.model_from_mesh), kUp));
    for (std::size_t i = 0; i < pose.size(); ++i) {
        const std::uint32_t parent = model.joints[i].parent;
        const glm::mat4x3 local = parent_from_joint(pose[i]);
        mesh_from_joint[i] = parent == world::kNoIndex ? local : chain(mesh_from_joint[parent], local);
        if (i == model.head_joint && head_yaw != 0.0f) {
            const glm::mat4x3 turn = turned_about(mesh_from_joint[i][3], up_in_mesh, head_yaw);
            mesh_from_joint[i] = chain(turn, mesh_from_joint[i]);
        }
    }
}

void pose_body(const world::Model& model, const PoseKey& key, std::span<glm::mat4x3> skin) {
    std::vector<JointPose> pose(model.joints.size());
    sample_clip(model, key.clip, key.clip_time, pose);
    if (key.clip_blend < 1.0f) {
        std::vector<JointPose> before(model.joints.size());
        sample_clip(model, key.clip_before, key.clip_before_time, before);
        blend_over(before, std::max(key.clip_blend, 0.0f), pose);
    }
    place_joints(model, pose, key.head_yaw, skin);
    for (std::size_t i = 0; i < skin.size(); ++i) skin[i] = chain(skin[i], model.joints[i].joint_from_mesh);
}

Gaze gaze_of(const world::Model& model, float head_yaw, std::span<const glm::mat4x3> skin) {
    if (model.head_joint == world::kNoIndex) {
        const glm::mat4x3 turn = rigid(rotation_about(kUp, head_yaw), glm::vec3(0.0f));
        return {.eye = kEyeWithoutHead, .look = vector_through(turn, kForward)};
    }
    // The eyes ride on the head: from where they are at rest, through the head's own skin matrix.
    const glm::mat4x3 mesh_from_model = inverse_of(model.model_from_mesh);
    const glm::vec3 head_at_rest = inverse_of(model.joints[model.head_joint].joint_from_mesh)[3];
    const glm::vec3 eye_at_rest = head_at_rest + vector_through(mesh_from_model, kEyeFromHead);
    const glm::vec3 look_at_rest = vector_through(mesh_from_model, kForward);
    const glm::mat4x3 model_from_rest = chain(model.model_from_mesh, skin[model.head_joint]);
    return {.eye = point_through(model_from_rest, eye_at_rest),
            .look = unit(vector_through(model_from_rest, look_at_rest))};
}

}  // namespace gh::spatial
