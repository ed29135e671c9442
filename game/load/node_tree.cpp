#include "load/node_tree.h"

#include "base/det_math.h"
#include "load/gltf_file.h"
#include "load/limits.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gh::load {
namespace {

constexpr double kNear = 256.0;  // metres: floats are at most 3e-5 m apart

bool is_in_range(const glm::dmat4& matrix, double farthest) {
    for (glm::length_t c = 0; c < 4; ++c) {
        for (glm::length_t r = 0; r < 3; ++r) {
            if (!(std::abs(matrix[c][r]) <= (c < 3 ? kMaxCoordinate : farthest))) return false;
        }
    }
    return matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 && matrix[3][3] == 1.0;
}

// The nodes that no other node has as a child, for files without a scene.
std::vector<int> roots_of(const tinygltf::Model& model) {
    if (!model.scenes.empty()) {
        const auto wanted = static_cast<std::size_t>(std::max(model.defaultScene, 0));
        return model.scenes[wanted < model.scenes.size() ? wanted : 0].nodes;
    }
    std::vector<bool> is_child(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes) {
        for (const int child : node.children) {
            if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
                is_child[static_cast<std::size_t>(child)] = true;
        }
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    }
    return roots;
}

struct Visit {
    int node;
    std::uint32_t parent;
    int depth;
};

// glTF's own reader passes over numbers that are too few or too many, and the node would stand somewhere else.
bool is_whole(const tinygltf::Node& node) {
    const auto has = [](const std::vector<double>& numbers, std::size_t count) {
        return numbers.empty() || numbers.size() == count;
    };
    return has(node.matrix, 16) && has(node.translation, 3) && has(node.rotation, 4) && has(node.scale, 3);
}

Error out_of_range(const std::string& name) {
    return Error{name + ": its transform is not finite, not affine, or out of range"};
}

Result<void> visit(const tinygltf::Model& model, const Visit& at, std::vector<bool>& is_seen,
                   NodeTree& tree) {
    if (at.node < 0 || static_cast<std::size_t>(at.node) >= model.nodes.size()) {
        return Error{fmt::format("node {} does not exist", at.node)};
    }
    const auto id = static_cast<std::uint32_t>(at.node);
    const std::string name = node_name(model, id);
    if (is_seen[id]) return Error{name + " hangs on two nodes, or on itself"};
    if (at.depth > kMaxNodeDepth)
        return Error{fmt::format("{} lies more than {} nodes deep", name, kMaxNodeDepth)};
    if (!is_whole(model.nodes[id])) return Error{name + ": its transform has too few or too many numbers"};
    is_seen[id] = true;
    glm::dmat4 matrix = local_matrix(model.nodes[id]);
    if (at.parent != world::kNoIndex) matrix = tree.world_from_node[at.parent] * matrix;
    if (!is_in_range(matrix, kMaxFarCoordinate)) return out_of_range(name);
    tree.world_from_node[id] = matrix;
    tree.parent[id] = at.parent;
    tree.order.push_back(id);
    return {};
}

// Medians, so that what lies apart, a model in store or a distant backdrop, moves nothing.
glm::dvec3 middle_of_meshes(const tinygltf::Model& model, const NodeTree& tree) {
    glm::dvec3 middle(0.0);
    std::vector<double> places;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        places.clear();
        for (const std::uint32_t id : tree.order) {
            if (model.nodes[id].mesh >= 0) places.push_back(tree.world_from_node[id][3][axis]);
        }
        if (places.empty()) return middle;
        const auto half = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
        std::nth_element(places.begin(), half, places.end());
        middle[axis] = *half;
    }
    return middle;
}

Result<void> bring_near(const tinygltf::Model& model, NodeTree& tree) {
    const glm::dvec3 middle = middle_of_meshes(model, tree);
    if (glm::length(middle) > kNear) tree.origin = glm::floor(middle);
    for (const std::uint32_t id : tree.order) {
        glm::dmat4& matrix = tree.world_from_node[id];
        matrix[3] -= glm::dvec4(tree.origin, 0.0);
        if (!is_in_range(matrix, kMaxCoordinate)) return out_of_range(node_name(model, id));
    }
    return {};
}

}  // namespace

