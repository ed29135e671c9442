#include "load/guard_model.h"

#include "load/gltf_accessor.h"
#include "load/limits.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace gh::load {
namespace {

constexpr std::array<std::string_view, world::kClipCount> kClipNames{"stand", "walk", "look", "run", "reach"};

std::vector<bool> nodes_below(const NodeTree& tree, std::uint32_t root) {
    std::vector<bool> is_below(tree.parent.size(), false);
    for (const std::uint32_t id : tree.order) {
        const std::uint32_t parent = tree.parent[id];
        is_below[id] = parent != world::kNoIndex && (parent == root || is_below[parent]);
    }
    return is_below;
}

Result<std::uint32_t> skinned_node(const LevelBuild& build, const std::vector<bool>& is_below) {
    std::uint32_t found = world::kNoIndex;
    for (const std::uint32_t id : build.tree.order) {
        if (!is_below[id] || build.node(id).mesh < 0) continue;
        if (found != world::kNoIndex) return Error{"has more than one mesh; a guard_model has one, skinned"};
        found = id;
    }
    if (found == world::kNoIndex || build.node(found).skin < 0) return Error{"has no skinned mesh"};
    if (static_cast<std::size_t>(build.node(found).skin) >= build.model.skins.size()) {
        return Error{fmt::format("skin {} does not exist", build.node(found).skin)};
    }
    return found;
}

// The skin's joints and whatever lies between them and the armature, parents first.
Result<std::vector<std::uint32_t>> joint_nodes(const LevelBuild& build, const tinygltf::Skin& skin,
                                               const std::vector<bool>& is_below) {
    std::vector<bool> is_joint(build.model.nodes.size(), false);
    for (const int joint : skin.joints) {
        if (joint < 0 || static_cast<std::size_t>(joint) >= is_joint.size() ||
            !is_below[static_cast<std::size_t>(joint)]) {
            return Error{fmt::format("its joint, node {}, is not below it", joint)};
        }
        for (auto id = static_cast<std::uint32_t>(joint); is_below[id] && !is_joint[id];
             id = build.tree.parent[id]) {
            is_joint[id] = true;
            if (build.tree.parent[id] == world::kNoIndex) break;
        }
    }
    std::vector<std::uint32_t> nodes;
    for (const std::uint32_t id : build.tree.order) {
        if (is_joint[id]) nodes.push_back(id);
    }
    if (nodes.empty()) return Error{"its skin has no joints"};
    if (nodes.size() > kMaxJoints)
        return Error{fmt::format("has {} joints, the most is {}", nodes.size(), kMaxJoints)};
    return nodes;
}

world::Joint rest_of(const tinygltf::Node& node) {
    world::Joint joint;
    joint.name = node.name;
    const glm::dmat4 local = local_matrix(node);
    const Pose pose = pose_of(local);
    joint.rest_translation = glm::vec3(pose.position);
    joint.rest_rotation = glm::quat(pose.rotation);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        joint.rest_scale[axis] = static_cast<float>(glm::length(glm::dvec3(local[axis])));
    }
    if (glm::determinant(local) < 0.0)
        joint.rest_scale.x = -joint.rest_scale.x;  // pose_of turns mirrors back on x
    return joint;
}

std::uint32_t index_of(const std::vector<std::uint32_t>& nodes, std::uint32_t node) {
    const auto found = std::find(nodes.begin(), nodes.end(), node);
    return found == nodes.end() ? world::kNoIndex : static_cast<std::uint32_t>(found - nodes.begin());
}

Result<void> read_inverse_binds(const LevelBuild& build, const tinygltf::Skin& skin,
                                const std::vector<std::uint32_t>& model_joint_of, world::Model& model) {
    if (skin.inverseBindMatrices < 0) return {};  // glTF: then they are identities
    const Result<std::vector<glm::mat4>> matrices = read_mat4s(build.model, skin.inverseBindMatrices);
    if (!matrices) return matrices.error();
    if (matrices->size() < skin.joints.size()) {
        return Error{
            fmt::format("has {} inverse bind matrices for {} joints", matrices->size(), skin.joints.size())};
    }
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        model.joints[model_joint_of[i]].joint_from_mesh = glm::mat4x3((*matrices)[i]);
    }
    return {};
}

// From the skin's numbering of joints to the model's. A joint of weight zero may be any number in the file.
Result<void> renumber_joints(const std::vector<std::uint32_t>& model_joint_of, world::Mesh& mesh) {
    for (std::size_t v = 0; v < mesh.joints.size(); ++v) {
        for (glm::length_t k = 0; k < 4; ++k) {
            const std::uint16_t joint = mesh.joints[v][k];
            const bool is_known = joint < model_joint_of.size();
            if (!is_known && mesh.weights[v][k] > 0.0f) {
                return Error{
                    fmt::format("vertex {} hangs on joint {} of {}", v, joint, model_joint_of.size())};
            }
            mesh.joints[v][k] =
                is_known ? static_cast<std::uint16_t>(model_joint_of[joint]) : std::uint16_t{0};
        }
    }
    return {};
}

void name_clips_and_head(world::Model& model) {
    for (std::size_t i = 0; i < model.clips.size(); ++i) {
        for (std::size_t c = 0; c < kClipNames.size(); ++c) {
            if (model.clips[i].name == kClipNames[c]) model.clip[c] = static_cast<std::uint32_t>(i);
        }
    }
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
        if (model.joints[i].name == "head") model.head_joint = static_cast<std::uint32_t>(i);
    }
}

}  // namespace

Result<world::Model> read_guard_model(LevelBuild& build, std::uint32_t root) {
    const std::vector<bool> is_below = nodes_below(build.tree, root);
    const Result<std::uint32_t> body = skinned_node(build, is_below);
    if (!body) return body.error();
    const tinygltf::Skin& skin = build.model.skins[static_cast<std::size_t>(build.node(*body).skin)];
    const Result<std::vector<std::uint32_t>> nodes = joint_nodes(build, skin, is_below);
    if (!nodes) return nodes.error();

    world::Model model;
    model.name = build.node(root).name;
    const glm::dmat4& world_from_armature = build.tree.world_from_node[root];
    model.model_from_mesh =
        to_affine(glm::inverse(pose_of(world_from_armature).matrix()) * world_from_armature);
    for (const std::uint32_t node : *nodes) {
        model.joints.push_back(rest_of(build.node(node)));
        model.joints.back().parent = index_of(*nodes, build.tree.parent[node]);
    }
    std::vector<std::uint32_t> model_joint_of;
    for (const int joint : skin.joints)
        model_joint_of.push_back(index_of(*nodes, static_cast<std::uint32_t>(joint)));
    if (const Result<void> read = read_inverse_binds(build, skin, model_joint_of, model); !read)
        return read.error();

    Result<world::Mesh> mesh = build.meshes.read_whole(build.node(*body).mesh);
    if (!mesh) return mesh.error();
    if (mesh->triangles.empty() || mesh->joints.empty())
        return Error{"its mesh has no triangles that hang on joints"};
    if (const Result<void> renumbered = renumber_joints(model_joint_of, *mesh); !renumbered)
        return renumbered.error();
    model.mesh = build.meshes.add(std::move(*mesh));

    Result<std::vector<world::Clip>> clips = read_clips(build.model, *nodes, build.keys_left);
    if (!clips) return clips.error();
    model.clips = std::move(*clips);
    name_clips_and_head(model);
    return model;
}

}  // namespace gh::load
