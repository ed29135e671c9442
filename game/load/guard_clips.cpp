#include "load/gltf_accessor.h"
#include "load/gltf_file.h"
#include "load/guard_model.h"
#include "load/limits.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gh::load {
namespace {

// Keys as the file has them: for a cubic spline, three values a key (tangent in, value, tangent out).
struct FileKeys {
    std::vector<float> times;
    std::vector<glm::vec4> values;
    bool is_cubic = false;
};

glm::vec4 unit_rotation(const glm::vec4& q) {
    const float length = glm::length(q);
    return length > 0.0f ? q / length : glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
}

Result<void> check_times(const std::vector<float>& times) {
    constexpr float kLongest = 3600.0f;  // seconds
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (!(times[i] >= 0.0f && times[i] <= kLongest))
            return Error{fmt::format("key {} is out of range", i)};
        if (i > 0 && !(times[i] > times[i - 1]))
            return Error{fmt::format("key {} does not come after the one before", i)};
    }
    return {};
}

Result<FileKeys> read_keys(const tinygltf::Model& model, const tinygltf::AnimationSampler& sampler,
                           bool is_rotation) {
    FileKeys keys;
    keys.is_cubic = sampler.interpolation == "CUBICSPLINE";
    Result<std::vector<float>> times = read_scalars(model, sampler.input);
    if (!times) return times.error();
    if (const Result<void> checked = check_times(*times); !checked) return checked.error();
    keys.times = std::move(*times);
    if (is_rotation) {
        Result<std::vector<glm::vec4>> values = read_vec4s(model, sampler.output);
        if (!values) return values.error();
        keys.values = std::move(*values);
    } else {
        const Result<std::vector<glm::vec3>> values = read_vec3s(model, sampler.output);
        if (!values) return values.error();
        for (const glm::vec3& value : *values) keys.values.emplace_back(value, 0.0f);
    }
    const std::size_t wanted = keys.times.size() * (keys.is_cubic ? 3 : 1);
    if (keys.times.empty() || keys.values.size() != wanted) {
        return Error{fmt::format("has {} values where {} belong", keys.values.size(), wanted)};
    }
    return keys;
}

void add_key(world::Channel& channel, float time, const glm::vec4& value) {
    if (!channel.times.empty() && !(time > channel.times.back())) return;  // steps finer than float's grain
    channel.times.push_back(time);
    channel.values.push_back(channel.path == world::ChannelPath::Rotation ? unit_rotation(value) : value);
}

// Hermite's cubic between two keys, sixty times a second.
void resample_cubic(const FileKeys& keys, world::Channel& channel) {
    constexpr float kRate = 60.0f;
    constexpr float kMostSteps = 256.0f;
    add_key(channel, keys.times[0], keys.values[1]);
    for (std::size_t i = 0; i + 1 < keys.times.size(); ++i) {
        const float t0 = keys.times[i], span = keys.times[i + 1] - t0;
        const glm::vec4 p0 = keys.values[3 * i + 1], m0 = keys.values[3 * i + 2] * span;
        const glm::vec4 p1 = keys.values[3 * i + 4], m1 = keys.values[3 * i + 3] * span;
        const auto steps = static_cast<int>(std::clamp(std::floor(span * kRate), 1.0f, kMostSteps));
        for (int k = 1; k <= steps; ++k) {
            const float s = static_cast<float>(k) / static_cast<float>(steps), s2 = s * s, s3 = s2 * s;
            const glm::vec4 value = p0 * ((2.0f * s3 - 3.0f * s2) + 1.0f) + m0 * ((s3 - 2.0f * s2) + s) +
                                    p1 * (3.0f * s2 - 2.0f * s3) + m1 * (s3 - s2);
            add_key(channel, k == steps ? keys.times[i + 1] : t0 + span * s, value);
        }
    }
}

// The game turns between keys along the chord. Where that would lag behind the arc, keys are put between: the
// middle of an arc is the sum of its ends made unit, so no sine is needed.
void add_arc(world::Channel& channel, float t0, const glm::vec4& q0, float t1, const glm::vec4& q1,
             int depth) {
    constexpr float kShortEnough = 0.9986f;  // cosine of half of 6 degrees: the chord then errs by 1e-4 rad
    const glm::vec4 near_q1 = glm::dot(q0, q1) < 0.0f ? -q1 : q1;
    if (depth > 0 && glm::dot(q0, near_q1) < kShortEnough) {
        const glm::vec4 middle = unit_rotation(q0 + near_q1);
        const float t = 0.5f * (t0 + t1);
        add_arc(channel, t0, q0, t, middle, depth - 1);
        add_arc(channel, t, middle, t1, near_q1, depth - 1);
        return;
    }
    add_key(channel, t1, near_q1);
}

