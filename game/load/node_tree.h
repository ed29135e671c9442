// load/node_tree.h - the nodes of a file's scene: who hangs on whom, and where each one stands.
//
// Frames    world_from_node is composed in double precision from the file's numbers. A place that stands far from the
//           file's own origin, as surveyed ones do, is brought near: at 1000 km floats are 6 cm apart, and pictures of
//           it would be off by a hundredth. Where half of its meshes stand more than 256 m off, the world counts from
//           their middle, in whole metres.
// Bad input a node with two parents or among its own ancestors, a hierarchy too deep, a transform that is not
//           finite or out of range: a sentence.
#pragma once

#include "base/result.h"
#include "world/level.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <tiny_gltf.h>

#include <cstdint>
#include <string>
#include <vector>

namespace gh::load {

struct NodeTree {
    std::vector<std::uint32_t> order;   // the scene's nodes, parents before children, as the file lists them
    std::vector<std::uint32_t> parent;  // of every node; kNoIndex at roots
    std::vector<glm::dmat4> world_from_node;
    glm::dvec3 origin{0.0};  // of the world, in the file
};

[[nodiscard]] Result<NodeTree> read_nodes(const tinygltf::Model& model);

// parent_from_node, from the node's matrix or its translation, rotation and scale. Not checked.
[[nodiscard]] glm::dmat4 local_matrix(const tinygltf::Node& node);

// "node 'Door'" or "node number 7".
[[nodiscard]] std::string node_name(const tinygltf::Model& model, std::uint32_t node);

// Where a node stands and how it is turned, without its scale (a mirrored one is turned back on x).
struct Pose {
    glm::dvec3 position{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};

    [[nodiscard]] glm::dmat4 matrix() const;
};
[[nodiscard]] Pose pose_of(const glm::dmat4& world_from_node);

// The direction of a node's own -Z as a heading: 0 faces world -z, positive turns left. Its pitch, up positive; and how
// far it leans to its left, exactly 0 if by no more than exporters' rounding.
[[nodiscard]] float yaw_of(const glm::dmat4& world_from_node);
[[nodiscard]] float pitch_of(const glm::dmat4& world_from_node);
[[nodiscard]] float roll_of(const glm::dmat4& world_from_node);

[[nodiscard]] glm::mat4x3 to_affine(const glm::dmat4& matrix);
[[nodiscard]] glm::dmat4 from_affine(const glm::mat4x3& matrix);

}  // namespace gh::load
