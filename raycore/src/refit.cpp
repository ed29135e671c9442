#include "contract.h"
#include "fit.h"
#include "triangle_check.h"

#include <glm/common.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace rc {

namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
// A node with this many nodes below it is fitted by several threads.
constexpr std::uint32_t kParallelNodes = 256;
constexpr std::size_t kCostBlock = 1024;

const Box kNoBox{glm::vec3(kInf), glm::vec3(-kInf)};

bool is_empty(const Box& box) {
    return !(box.min.x <= box.max.x);
}

Box united(const Box& a, const Box& b) {
    return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

float half_area(const Box& box) {
    if (is_empty(box)) return 0.0f;
    const glm::vec3 d = box.max - box.min;
    return (d.x * d.y + d.y * d.z) + d.z * d.x;
}

Box box_in(const kernel::WideNode& node, int lane) {
    const auto at = [&](int row) { return node.bounds[row][lane]; };
    return {{at(0), at(2), at(4)}, {at(1), at(3), at(5)}};
}

void set_box(kernel::WideNode& node, int lane, const Box& box) {
    for (int a = 0; a < 3; ++a) {
        node.bounds[2 * a][lane] = box.min[static_cast<std::size_t>(a)];
        node.bounds[2 * a + 1][lane] = box.max[static_cast<std::size_t>(a)];
    }
}

// -0 becomes +0, so that a box has one representation.
glm::vec3 without_negative_zero(const glm::vec3& p) {
    return p + glm::vec3(0.0f);
}

Box fit_leaf(Blas::Data& blas, std::uint32_t code, std::span<const glm::vec3> positions) {
    const LeafRange leaf = leaf_range(code);
    float* block = blas.leaves.data() + std::size_t{leaf.first} * kernel::kWordsPerTriangle;
    Box box = kNoBox;
    for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
        const glm::uvec3& triangle = blas.triangles[primitive_in(blas.leaves.data(), leaf, lane)];
        glm::vec3 p[3] = {positions[triangle.x], positions[triangle.y], positions[triangle.z]};
        if (fault_of(p[0], p[1], p[2]) == TriangleFault::None) {
            for (const glm::vec3& corner : p) box = united(box, {corner, corner});
        } else {
            for (glm::vec3& corner : p) corner = glm::vec3(std::numeric_limits<float>::quiet_NaN());
        }
        for (std::uint32_t row = 0; row < 9; ++row) block[row * leaf.count + lane] = p[row / 3][row % 3];
    }
    return {without_negative_zero(box.min), without_negative_zero(box.max)};
}

// A subtree's box, its leaves and boxes fitted on the way up.
Box fit_child(Blas::Data& blas, std::uint32_t item, std::uint32_t nodes_below,
              std::span<const glm::vec3> positions) {
    if (item & kernel::kLeafBit) return fit_leaf(blas, item, positions);
    Box whole = kNoBox;
    kernel::WideNode& node = blas.nodes[item];
    const auto fit_lane = [&](int lane) {
        if (node.layers[lane] != 0)
            set_box(node, lane, fit_child(blas, node.child[lane], node.layers[lane], positions));
    };
    // Lanes are disjoint subtrees and each writes its own; near the leaves a task would cost more than it gains.
    if (nodes_below >= kParallelNodes) {
        tbb::parallel_for(0, kernel::kWidth, fit_lane);
    } else {
        for (int lane = 0; lane < kernel::kWidth; ++lane) fit_lane(lane);
    }
    for (int lane = 0; lane < kernel::kWidth; ++lane)
        if (node.layers[lane] != 0) whole = united(whole, box_in(node, lane));
    return whole;
}

}  // namespace

void fit(Blas::Data& blas, std::span<const glm::vec3> positions) {
    blas.bounds = blas.root == kernel::kEmptyTree
                      ? kNoBox
                      : fit_child(blas, blas.root, static_cast<std::uint32_t>(blas.nodes.size()), positions);
    blas.cost = cost_of(blas);
}

float cost_of(const Blas::Data& blas) {
    if (blas.root == kernel::kEmptyTree) return 0.0f;
    const auto count_in = [](std::uint32_t leaf) { return float(leaf_range(leaf).count); };
    if (blas.root & kernel::kLeafBit) return count_in(blas.root);
    const double root_area = double(half_area(blas.bounds));
    if (!(root_area > 0.0)) return 1.0f;
    // Blocks of fixed size, added up in order: one sum for any thread count.
    std::vector<double> sums((blas.nodes.size() + kCostBlock - 1) / kCostBlock, 0.0);
    tbb::parallel_for(std::size_t{0}, sums.size(), [&](std::size_t block) {
        const std::size_t end = std::min(blas.nodes.size(), (block + 1) * kCostBlock);
        for (std::size_t i = block * kCostBlock; i < end; ++i) {
            const kernel::WideNode& node = blas.nodes[i];
            for (int lane = 0; lane < kernel::kWidth; ++lane) {
                if (node.layers[lane] == 0) continue;
                const bool is_leaf = (node.child[lane] & kernel::kLeafBit) != 0;
                sums[block] +=
                    double(half_area(box_in(node, lane)) * (is_leaf ? count_in(node.child[lane]) : 1.0f));
            }
        }
    });
    double sum = root_area;
    for (const double part : sums) sum += part;
    return float(sum / root_area);
}

void refit_blas(Blas& blas, std::span<const glm::vec3> positions) {
    RC_EXPECTS(positions.size() == blas.data().vertex_count, "refit_blas with as many vertices as at build");
    if (positions.size() != blas.data().vertex_count) return;
    fit(blas.data(), positions);
}

}  // namespace rc
