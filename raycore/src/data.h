// data.h - what a Blas and a Scene keep. Private to raycore; layouts the kernels read are in kernel_abi.h.
#pragma once

#include "kernels/kernel_abi.h"
#include "leaf_triangles.h"
#include "unfilled.h"

#include "raycore/blas.h"
#include "raycore/scene.h"

#include <glm/vec3.hpp>

#include <bit>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

namespace rc {

struct Blas::Data {
    kernel::BlasView view() const {
        kernel::BlasView v{nodes.data(), leaves.data(), root, {}, {}};
        for (std::size_t a = 0; a < 3; ++a) {
            v.min[a] = bounds.min[a];
            v.max[a] = bounds.max[a];
        }
        return v;
    }

    Unfilled<kernel::WideNode> nodes;     // a parent stands before its children
    Unfilled<float> leaves;               // triangle blocks, then kLeafPadding words
    std::uint32_t root = kernel::kEmptyTree;
    LeafTriangles triangles;  // for refits; empty when there will be none
    std::vector<std::uint32_t> leaf_of_primitive;  // the leaf that holds it, kNone when dropped
    std::size_t vertex_count = 0;
    bool can_refit = true;
    MeshReport report;
    Box bounds;
    float cost_when_built = 0.0f;
    float cost = 0.0f;
};

struct Scene::Data {
    std::vector<Instance> instances;
    Unfilled<kernel::InstanceView> views;  // slot i is instance i
    Unfilled<kernel::WideNode> nodes;
    std::size_t dropped = 0;
    Box bounds;
    kernel::SceneView view;
};

// A leaf taken apart.
struct LeafRange {
    std::uint32_t first;
    std::uint32_t count;
};
inline LeafRange leaf_range(std::uint32_t leaf) {
    return {leaf & kernel::kLeafFirstMask, ((leaf & ~kernel::kLeafBit) >> 28) + 1};
}
inline std::uint32_t leaf_code(std::uint32_t first, std::uint32_t count) {
    return kernel::kLeafBit | (count - 1) << 28 | first;
}

inline std::uint32_t primitive_in(const float* leaves, LeafRange leaf, std::uint32_t lane) {
    const float* block = leaves + std::size_t{leaf.first} * kernel::kWordsPerTriangle;
    return std::bit_cast<std::uint32_t>(block[9 * leaf.count + lane]);
}

inline glm::vec3 corner_in(const float* leaves, LeafRange leaf, std::uint32_t lane, std::uint32_t corner) {
    const float* row =
        leaves + std::size_t{leaf.first} * kernel::kWordsPerTriangle + 3 * corner * leaf.count + lane;
    return {row[0], row[leaf.count], row[2 * leaf.count]};
}

}  // namespace rc
