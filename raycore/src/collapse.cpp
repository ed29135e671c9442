#include "collapse.h"

#include "data.h"
#include "parallel.h"

#include <limits>
#include <memory>

namespace rc {

namespace {

// A subtree with fewer refs is one thread's work.
constexpr std::uint32_t kParallelRefs = 4096;
// In shares of the root's surface: a node is never for nothing, so where all surfaces vanish few nodes are best.
constexpr float kSurfaceOfNode = 1e-7f;

// Follows a path down the binary tree whose first leaf stands in for lanes that are empty.
std::uint32_t first_leaf(const BinaryNode* binary) {
    std::uint32_t at = 0;
    while (!binary[at].is_leaf()) at = binary[at].first;
    return at;
}

// What a binary subtree costs when it may take up to i lanes of the node above it, for i = 1 ... 8: the surfaces of all
// wide nodes in it, in shares of the root's, and how many they are.
struct Costs {
    float area[kernel::kWidth + 1] = {};
    std::uint32_t nodes[kernel::kWidth + 1] = {};
};

// How many of i lanes go to the left child of a binary node; 0 where one lane less is as good. lefts[1] is how many of
// all eight go left when the node is made a wide one itself.
struct Plan {
    std::uint8_t lefts[kernel::kWidth + 1];
};

// `Leaves` says how a leaf is named, what its lane's word is, and how a node's word comes from its lanes' and the
// number of nodes below it. Twice over the tree: upwards to find the cheapest set of wide nodes, whose number tells
// every node its place, and downwards to write them.
template <class Leaves>
class Collapse {
  public:
    Collapse(const BinaryTree& tree, const Leaves& leaves)
        : binary_(tree.nodes.get()),
          leaves_(leaves),
          harmless_leaf_(leaves.code(binary_[first_leaf(binary_)])),
          plans_(std::make_unique_for_overwrite<Plan[]>(tree.size)),
          sizes_(std::make_unique_for_overwrite<std::uint32_t[]>(tree.size)) {}

    WideTree run() {
        WideTree tree;
        if (binary_[0].is_leaf()) {
            tree.root = leaves_.code(binary_[0]);
            return tree;
        }
        const float area = half_area(binary_[0]), per_area = 1.0f / area;
        per_root_area_ = area > 0.0f && per_area < std::numeric_limits<float>::infinity() ? per_area : 0.0f;
        tree.nodes.resize(plan(0).nodes[1]);
        nodes_ = tree.nodes.data();
        write(0, 0);
        tree.root = 0;
        return tree;
    }

  private:
    template <class Body>
    static void for_lanes(bool in_parallel, int n, const Body& body) {
        if (in_parallel) {
            for_in_parallel(n, body);
        } else {
            for (int i = 0; i < n; ++i) body(i);
        }
    }

    // The least surface of wide nodes, for any number of lanes: dynamic programming (Ylitie, Karras, Laine 2017).
    Costs plan(std::uint32_t at) {
        const BinaryNode& node = binary_[at];
        if (node.is_leaf()) return {};
        Costs sides[2];
        for_lanes(node.size() >= kParallelRefs, 2,
                  [&](int i) { sides[i] = plan(node.first + static_cast<std::uint32_t>(i)); });
        const auto& [left, right] = sides;
        Costs costs;
        costs.area[1] = std::numeric_limits<float>::infinity();
        for (int i = 2; i <= kernel::kWidth; ++i) {
            int best = 0;
            float area = costs.area[i - 1];
            for (int k = 1; k < i; ++k) {
                const float sum = left.area[k] + right.area[i - k];
                if (sum < area) {
                    area = sum;
                    best = k;
                }
            }
            plans_[at].lefts[i] = static_cast<std::uint8_t>(best);
            costs.area[i] = area;
            costs.nodes[i] = best == 0 ? costs.nodes[i - 1] : left.nodes[best] + right.nodes[i - best];
        }
        int lanes = kernel::kWidth;  // of the node this becomes when it gets one lane
        while (lanes > 2 && plans_[at].lefts[lanes] == 0) --lanes;
        plans_[at].lefts[1] = plans_[at].lefts[lanes];
        costs.area[1] = costs.area[kernel::kWidth] + half_area(node) * per_root_area_ + kSurfaceOfNode;
        costs.nodes[1] = sizes_[at] = 1 + costs.nodes[kernel::kWidth];
        // One lane may do better than several: then several make no use of the others.
        for (int i = 2; i <= kernel::kWidth; ++i) {
            if (costs.area[i] < costs.area[1]) break;
            plans_[at].lefts[i] = 0;
            costs.area[i] = costs.area[1];
            costs.nodes[i] = costs.nodes[1];
        }
        return costs;
    }

    // The word of the node that is written at `index`.
    std::uint32_t write(std::uint32_t at, std::uint32_t index) {
        std::uint32_t lanes[kernel::kWidth];
        int n = 0;
        open(at, kernel::kWidth, plans_[at].lefts[1], lanes, n);
        arrange(lanes, n);
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

    // The likeliest to end an any-hit walk soon into the highest lane.
    void arrange(std::uint32_t lanes[kernel::kWidth], int n) const {
        float worth[kernel::kWidth];
        for (int i = 0; i < n; ++i) {
            const std::uint32_t item = lanes[i];
            const float worth_of_item = worth_of(binary_[item]);
            int at = i;
            for (; at > 0 && worth[at - 1] > worth_of_item; --at) {
                worth[at] = worth[at - 1];
                lanes[at] = lanes[at - 1];
            }
            worth[at] = worth_of_item;
            lanes[at] = item;
        }
    }
    // Surface a thing below: what is likely to be met, and soon told.
    static float worth_of(const BinaryNode& node) { return half_area(node) / float(node.size()); }

    // Gives the children of `at` the lanes that were planned for them.
    void open(std::uint32_t at, int share, int lefts, std::uint32_t lanes[kernel::kWidth], int& n) const {
        settle(binary_[at].first, lefts, lanes, n);
        settle(binary_[at].first + 1, share - lefts, lanes, n);
    }
    void settle(std::uint32_t at, int share, std::uint32_t lanes[kernel::kWidth], int& n) const {
        if (binary_[at].is_leaf()) {
            lanes[n++] = at;
            return;
        }
        while (share > 1 && plans_[at].lefts[share] == 0) --share;
        if (share == 1) {
            lanes[n++] = at;
        } else {
            open(at, share, plans_[at].lefts[share], lanes, n);
        }
    }

    const BinaryNode* binary_;
    const Leaves& leaves_;
    std::uint32_t harmless_leaf_;
    float per_root_area_ = 0.0f;
    std::unique_ptr<Plan[]> plans_;
    std::unique_ptr<std::uint32_t[]> sizes_;  // wide nodes below, and itself, when opened
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