glm::dmat4 local_matrix(const tinygltf::Node& node) {
    glm::dmat4 matrix(1.0);
    if (node.matrix.size() == 16) {
        for (std::size_t i = 0; i < 16; ++i) {
            matrix[static_cast<glm::length_t>(i / 4)][static_cast<glm::length_t>(i % 4)] = node.matrix[i];
        }
        return matrix;
    }
    if (node.rotation.size() == 4) {
        const glm::dquat rotation(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        const double length = std::sqrt(glm::dot(rotation, rotation));
        if (length > 1.0e-6) matrix = glm::mat4_cast(rotation / length);
    }
    for (std::size_t i = 0; i < 3 && node.scale.size() == 3; ++i) {
        matrix[static_cast<glm::length_t>(i)] *= node.scale[i];
    }
    if (node.translation.size() == 3) {
        matrix[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1.0);
    }
    return matrix;
}

Result<NodeTree> read_nodes(const tinygltf::Model& model) {
    NodeTree tree;
    tree.parent.assign(model.nodes.size(), world::kNoIndex);
    tree.world_from_node.assign(model.nodes.size(), glm::dmat4(1.0));
    std::vector<bool> is_seen(model.nodes.size(), false);
    std::vector<Visit> stack;
    const auto push = [&stack](const std::vector<int>& nodes, std::uint32_t parent, int depth) {
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
            stack.push_back({*node, parent, depth});
    };
    push(roots_of(model), world::kNoIndex, 0);
    while (!stack.empty()) {
        const Visit at = stack.back();
        stack.pop_back();
        if (Result<void> visited = visit(model, at, is_seen, tree); !visited) return visited.error();
        const auto id = static_cast<std::uint32_t>(at.node);
        push(model.nodes[id].children, id, at.depth + 1);
    }
    if (const Result<void> near = bring_near(model, tree); !near) return near.error();
    return tree;
}

std::string node_name(const tinygltf::Model& model, std::uint32_t node) {
    return "node " + name_or_number(model.nodes[node].name, node);
}

glm::dmat4 Pose::matrix() const {
    glm::dmat4 result = glm::mat4_cast(rotation);
    result[3] = glm::dvec4(position, 1.0);
    return result;
}

Pose pose_of(const glm::dmat4& world_from_node) {
    Pose pose;
    pose.position = glm::dvec3(world_from_node[3]);
    const glm::dvec3 z(world_from_node[2]), y(world_from_node[1]);
    const double z_length = glm::length(z);
    if (!(z_length > 0.0)) return pose;
    const glm::dvec3 z_axis = z / z_length;
    const glm::dvec3 y_across = y - z_axis * glm::dot(z_axis, y);
    const double y_length = glm::length(y_across);
    if (!(y_length > 0.0)) return pose;
    const glm::dvec3 y_axis = y_across / y_length;
    pose.rotation = glm::normalize(glm::quat_cast(glm::dmat3(glm::cross(y_axis, z_axis), y_axis, z_axis)));
    return pose;
}

float yaw_of(const glm::dmat4& world_from_node) {
    const glm::vec3 back(world_from_node[2]);
    return det::atan2(back.x, back.z);  // forward is (-sin yaw, ., -cos yaw), and so back is +
}

float pitch_of(const glm::dmat4& world_from_node) {
    const glm::dvec3 back(world_from_node[2]);
    const double across = std::sqrt(back.x * back.x + back.z * back.z);
    return det::atan2(static_cast<float>(-back.y), static_cast<float>(across));
}

float roll_of(const glm::dmat4& world_from_node) {
    const glm::dvec3 back = glm::normalize(glm::dvec3(world_from_node[2]));
    const det::SinCos yaw = det::sin_cos(yaw_of(world_from_node));
    const glm::dvec3 level_right(yaw.cos, 0.0, -yaw.sin);
    const glm::dvec3 level_up = glm::cross(back, level_right);
    const glm::dvec3 right(world_from_node[0]);
    const float roll = det::atan2(static_cast<float>(glm::dot(right, level_up)),
                                  static_cast<float>(glm::dot(right, level_right)));
    constexpr float kLevel = 1.0e-4f;  // what exporters' rounding leaves of a level one
    return std::abs(roll) > kLevel ? roll : 0.0f;
}

glm::mat4x3 to_affine(const glm::dmat4& matrix) {
    return glm::mat4x3(glm::mat4(matrix));
}

glm::dmat4 from_affine(const glm::mat4x3& matrix) {
    return glm::dmat4(glm::mat4(matrix));
}

}  // namespace gh::load