world::Channel make_channel(const FileKeys& keys, world::ChannelPath path, bool is_step) {
    world::Channel channel;
    channel.path = path;
    channel.is_step = is_step;
    if (keys.is_cubic) {
        resample_cubic(keys, channel);
        return channel;
    }
    add_key(channel, keys.times[0], keys.values[0]);
    constexpr int kHalvings = 6;
    const bool is_arc = path == world::ChannelPath::Rotation && !is_step;
    for (std::size_t i = 1; i < keys.times.size(); ++i) {
        if (is_arc) {
            add_arc(channel, keys.times[i - 1], unit_rotation(keys.values[i - 1]), keys.times[i],
                    unit_rotation(keys.values[i]), kHalvings);
        } else {
            add_key(channel, keys.times[i], keys.values[i]);
        }
    }
    return channel;
}

std::optional<world::ChannelPath> path_from_name(const std::string& name) {
    if (name == "translation") return world::ChannelPath::Translation;
    if (name == "rotation") return world::ChannelPath::Rotation;
    if (name == "scale") return world::ChannelPath::Scale;
    return std::nullopt;  // morph weights
}

Result<world::Clip> read_clip(const tinygltf::Model& model, const tinygltf::Animation& animation,
                              const std::vector<std::uint32_t>& joint_of_node, std::size_t& keys_left) {
    world::Clip clip;
    clip.name = animation.name;
    for (const tinygltf::AnimationChannel& from : animation.channels) {
        const auto node = static_cast<std::size_t>(from.target_node);
        const std::optional<world::ChannelPath> path = path_from_name(from.target_path);
        if (from.target_node < 0 || node >= joint_of_node.size() || joint_of_node[node] == world::kNoIndex ||
            !path)
            continue;
        if (from.sampler < 0 || static_cast<std::size_t>(from.sampler) >= animation.samplers.size()) {
            return Error{fmt::format("sampler {} does not exist", from.sampler)};
        }
        const tinygltf::AnimationSampler& sampler =
            animation.samplers[static_cast<std::size_t>(from.sampler)];
        const Result<FileKeys> keys = read_keys(model, sampler, *path == world::ChannelPath::Rotation);
        if (!keys) return Error{fmt::format("sampler {}: {}", from.sampler, keys.error().sentence)};
        const auto refuse = [] { return Error{fmt::format("makes more than {} keys together", kMaxKeys)}; };
        if (keys->times.size() > keys_left / 16) return refuse();  // resampling adds some
        world::Channel channel = make_channel(*keys, *path, sampler.interpolation == "STEP");
        if (channel.times.size() > keys_left) return refuse();
        keys_left -= channel.times.size();
        channel.joint = joint_of_node[node];
        clip.channels.push_back(std::move(channel));
    }
    return clip;
}

// Exporters begin clips at their first frame's time, which need not be 0.
void start_at_zero(world::Clip& clip) {
    float begin = std::numeric_limits<float>::infinity(), end = 0.0f;
    for (const world::Channel& channel : clip.channels) {
        begin = std::min(begin, channel.times.front());
        end = std::max(end, channel.times.back());
    }
    clip.duration = end - begin;
    if (begin == 0.0f) return;
    for (world::Channel& channel : clip.channels) {
        for (float& time : channel.times) time -= begin;
    }
}

}  // namespace

Result<std::vector<world::Clip>> read_clips(const tinygltf::Model& model,
                                            const std::vector<std::uint32_t>& node_of_joint,
                                            std::size_t& keys_left) {
    std::vector<std::uint32_t> joint_of_node(model.nodes.size(), world::kNoIndex);
    for (std::size_t i = 0; i < node_of_joint.size(); ++i)
        joint_of_node[node_of_joint[i]] = static_cast<std::uint32_t>(i);
    std::vector<world::Clip> clips;
    for (std::size_t i = 0; i < model.animations.size(); ++i) {
        Result<world::Clip> clip = read_clip(model, model.animations[i], joint_of_node, keys_left);
        if (!clip) {
            return Error{fmt::format("animation {}: {}", name_or_number(model.animations[i].name, i),
                                     clip.error().sentence)};
        }
        if (clip->channels.empty()) continue;  // of something else
        start_at_zero(*clip);
        clips.push_back(std::move(*clip));
    }
    return clips;
}

}  // namespace gh::load
