#include "collapse.h"

#include "data.h"

#include <tbb/parallel_for.h>

#include <limits>
#include <memory>

namespace rc {

namespace {

// A subtree with fewer refs is one thread's work.
constexpr std::uint32_t kParallelRefs = 4096;

// Follows a path down the binary tree whose first leaf stands in for lanes that are empty.
std::uint32_t first_leaf(const BinaryNode* binary) {
    std::uint32_t at = 0;
    while (!binary[at].is_leaf()) at = binary[at].first;
    return at;
}

// `Leaves` says how a leaf is named, what its lane's word is, and how a node's word comes from its lanes' and the
// number of nodes below it. Twice over the tree: counting, so that every node knows its place, and writing.
template <class Leaves>
class Collapse {
  public:
    Collapse(const BinaryTree& tree, const Leaves& leaves)
        : binary_(tree.nodes.get()),
          leaves_(leaves),
          harmless_leaf_(leaves.code(binary_[first_leaf(binary_)])),
          sizes_(std::make_unique_for_overwrite<std::uint32_t[]>(tree.size)) {}

    WideTree run() {
        WideTree tree;
        if (binary_[0].is_leaf()) {
            tree.root = leaves_.code(binary_[0]);
            return tree;
        }
        tree.nodes.resize(count(0));
        nodes_ = tree.nodes.data();
        write(0, 0);
        tree.root = 0;
        return tree;
    }

  private:
    template <class Body>
    static void for_lanes(bool in_parallel, int n, const Body& body) {
        if (in_parallel) {
            tbb::parallel_for(0, n, body);
        } else {
            for (int i = 0; i < n; ++i) body(i);
        }
    }

    // Wide nodes of the subtree opened at `at`.
    std::uint32_t count(std::uint32_t at) {
        std::uint32_t lanes[kernel::kWidth];
        const int n = gather(at, lanes);
        for_lanes(binary_[at].size() >= kParallelRefs, n, [&](int i) {
            if (!binary_[lanes[i]].is_leaf()) (void)count(lanes[i]);
        });
        std::uint32_t size = 1;
        for (int i = 0; i < n; ++i)
            if (!binary_[lanes[i]].is_leaf()) size += sizes_[lanes[i]];
        return sizes_[at] = size;
    }

    // The word of the node that is written at `index`.
    std::uint32_t write(std::uint32_t at, std::uint32_t index) {
        std::uint32_t lanes[kernel::kWidth];
        const int n = gather(at, lanes);
        kernel::WideNode& node = nodes_[index];
        for (int i = n; i < kernel::kWidth; ++i) clear_lane(node, i, harmless_leaf_);
        std::uint32_t next = index + 1;
        for (int i = 0; i < n; ++i) {
            const BinaryNode& child = binary_[lanes[i]];
            for (int a = 0; a < 3; ++a) {
                node.bounds[2 * a][i] = child.min[a];
                node.bounds[2 * a + 1][i] = child.max[a];
            }
            node.child[i] = child.is_leaf() ? leaves_.code(child) : next;
            if (!child.is_leaf()) next += sizes_[lanes[i]];
        }
        for_lanes(binary_[at].size() >= kParallelRefs, n, [&](int i) {
            const BinaryNode& child = binary_[lanes[i]];
            node.layers[i] = child.is_leaf() ? leaves_.word(child) : write(lanes[i], node.child[i]);
        });
        std::uint32_t words = 0;
        for (int i = 0; i < n; ++i) words |= node.layers[i];
        return leaves_.word_of_node(words, sizes_[at]);
    }

    // Opens the largest child again and again until eight stand side by side.
    int gather(std::uint32_t at, std::uint32_t lanes[kernel::kWidth]) const {
        float areas[kernel::kWidth];  // below zero for leaves
        const auto place = [&](int i, std::uint32_t child) {
            lanes[i] = child;
            areas[i] = binary_[child].is_leaf() ? -1.0f : half_area(binary_[child]);
        };
        place(0, binary_[at].first);
        place(1, binary_[at].first + 1);
        int n = 2;
        while (n < kernel::kWidth) {
            int largest = 0;
            for (int i = 1; i < n; ++i)
                if (areas[i] > areas[largest]) largest = i;
            if (areas[largest] < 0.0f) break;
            const std::uint32_t opened = binary_[lanes[largest]].first;
            place(largest, opened);
            place(n++, opened + 1);
        }
        return n;
    }

    const BinaryNode* binary_;
    const Leaves& leaves_;
    std::uint32_t harmless_leaf_;
    std::unique_ptr<std::uint32_t[]> sizes_;
    kernel::WideNode* nodes_ = nullptr;
};

struct BlasLeaves {
    std::uint32_t code(const BinaryNode& leaf) const { return leaf_code(leaf.first, leaf.count); }
    std::uint32_t word(const BinaryNode&) const { return 1; }
    std::uint32_t word_of_node(std::uint32_t, std::uint32_t nodes) const { return nodes; }
};

struct TlasLeaves {
    const std::uint32_t* items;
    const std::vector<std::uint32_t>& layers;

    std::uint32_t code(const BinaryNode& leaf) const { return kernel::kLeafBit | items[leaf.first]; }
    std::uint32_t word(const BinaryNode& leaf) const { return layers[items[leaf.first]]; }
    std::uint32_t word_of_node(std::uint32_t words, std::uint32_t) const { return words; }
};

}  // namespace

void clear_lane(kernel::WideNode& node, int lane, std::uint32_t harmless_leaf) {
    for (int a = 0; a < 3; ++a) {
        node.bounds[2 * a][lane] = std::numeric_limits<float>::infinity();
        node.bounds[2 * a + 1][lane] = -std::numeric_limits<float>::infinity();
    }
    node.child[lane] = harmless_leaf;
    node.layers[lane] = 0;
}

WideTree collapse_blas(const BinaryTree& tree) {
    const BlasLeaves leaves;
    return Collapse(tree, leaves).run();
}

WideTree collapse_tlas(const BinaryTree& tree, const std::vector<std::uint32_t>& layers) {
    const TlasLeaves leaves{tree.items.data(), layers};
    return Collapse(tree, leaves).run();
}

}  // namespace rc
