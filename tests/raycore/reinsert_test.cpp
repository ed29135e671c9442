// Putting subtrees back where they cost less: the tree becomes cheaper, holds what it held, and is no deeper than stacks
// are high; nor does it matter where its nodes lay or how many threads looked.
#include "reinsert.h"

#include "kernels/kernel_abi.h"
#include "support/random.h"

#include "raycore/blas.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace {

using rc::BinaryNode;
using rc::BinaryTree;
using test::Random;

// A tree written down by hand over clusters of small boxes; pairs of siblings lie in the order of `places`.
class Planter {
  public:
    static constexpr std::uint32_t kCluster = 64;  // boxes: 6 levels

    explicit Planter(const std::vector<glm::vec3>& clusters, std::uint64_t places = 0)
        : boxes_(clusters.size() * kCluster), places_(boxes_.size() - 1) {
        Random random(7);
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            const glm::vec3 at = clusters[i / kCluster] + random.in_cube(3.0f);
            boxes_[i] = {at, at + glm::abs(random.in_cube(0.5f))};
        }
        std::iota(places_.begin(), places_.end(), 0u);
        Random shuffling(places);
        for (std::size_t i = places_.size(); i > 1 && places != 0; --i)
            std::swap(places_[i - 1], places_[shuffling.below(static_cast<std::uint32_t>(i))]);
        tree_.size = 2 * boxes_.size() - 1;
        tree_.nodes.assign(tree_.size, BinaryNode{});
        tree_.heights.assign(tree_.size, 0);
    }

    // Halved by number: what is put together above the clusters lies anywhere.
    BinaryTree balanced() {
        grow(0, 0, static_cast<std::uint32_t>(boxes_.size()));
        return std::move(tree_);
    }

  private:
    void grow(std::uint32_t at, std::uint32_t begin, std::uint32_t end) {
        BinaryNode& node = tree_.nodes[at];
        if (end - begin == 1) {
            for (std::size_t a = 0; a < 3; ++a) {
                node.min[a] = boxes_[begin].min[a];
                node.max[a] = boxes_[begin].max[a];
            }
            node.first = begin;
            node.count = 1;
            return;
        }
        const std::uint32_t middle = begin + (end - begin) / 2;
        const std::uint32_t first = 1 + 2 * places_[next_++];
        grow(first, begin, middle);
        grow(first + 1, middle, end);
        for (int a = 0; a < 3; ++a) {
            node.min[a] = std::min(tree_.nodes[first].min[a], tree_.nodes[first + 1].min[a]);
            node.max[a] = std::max(tree_.nodes[first].max[a], tree_.nodes[first + 1].max[a]);
        }
        node.first = first;
        node.count = BinaryNode::kInner | (end - begin);
        tree_.heights[at] =
            static_cast<std::uint8_t>(1 + std::max(tree_.heights[first], tree_.heights[first + 1]));
    }

    std::vector<rc::Box> boxes_;
    std::vector<std::uint32_t> places_;
    std::size_t next_ = 0;
    BinaryTree tree_;
};

std::vector<glm::vec3> anywhere(std::size_t count) {
    Random random(8);
    std::vector<glm::vec3> places(count);
    for (glm::vec3& place : places) place = random.in_cube(50.0f);
    return places;
}

double surface_of(const BinaryTree& tree, std::uint32_t at = 0) {
    const BinaryNode& node = tree.nodes[at];
    if (node.is_leaf()) return 0.0;
    return double(rc::half_area(node)) + surface_of(tree, node.first) + surface_of(tree, node.first + 1);
}

// The whole tree in words that do not tell where nodes lie.
std::string told(const BinaryTree& tree, std::uint32_t at = 0) {
    const BinaryNode& node = tree.nodes[at];
    if (node.is_leaf()) return std::to_string(node.first);
    return "(" + told(tree, node.first) + " " + told(tree, node.first + 1) + ")";
}

