#include "reinsert.h"

#include "kernels/kernel_abi.h"
#include "parallel.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <vector>

namespace rc {

namespace {

constexpr int kReinsertions = 2;  // over the tree; a third saves surface, but no node of any ray
// Subtrees whose places are looked for before the first of them is moved, and of them by one thread at a time.
constexpr std::size_t kMostAtOnce = 512, kFewestAtOnce = 64, kSearchesAtATime = 64;
// kMostAtOnce together must have saved this share of the root's surface, or no smaller ones are tried.
constexpr float kEnoughSaved = 0.02f;
// Of the surface of the node that goes away: smaller gains buy surface with boxes that overlap, and rays start inside.
constexpr float kLeastSaved = 0.05f;

struct Bounds {
    float min[3], max[3];
};

void widen(Bounds& bounds, const BinaryNode& by) {
    for (int a = 0; a < 3; ++a) {
        bounds.min[a] = std::min(bounds.min[a], by.min[a]);
        bounds.max[a] = std::max(bounds.max[a], by.max[a]);
    }
}

Bounds bounds_of(const BinaryNode& node) {
    Bounds bounds;
    std::copy_n(node.min, 3, bounds.min);
    std::copy_n(node.max, 3, bounds.max);
    return bounds;
}

float area_of_both(const BinaryNode& a, const BinaryNode& b) {
    Bounds both = bounds_of(a);
    widen(both, b);
    return half_area(both);
}

std::uint32_t sibling_of(std::uint32_t node) {
    return ((node - 1) ^ 1) + 1;  // pairs begin at odd indices
}

class Reinsertion {
  public:
    explicit Reinsertion(BinaryTree& tree)
        : nodes_(tree.nodes.data()),
          heights_(tree.heights.data()),
          parents_(std::make_unique_for_overwrite<std::uint32_t[]>(tree.size)) {}

    // Whether it saved enough to be done again.
    bool run() {
        const std::size_t size = nodes_[0].size(),
                          at_once = std::clamp(size / 128, kFewestAtOnce, kMostAtOnce);
        const float enough = kEnoughSaved * float(at_once) / float(kMostAtOnce) * half_area(nodes_[0]);
        waiting_.assign(1, {half_area(nodes_[0]), 0, 0});
        seen_ = 0;
        float saved = 0.0f;
        for (std::size_t done = 0; done < size / 8; done += at_once) {
            const float last = put_back(next_largest(at_once));
            saved += last;
            if (done > 0 && !(last > enough)) break;  // the very largest may have no better place
        }
        return saved > enough;
    }

  private:
    struct Place {
        float saved = 0.0f;
        std::uint32_t beside = 0;
    };
    struct Waiting {
        float area;
        std::uint32_t order;  // in which they were seen: that of the tree, and not of where nodes lie
        std::uint32_t node;
        bool operator<(const Waiting& other) const {
            return area != other.area ? area < other.area : order > other.order;
        }
    };

    // The root and its children stay where they are.
    [[nodiscard]] bool stays(std::uint32_t node) const { return node == 0 || parents_[node] == 0; }

    // Those of most surface that were not taken yet. They and their ancestors are a connected top of the tree, since no
    // child is larger than its parent; all of it is told its parents.
    [[nodiscard]] std::vector<std::uint32_t> next_largest(std::size_t wanted) {
        std::vector<std::uint32_t> largest;
        while (!waiting_.empty() && largest.size() < wanted) {
            std::pop_heap(waiting_.begin(), waiting_.end());
            const std::uint32_t node = waiting_.back().node;
            waiting_.pop_back();
            if (!stays(node)) largest.push_back(node);
            if (nodes_[node].is_leaf()) continue;
            for (const std::uint32_t child : {nodes_[node].first, nodes_[node].first + 1}) {
                parents_[child] = node;
                waiting_.push_back({half_area(nodes_[child]), ++seen_, child});
                std::push_heap(waiting_.begin(), waiting_.end());
            }
        }
        return largest;
    }

    // What is saved by moving subtrees, one by one. That most of them had better stay is found out side by side.
    float put_back(const std::vector<std::uint32_t>& subtrees) {
        std::vector<std::uint8_t> may_move(subtrees.size());
        for_in_parallel(BlockedRange(0, subtrees.size(), kSearchesAtATime), [&](const auto& some) {
            for (std::size_t i = some.begin(); i < some.end(); ++i)
                may_move[i] = best_place<false>(subtrees[i]).saved > 0.0f;
        });
        float saved = 0.0f;
        for (std::size_t i = 0; i < subtrees.size(); ++i) {
            if (may_move[i] == 0 || stays(subtrees[i])) continue;  // others may have moved it up
            const Place place = best_place<true>(subtrees[i]);
            if (place.saved > 0.0f && move(subtrees[i], place.beside)) saved += place.saved;
        }
        return saved;
    }

