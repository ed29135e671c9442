#include "collapse.h"

#include "data.h"

#include <limits>

namespace rc {

namespace {

// Follows a path down the binary tree whose first leaf stands in for lanes that are empty.
std::uint32_t first_leaf(const BinaryNode* binary) {
    std::uint32_t at = 0;
    while (!binary[at].is_leaf()) at = binary[at].first;
    return at;
}

// `Leaves` says how a leaf is named, what its lane's word is, and how a node's word comes from its lanes' and the
// number of nodes below it.
template <class Leaves>
class Collapse {
  public:
    Collapse(const BinaryNode* binary, const Leaves& leaves)
        : binary_(binary), leaves_(leaves), harmless_leaf_(leaves.code(binary[first_leaf(binary)])) {}

    WideTree run() {
        tree_.root = binary_[0].is_leaf() ? leaves_.code(binary_[0]) : open(0).item;
        tree_.nodes.shrink_to_fit();
        return std::move(tree_);
    }

  private:
    struct Child {
        std::uint32_t item;
        std::uint32_t word;
    };

    Child open(std::uint32_t at) {
        std::uint32_t lanes[kernel::kWidth];
        const int n = gather(at, lanes);
        const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.emplace_back();
        std::uint32_t words = 0;
        for (int i = 0; i < kernel::kWidth; ++i) {
            if (i >= n) {
                clear_lane(tree_.nodes[index], i, harmless_leaf_);
                continue;
            }
            const BinaryNode& child = binary_[lanes[i]];
            const Child below =
                child.is_leaf() ? Child{leaves_.code(child), leaves_.word(child)} : open(lanes[i]);
            kernel::WideNode& node = tree_.nodes[index];  // only now: opening a child may move the nodes
            for (int a = 0; a < 3; ++a) {
                node.bounds[2 * a][i] = child.min[a];
                node.bounds[2 * a + 1][i] = child.max[a];
            }
            node.child[i] = below.item;
            node.layers[i] = below.word;
            words |= below.word;
        }
        return {index, leaves_.word_of_node(words, static_cast<std::uint32_t>(tree_.nodes.size()) - index)};
    }

    // Opens the largest child again and again until eight stand side by side.
    int gather(std::uint32_t at, std::uint32_t lanes[kernel::kWidth]) const {
        int n = 2;
        lanes[0] = binary_[at].first;
        lanes[1] = lanes[0] + 1;
        while (n < kernel::kWidth) {
            int largest = -1;
            for (int i = 0; i < n; ++i) {
                if (binary_[lanes[i]].is_leaf()) continue;
                if (largest < 0 || half_area(binary_[lanes[i]]) > half_area(binary_[lanes[largest]]))
                    largest = i;
            }
            if (largest < 0) break;
            lanes[largest] = binary_[lanes[largest]].first;
            lanes[n++] = lanes[largest] + 1;
        }
        return n;
    }

    const BinaryNode* binary_;
    const Leaves& leaves_;
    std::uint32_t harmless_leaf_;
    WideTree tree_;
};

struct BlasLeaves {
    std::uint32_t code(const BinaryNode& leaf) const { return leaf_code(leaf.first, leaf.count); }
    std::uint32_t word(const BinaryNode&) const { return 1; }
    std::uint32_t word_of_node(std::uint32_t, std::uint32_t nodes) const { return nodes; }
};

struct TlasLeaves {
    const BuildRef* refs;
    const std::vector<std::uint32_t>& layers;

    std::uint32_t code(const BinaryNode& leaf) const { return kernel::kLeafBit | refs[leaf.first].item; }
    std::uint32_t word(const BinaryNode& leaf) const { return layers[refs[leaf.first].item]; }
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

WideTree collapse_blas(const BinaryNode* binary) {
    const BlasLeaves leaves;
    return Collapse(binary, leaves).run();
}

WideTree collapse_tlas(const BinaryNode* binary, const BuildRef* refs,
                       const std::vector<std::uint32_t>& layers) {
    const TlasLeaves leaves{refs, layers};
    return Collapse(binary, leaves).run();
}

}  // namespace rc