// Leaves below; everything a node says of what is below it is looked at.
std::vector<std::uint32_t> leaves_of(const BinaryTree& tree, int below_leaves = 0, int depth = 0,
                                     std::uint32_t at = 0) {
    const BinaryNode& node = tree.nodes[at];
    EXPECT_LE(depth + tree.heights[at], rc::kernel::kMaxDepth);
    if (node.is_leaf()) {
        EXPECT_EQ(tree.heights[at], below_leaves);
        return {node.first};
    }
    std::vector<std::uint32_t> leaves;
    for (const std::uint32_t child : {node.first, node.first + 1}) {
        const std::vector<std::uint32_t> below = leaves_of(tree, below_leaves, depth + 1, child);
        leaves.insert(leaves.end(), below.begin(), below.end());
        EXPECT_LT(tree.heights[child], tree.heights[at]);
        for (int a = 0; a < 3; ++a) {
            EXPECT_LE(node.min[a], tree.nodes[child].min[a]);
            EXPECT_GE(node.max[a], tree.nodes[child].max[a]);
        }
    }
    EXPECT_EQ(node.size(), leaves.size());
    EXPECT_EQ(tree.heights[at], 1 + std::max(tree.heights[node.first], tree.heights[node.first + 1]));
    return leaves;
}

void expect_all(std::vector<std::uint32_t> leaves, std::size_t count) {
    std::sort(leaves.begin(), leaves.end());
    ASSERT_EQ(leaves.size(), count);
    for (std::uint32_t i = 0; i < count; ++i) EXPECT_EQ(leaves[i], i);
}

TEST(Reinsert, MakesABadTreeCheaperAndLosesNothing) {
    BinaryTree tree = Planter(anywhere(64)).balanced();
    const double before = surface_of(tree);
    rc::reinsert(tree);
    EXPECT_LT(surface_of(tree), 0.8 * before);
    expect_all(leaves_of(tree), 64 * Planter::kCluster);
}

TEST(Reinsert, MakesOneTreeWhereverNodesLieAndWhoeverLooks) {
    std::string first;
    for (const std::uint64_t places : {0u, 1u, 2u}) {
        for (const std::size_t threads : {1u, 4u}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            BinaryTree tree = Planter(anywhere(256), places).balanced();
            const std::string before = told(tree);
            rc::reinsert(tree);
            if (first.empty()) first = told(tree);
            EXPECT_NE(first, before);
            EXPECT_EQ(told(tree), first) << "order " << places << ", " << threads << " threads";
        }
    }
}

// Leaves that stand for trees of many levels each: there is room for one level more.
TEST(Reinsert, GrowsNoTreeDeeperThanStacksAreHigh) {
    constexpr int kBelowLeaves = rc::kernel::kMaxDepth - 13;
    BinaryTree tree = Planter(anywhere(64)).balanced();
    for (std::size_t i = 0; i < tree.size; ++i) tree.heights[i] += kBelowLeaves;
    ASSERT_EQ(tree.heights[0], rc::kernel::kMaxDepth - 1);
    const double before = surface_of(tree);
    rc::reinsert(tree);
    EXPECT_LT(surface_of(tree), 0.99 * before);
    expect_all(leaves_of(tree, kBelowLeaves), 64 * Planter::kCluster);
}

TEST(Reinsert, LeavesTreesWithoutSurfaceOrOfOneLeafAsTheyAre) {
    for (const float size : {0.0f, 3e38f}) {  // no surface; one too large for a float
        BinaryTree tree = Planter(anywhere(4)).balanced();
        for (std::size_t i = 0; i < tree.size; ++i) {
            std::fill_n(tree.nodes[i].min, 3, -size);
            std::fill_n(tree.nodes[i].max, 3, size);
        }
        const std::string before = told(tree);
        rc::reinsert(tree);
        EXPECT_EQ(told(tree), before);
    }
    BinaryTree leaf;
    leaf.nodes.assign(1, BinaryNode{});
    leaf.nodes[0].count = 1;
    leaf.size = 1;
    rc::reinsert(leaf);
    EXPECT_EQ(told(leaf), "0");
}

}  // namespace
