// From triangles to a tree the kernels walk: refs, a binary tree over them, eight wide, blocks filled.
#include "binned_builder.h"
#include "collapse.h"
#include "collect_refs.h"
#include "contract.h"
#include "fit.h"
#include "morton_builder.h"
#include "spatial_builder.h"

#include "raycore/blas.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <utility>

namespace rc {

namespace {

constexpr std::size_t kNodesAtOnce = 256;
constexpr float kInf = std::numeric_limits<float>::infinity();

// The lowest of the leaves that hold a primitive, whichever is filled first.
void note_leaf(std::uint32_t& leaf_of_primitive, std::uint32_t leaf) {
    std::atomic_ref<std::uint32_t> lowest(leaf_of_primitive);
    std::uint32_t known = lowest.load(std::memory_order_relaxed);
    while (leaf < known && !lowest.compare_exchange_weak(known, leaf, std::memory_order_relaxed)) {
    }
}

// Gives a leaf's block its triangles, and every primitive in it its leaf.
void fill_leaf(Blas::Data& blas, std::span<const std::uint32_t> items, const MeshView& mesh,
               std::uint32_t code) {
    const LeafRange leaf = leaf_range(code);
    float* block = blas.leaves.data() + std::size_t{leaf.first} * kernel::kWordsPerTriangle;
    for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
        const std::uint32_t primitive = items[leaf.first + lane];
        const glm::uvec3& triangle = mesh.triangles[primitive];
        for (std::uint32_t c = 0; c < 3; ++c) {
            const glm::vec3& corner = mesh.positions[triangle[c]];
            for (std::uint32_t a = 0; a < 3; ++a) block[(3 * c + a) * leaf.count + lane] = corner[a];
        }
        block[9 * leaf.count + lane] = std::bit_cast<float>(primitive);
        note_leaf(blas.leaf_of_primitive[primitive], code);
    }
}

void fill_leaves(Blas::Data& blas, std::span<const std::uint32_t> items, const MeshView& mesh) {
    blas.leaves.resize(items.size() * kernel::kWordsPerTriangle + kernel::kLeafPadding);
    std::fill(blas.leaves.end() - kernel::kLeafPadding, blas.leaves.end(), 0.0f);
    if (blas.root & kernel::kLeafBit) return fill_leaf(blas, items, mesh, blas.root);
    const tbb::blocked_range<std::size_t> all(0, blas.nodes.size(), kNodesAtOnce);
    tbb::parallel_for(all, [&](const auto& some) {
        for (std::size_t i = some.begin(); i < some.end(); ++i) {
            const kernel::WideNode& node = blas.nodes[i];
            for (int lane = 0; lane < kernel::kWidth; ++lane)
                if (node.layers[lane] != 0 && (node.child[lane] & kernel::kLeafBit) != 0)
                    fill_leaf(blas, items, mesh, node.child[lane]);
        }
    });
}

Box box_of(const BinaryNode& node) {
    return {{node.min[0], node.min[1], node.min[2]}, {node.max[0], node.max[1], node.max[2]}};
}

BinaryTree binary_tree_of(Unfilled<BuildRef> refs, const MeshView& mesh, BuildQuality quality) {
    switch (quality) {
        case BuildQuality::Fast:
            return build_morton_tree(refs, SplitCosts{});
        case BuildQuality::Default:
            break;
        case BuildQuality::High:
            return build_spatial_tree(std::move(refs), mesh, SplitCosts{});
    }
    return build_binary_tree(refs, SplitCosts{});
}

void grow_tree(Blas::Data& blas, const MeshView& mesh, BuildQuality quality) {
    Unfilled<BuildRef> refs = collect_refs(mesh, blas.report);
    if (refs.empty()) return;
    const BinaryTree binary = binary_tree_of(std::move(refs), mesh, quality);
    WideTree wide = collapse_blas(binary);
    blas.nodes = std::move(wide.nodes);
    blas.root = wide.root;
    blas.bounds = box_of(binary.nodes[0]);
    fill_leaves(blas, binary.items, mesh);
}

}  // namespace

std::shared_ptr<Blas> build_blas(const MeshView& mesh, const BuildOptions& options) {
    auto data = std::make_unique<Blas::Data>();
    RC_EXPECTS(mesh.triangles.size() <= kMaxTriangles, "at most kMaxTriangles triangles in a mesh");
    const bool fits = mesh.triangles.size() <= kMaxTriangles;
    const MeshView view{mesh.positions, fits ? mesh.triangles : mesh.triangles.first(0)};

    data->vertex_count = view.positions.size();
    data->triangles.assign(view.triangles.begin(), view.triangles.end());
    data->leaf_of_primitive.assign(view.triangles.size(), kNone);
    data->bounds = {glm::vec3(kInf), glm::vec3(-kInf)};
    grow_tree(*data, view, options.quality);
    data->cost = data->cost_when_built = cost_of(*data);
    return std::make_shared<Blas>(std::move(data));
}

}  // namespace rc
