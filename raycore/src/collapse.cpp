#include "collapse.h"

#include "contract.h"
#include "data.h"
#include "dispatch.h"
#include "parallel.h"

#include "raycore/ray.h"

#include <algorithm>
#include <limits>
#include <span>

namespace rc {

namespace {

// A subtree with fewer refs is one thread's work.
constexpr std::uint32_t kParallelRefs = 4096;
// In shares of the root's surface: a node is never for nothing, so where all surfaces vanish few nodes are best.
constexpr float kSurfaceOfNode = 1e-7f;
// What a leaf costs, and each triangle in it, in steps at a wide node. Builders cut finer than that, since they do not know
// yet where a node's lanes would be free for the pieces.
constexpr float kLeaf = 0.57f;
constexpr float kItem = 0.17f;

using kernel::LaneCosts;
constexpr LaneCosts kOneLane{
    {0, kInfinity, kInfinity, kInfinity, kInfinity, kInfinity, kInfinity, kInfinity}, {}, 1};

// How many of i + 1 lanes go to the left child of a binary node; 0 where one lane less is as good. When the node is made a
// wide one itself, it uses `lanes` of its own, and lefts[0] of them go left.
struct Plan {
    bool is_leaf;  // all of it in one
    std::uint8_t lanes;
    std::uint8_t lefts[kernel::kWidth];
};

// What fills lanes that nobody needs: met by nothing, and sorted behind everything.
constexpr BinaryNode kNowhere{{kInfinity, kInfinity, kInfinity}, 0, {-kInfinity, -kInfinity, -kInfinity}, 1};

// `Leaves` says what a leaf costs, which items may be put together in one, how it is named, what its lane's word is, and
// how a node's word comes from its lanes' and the number of nodes below it. Twice over the tree: upwards to find the cheapest
// set of wide nodes and leaves, whose number tells every node its place, and downwards to write them.
template <class Leaves>
class Collapse {
  public:
    Collapse(const BinaryTree& tree, const Leaves& leaves)
        : binary_(tree.nodes.data()),
          leaves_(leaves),
          kernels_(active_build_kernels()),
          plans_(tree.size),
          sizes_(tree.size) {}

    WideTree run() {
        WideTree tree;
        if (binary_[0].is_leaf()) {
            tree.root = leaves_.code(binary_[0]);
            return tree;
        }
        const float area = half_area(binary_[0]), per_area = 1.0f / area;
        per_root_area_ = area > 0.0f && per_area < std::numeric_limits<float>::infinity() ? per_area : 0.0f;
        LaneCosts costs;
        make_plan(0, costs);
        const std::uint32_t count = costs.nodes[0];
        if (plans_[0].is_leaf) {
            tree.root = leaves_.code(as_leaf(0));
            return tree;
        }
        harmless_leaf_ = leaves_.code(as_leaf(some_leaf()));
        tree.nodes.resize(count);
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

    // Of the root's; nothing where that vanishes or is none.
    [[nodiscard]] float share_of_surface(const BinaryNode& node) const {
        return per_root_area_ > 0.0f ? half_area(node) * per_root_area_ : 0.0f;
    }

    // The least surface of wide nodes and leaves, for any number of lanes: dynamic programming (Ylitie, Karras, Laine 2017).
    void make_plan(std::uint32_t at, LaneCosts& costs) {
        const BinaryNode& node = binary_[at];
        const float area_here = share_of_surface(node), as_leaf = area_here * leaves_.cost(node.size());
        Plan& plan = plans_[at];
        if (node.is_leaf()) {
            plan.is_leaf = true;
            costs = kOneLane;
            costs.area[0] = as_leaf;
            return;
        }
        LaneCosts sides[2];
        for_lanes(node.size() >= kParallelRefs, 2,
                  [&](int i) { make_plan(node.first + static_cast<std::uint32_t>(i), sides[i]); });
        kernels_.share_lanes(sides[0], sides[1], costs, plan.lefts);
        // A node of its own uses no more lanes than planned, even where the right child would have use for one: next to a large
        // left child what it saves may be rounded away.
        int last = costs.lanes - 1;
        while (last > 1 && plan.lefts[last] == 0) --last;
        plan.lanes = static_cast<std::uint8_t>(last + 1);
        plan.lefts[0] = plan.lefts[last];
        costs.area[0] = costs.area[last] + area_here + kSurfaceOfNode;
        costs.nodes[0] = sizes_[at] = 1 + costs.nodes[last];
        plan.is_leaf =
            node.size() <= Leaves::kMost && as_leaf <= costs.area[0] && leaves_.fits(this->as_leaf(at));
        if (plan.is_leaf) {
            costs.area[0] = as_leaf;
            costs.nodes[0] = sizes_[at] = 0;
        }
        // One lane may do better than several: then several make no use of the others.
        for (int i = 1; i < costs.lanes && !(costs.area[i] < costs.area[0]); ++i) {
            plan.lefts[i] = 0;
            costs.area[i] = costs.area[0];
            costs.nodes[i] = costs.nodes[0];
        }
    }

    // One that will be written.
    [[nodiscard]] std::uint32_t some_leaf() const {
        std::uint32_t at = 0;
        while (!plans_[at].is_leaf) at = index_of(lanes_of(at).nodes[0]);
        return at;
    }

    // All items below a node, which lie side by side.
    [[nodiscard]] BinaryNode as_leaf(std::uint32_t at) const {
        BinaryNode leaf = binary_[at];
        leaf.count = leaf.size();
        while (!binary_[at].is_leaf()) at = binary_[at].first;
        leaf.first = binary_[at].first;
        return leaf;
    }

    // The word of the node that is written at `index`.
    std::uint32_t write(std::uint32_t at, std::uint32_t index) {
        Lanes lanes = lanes_of(at);
        std::fill(lanes.nodes + lanes.count, lanes.nodes + kernel::kWidth, &kNowhere);
        kernel::WideNode& node = nodes_[index];
        // The likeliest to end an any-hit walk soon - what is likely to be met, and soon told - into the highest lane.
        kernels_.fill_boxes(lanes.nodes, node);
        std::uint32_t next = index + 1;
        for (int i = 0; i < kernel::kWidth; ++i) {
            node.layers[i] = 0;
            node.child[i] = harmless_leaf_;
            if (i >= lanes.count) continue;
            const std::uint32_t child = index_of(lanes.nodes[i]);
            const bool is_leaf = plans_[child].is_leaf;
            node.child[i] = is_leaf ? leaves_.code(as_leaf(child)) : next;
            if (!is_leaf) next += sizes_[child];
        }
        RC_EXPECTS(next == index + sizes_[at], "as many nodes to be written as were planned");
        for_lanes(binary_[at].size() >= kParallelRefs, lanes.count, [&](int i) {
            const std::uint32_t child = index_of(lanes.nodes[i]);
            const bool is_leaf = plans_[child].is_leaf;
            node.layers[i] = is_leaf ? leaves_.word(as_leaf(child)) : write(child, node.child[i]);
        });
        std::uint32_t words = 0;
        for (const std::uint32_t word : node.layers) words |= word;
        return leaves_.word_of_node(words, sizes_[at]);
    }

    struct Lanes {
        const BinaryNode* nodes[kernel::kWidth];
        int count = 0;
    };
    [[nodiscard]] std::uint32_t index_of(const BinaryNode* node) const {
        return static_cast<std::uint32_t>(node - binary_);
    }
    [[nodiscard]] Lanes lanes_of(std::uint32_t at) const {
        Lanes lanes;
        open(at, plans_[at].lanes, plans_[at].lefts[0], lanes);
        return lanes;
    }
    // Gives the children of `at` the lanes that were planned for them.
    void open(std::uint32_t at, int share, int lefts, Lanes& lanes) const {
        settle(binary_[at].first, lefts, lanes);
        settle(binary_[at].first + 1, share - lefts, lanes);
    }
    void settle(std::uint32_t at, int share, Lanes& lanes) const {
        const bool is_leaf = binary_[at].is_leaf();
        while (!is_leaf && share > 1 && plans_[at].lefts[share - 1] == 0) --share;
        if (is_leaf || share == 1) {
            lanes.nodes[lanes.count++] = &binary_[at];
        } else {
            open(at, share, plans_[at].lefts[share - 1], lanes);
        }
    }

    const BinaryNode* binary_;
    const Leaves& leaves_;
    const kernel::BuildKernels& kernels_;
    std::uint32_t harmless_leaf_ = 0;  // stands in for lanes that are empty
    float per_root_area_ = 0.0f;
    Unfilled<Plan> plans_;
    Unfilled<std::uint32_t> sizes_;  // wide nodes below, and itself, when opened
    kernel::WideNode* nodes_ = nullptr;
};

struct BlasLeaves {
    static constexpr std::uint32_t kMost = kernel::kWidth;

