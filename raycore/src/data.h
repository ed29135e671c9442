// data.h - what a Blas and a Scene keep. Private to raycore; layouts the kernels read are in kernel_abi.h.
#pragma once

#include "kernels/kernel_abi.h"
#include "leaf.h"
#include "unfilled.h"

#include "raycore/blas.h"
#include "raycore/scene.h"

#include <cstdint>
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

    Unfilled<kernel::WideNode> nodes;  // a parent stands before its children
    Unfilled<float> leaves;            // blocks in the order of their nodes, then kLeafPadding words
    std::uint32_t root = kernel::kEmptyTree;
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

}  // namespace rc