    // Where else a subtree would save most surface of inner nodes. `kNoting` tells every node on the way its parent.
    template <bool kNoting>
    [[nodiscard]] Place best_place(std::uint32_t subtree) const {
        const BinaryNode& in = nodes_[subtree];
        std::uint32_t above = parents_[subtree], aside = sibling_of(subtree);
        // What taking it out saves so far: its parent, and what ancestors up to `above` shrink by.
        float saved = half_area(nodes_[above]);
        const float least = kLeastSaved * saved;
        Place best{least, 0};
        look_below<kNoting>({half_area(nodes_[aside]), aside}, in, best);
        Bounds left = bounds_of(nodes_[aside]);  // of `above` without it
        while (above != 0) {
            aside = sibling_of(above);
            above = parents_[above];
            look_below<kNoting>(look_at(aside, saved, in, best), in, best);
            widen(left, nodes_[aside]);
            const float without = half_area(left), with = half_area(nodes_[above]);
            if (saved - without > best.saved) best = {saved - without, above};  // beside all of it
            saved += with - without;
        }
        return best.saved > least ? best : Place{};
    }

    // A node, and what would be saved before a new one is made below it.
    struct Look {
        float saved;
        std::uint32_t node;
    };
    [[nodiscard]] Look look_at(std::uint32_t node, float saved, const BinaryNode& in, Place& best) const {
        const float with = area_of_both(nodes_[node], in);
        if (saved - with > best.saved) best = {saved - with, node};
        return {saved - with + half_area(nodes_[node]), node};
    }

    template <bool kNoting>
    void look_below(const Look& from, const BinaryNode& in, Place& best) const {
        const float area = half_area(in);
        std::array<Look, kernel::kMaxDepth + 1> stack;
        std::size_t n = 0;
        stack[n++] = from;
        while (n > 0) {
            const Look next = stack[--n];
            const BinaryNode& node = nodes_[next.node];
            // Wherever it is put below, a node of its size is made. A surface that is not a number ends it as well.
            if (node.is_leaf() || !(next.saved - area > best.saved)) continue;
            if constexpr (kNoting) parents_[node.first] = parents_[node.first + 1] = next.node;
            const Look left = look_at(node.first, next.saved, in, best),
                       right = look_at(node.first + 1, next.saved, in, best);
            const bool right_first = right.saved > left.saved;
            stack[n++] = right_first ? left : right;
            stack[n++] = right_first ? right : left;
        }
    }

    // The subtree's parent makes way for its sibling, and their pair of nodes is for the subtree and what it comes beside.
    bool move(std::uint32_t subtree, std::uint32_t beside) {
        const int height = 1 + std::max(heights_[subtree], heights_[beside]);
        if (depth_of(beside) + height > kernel::kMaxDepth) return false;
        const std::uint32_t sibling = sibling_of(subtree), parent = parents_[subtree];
        put(sibling, parent);
        put(beside, sibling);
        nodes_[beside].first = std::min(subtree, sibling);
        nodes_[beside].count = BinaryNode::kInner;
        parents_[subtree] = parents_[sibling] = beside;
        refit(beside);
        refit(parents_[parent]);
        return true;
    }

    void put(std::uint32_t node, std::uint32_t to) {
        nodes_[to] = nodes_[node];
        heights_[to] = heights_[node];
        if (!nodes_[to].is_leaf()) parents_[nodes_[to].first] = parents_[nodes_[to].first + 1] = to;
    }

    [[nodiscard]] int depth_of(std::uint32_t node) const {
        int depth = 0;
        for (; node != 0; node = parents_[node]) ++depth;
        return depth;
    }

    // Box, size and height of an inner node and all above it.
    void refit(std::uint32_t at) {
        for (;; at = parents_[at]) {
            BinaryNode& node = nodes_[at];
            const BinaryNode &left = nodes_[node.first], &right = nodes_[node.first + 1];
            Bounds both = bounds_of(left);
            widen(both, right);
            std::copy_n(both.min, 3, node.min);
            std::copy_n(both.max, 3, node.max);
            node.count = BinaryNode::kInner | (left.size() + right.size());
            const int below = std::max(heights_[node.first], heights_[node.first + 1]);
            heights_[at] = static_cast<std::uint8_t>(1 + below);
            if (at == 0) return;
        }
    }

    BinaryNode* nodes_;
    std::uint8_t* heights_;
    std::unique_ptr<std::uint32_t[]> parents_;  // of what was looked at
    std::vector<Waiting> waiting_;              // a heap
    std::uint32_t seen_ = 0;
};

}  // namespace

void reinsert(BinaryTree& tree) {
    const float area = half_area(tree.nodes[0]);
    if (tree.nodes[0].is_leaf() || !(area <= std::numeric_limits<float>::max())) return;
    Reinsertion reinsertion(tree);
    for (int i = 0; i < kReinsertions && reinsertion.run(); ++i) {
    }
}

}  // namespace rc
