#include "fill_leaves.h"

#include "parallel.h"

#include <algorithm>
#include <atomic>
#include <bit>

namespace rc {

namespace {

constexpr std::size_t kNodesAtOnce = 256;

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
        if (blas.can_refit) blas.triangles.set(leaf.first + lane, triangle);
        block[9 * leaf.count + lane] = std::bit_cast<float>(primitive);
        note_leaf(blas.leaf_of_primitive[primitive], code);
    }
}

}  // namespace

void fill_leaves(Blas::Data& blas, std::span<const std::uint32_t> items, const MeshView& mesh) {
    blas.leaves.resize(items.size() * kernel::kWordsPerTriangle + kernel::kLeafPadding);
    if (blas.can_refit) blas.triangles.resize(items.size(), mesh.triangles);
    std::fill(blas.leaves.end() - kernel::kLeafPadding, blas.leaves.end(), 0.0f);
    if (blas.root == kernel::kEmptyTree) return;
    if (blas.root & kernel::kLeafBit) return fill_leaf(blas, items, mesh, blas.root);
    const BlockedRange all(0, blas.nodes.size(), kNodesAtOnce);
    for_in_parallel(all, [&](const auto& some) {
        for (std::size_t i = some.begin(); i < some.end(); ++i) {
            const kernel::WideNode& node = blas.nodes[i];
            for (int lane = 0; lane < kernel::kWidth; ++lane)
                if (node.layers[lane] != 0 && (node.child[lane] & kernel::kLeafBit) != 0)
                    fill_leaf(blas, items, mesh, node.child[lane]);
        }
    });
}

}  // namespace rc