    std::span<const std::uint32_t> items;
    kernel::MeshArrays mesh;
    bool by_vertex;  // corners are one only where refits could not part them
    const kernel::BuildKernels& kernels;

    static float cost(std::uint32_t items) { return kLeaf + kItem * float(items); }
    // By vertices first, which is asked sooner than places and mostly enough.
    bool fits(const BinaryNode& leaf) const {
        return leaf.count <= kAlwaysFit || fits(leaf, true) || (!by_vertex && fits(leaf, false));
    }
    bool fits(const BinaryNode& leaf, bool of_vertices) const {
        kernel::SharedCorners shared;
        kernels.share_corners(
            {items.data(), static_cast<std::uint32_t>(items.size()), leaf.first, leaf.count}, mesh,
            of_vertices, shared);
        return shared.count <= kernel::kMaxCorners;
    }
    std::uint32_t code(const BinaryNode& leaf) const { return range_code({leaf.first, leaf.count}); }
    std::uint32_t word(const BinaryNode&) const { return 1; }
    std::uint32_t word_of_node(std::uint32_t, std::uint32_t nodes) const { return nodes; }
};

struct TlasLeaves {
    static constexpr std::uint32_t kMost = 0;
    const std::uint32_t* items;
    const std::vector<std::uint32_t>& layers;

    static float cost(std::uint32_t) { return 0.0f; }
    static bool fits(const BinaryNode&) { return true; }
    std::uint32_t code(const BinaryNode& leaf) const { return kernel::kLeafBit | items[leaf.first]; }
    std::uint32_t word(const BinaryNode& leaf) const { return layers[items[leaf.first]]; }
    std::uint32_t word_of_node(std::uint32_t words, std::uint32_t) const { return words; }
};

}  // namespace

WideTree collapse_blas(const BinaryTree& tree, const MeshView& mesh, bool can_refit) {
    const BlasLeaves leaves{tree.items, mesh_arrays_of(mesh), can_refit, active_build_kernels()};
    return Collapse(tree, leaves).run();
}

WideTree collapse_tlas(const BinaryTree& tree, const std::vector<std::uint32_t>& layers) {
    const TlasLeaves leaves{tree.items.data(), layers};
    return Collapse(tree, leaves).run();
}

}  // namespace rc
