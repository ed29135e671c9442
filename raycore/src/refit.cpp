#include "contract.h"
#include "dispatch.h"
#include "fit.h"
#include "parallel.h"
#include "tree_math.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace rc {

namespace {

// A node with this many nodes below it is fitted by several threads.
constexpr std::uint32_t kParallelNodes = 256;
constexpr std::size_t kCostBlock = 1024;

float triangles_in(const Blas::Data& blas, std::uint32_t leaf) {
    return float(Leaf(blas.leaves.data(), leaf).size());
}

// 1 for a node, 1 for each triangle of a leaf, by half areas; unused lanes have none.
double cost_of_lanes(const Blas::Data& blas, const kernel::WideNode& node,
                     const float (&half_areas)[kernel::kWidth]) {
    double sum = 0.0;
    for (int lane = 0; lane < kernel::kWidth; ++lane) {
        const std::uint32_t child = node.child[lane];
        const float each = (child & kernel::kLeafBit) != 0 ? triangles_in(blas, child) : 1.0f;
        if (node.layers[lane] != 0) sum += double(half_areas[lane] * each);
    }
    return sum;
}

// `below` is the cost of all nodes but the root, which counts as one.
float relative_cost(double below, const Box& root) {
    if (!(root.min.x <= root.max.x)) return 1.0f;
    const glm::vec3 d = root.max - root.min;
    const double area = double((d.x * d.y + d.y * d.z) + d.z * d.x);
    return area > 0.0 ? float((below + area) / area) : 1.0f;
}

class Fitting {
  public:
    struct Fitted {
        GrowingBox bounds = build::kNoBox;  // of the triangles themselves
        GrowingBox box = build::kNoBox;     // with their slack
        double cost = 0.0;
    };

    Fitting(Blas::Data& blas, std::span<const glm::vec3> positions)
        : blas_(blas), positions_(&positions[0].x), kernels_(active_build_kernels()) {}

    Fitted fit_leaf(std::uint32_t code) const {
        Fitted fitted;
        kernels_.fit_block(blas_.leaves.data() + unit_of(code) * kernel::kWordsPerUnit, corners_of(code),
                           positions_, fitted.bounds, fitted.box);
        return fitted;
    }

    // A subtree's box and cost, its leaves and boxes fitted on the way up. Costs are added up along the tree: one sum
    // for any number of threads.
    Fitted fit_node(std::uint32_t index, std::uint32_t nodes_below) const {
        kernel::WideNode& node = blas_.nodes[index];
        Fitted lanes[kernel::kWidth];
        const auto fit_lane = [&](int lane) {
            if (node.layers[lane] == 0) return;
            const std::uint32_t child = node.child[lane];
            Fitted& below = lanes[lane];
            below = (child & kernel::kLeafBit) != 0 ? fit_leaf(child) : fit_node(child, node.layers[lane]);
            const Box box = box_of(below.box);
            for (std::size_t a = 0; a < 3; ++a) {
                node.bounds[2 * a][lane] = box.min[a];
                node.bounds[2 * a + 1][lane] = box.max[a];
            }
        };
        // Lanes are disjoint subtrees and each writes its own; near the leaves a task would cost more than it gains.
        if (nodes_below >= kParallelNodes) {
            for_in_parallel(kernel::kWidth, fit_lane);
        } else {
            for (int lane = 0; lane < kernel::kWidth; ++lane) fit_lane(lane);
        }
        Fitted fitted;
        float half_areas[kernel::kWidth];
        kernels_.measure_lanes(node, fitted.box, half_areas);
        fitted.cost = cost_of_lanes(blas_, node, half_areas);
        for (const Fitted& below : lanes) {
            build::grow(fitted.bounds, below.bounds);
            fitted.cost += below.cost;
        }
        return fitted;
    }

  private:
    Blas::Data& blas_;
    const float* positions_;
    const kernel::BuildKernels& kernels_;
};

}  // namespace

Box box_of(const GrowingBox& box) {
    Box out{glm::vec3(kInfinity), glm::vec3(-kInfinity)};
    if (!(-box.neg_min[0] <= box.max[0])) return out;
    for (int a = 0; a < 3; ++a) {
        out.min[static_cast<std::size_t>(a)] = 0.0f - box.neg_min[a];
        out.max[static_cast<std::size_t>(a)] = box.max[a] + 0.0f;
    }
    return out;
}

void fit(Blas::Data& blas, std::span<const glm::vec3> positions) {
    if (blas.root == kernel::kEmptyTree) return;
    const Fitting fitting(blas, positions);
    if (blas.root & kernel::kLeafBit) {
        blas.bounds = box_of(fitting.fit_leaf(blas.root).bounds);
        return;
    }
    const Fitting::Fitted all = fitting.fit_node(blas.root, static_cast<std::uint32_t>(blas.nodes.size()));
    blas.bounds = box_of(all.bounds);
    blas.cost = relative_cost(all.cost, blas.bounds);
}

float cost_of(const Blas::Data& blas) {
    if (blas.root == kernel::kEmptyTree) return 0.0f;
    if (blas.root & kernel::kLeafBit) return triangles_in(blas, blas.root);
    const kernel::BuildKernels& kernels = active_build_kernels();
    // Blocks of fixed size, added up in order: one sum for any thread count.
    std::vector<double> sums((blas.nodes.size() + kCostBlock - 1) / kCostBlock, 0.0);
    for_in_parallel(sums.size(), [&](std::size_t block) {
        const std::size_t end = std::min(blas.nodes.size(), (block + 1) * kCostBlock);
        for (std::size_t i = block * kCostBlock; i < end; ++i) {
            GrowingBox box;
            float half_areas[kernel::kWidth];
            kernels.measure_lanes(blas.nodes[i], box, half_areas);
            sums[block] += cost_of_lanes(blas, blas.nodes[i], half_areas);
        }
    });
    double sum = 0.0;
    for (const double part : sums) sum += part;
    return relative_cost(sum, blas.bounds);
}

bool refit_blas(Blas& blas, std::span<const glm::vec3> positions) {
    Blas::Data& data = blas.data();
    RC_EXPECTS(positions.size() == data.vertex_count, "refit_blas with as many vertices as at build");
    RC_EXPECTS(data.can_refit, "a tree built to be refitted");
    if (positions.size() != data.vertex_count || !data.can_refit) return false;
    fit(data, positions);
    return true;
}

}  // namespace rc
