// node_pool.h - nodes for builders whose subtrees grow side by side.
//
// Siblings lie next to each other. A subtree of m refs takes at most m - 1 pairs, in small chunks, so that memory is
// touched only where nodes are: first use of a page is a tenth of a build where pages are small.
#pragma once

#include "binned_builder.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace rc::build {

class NodePool {
  public:
    explicit NodePool(std::size_t refs) : nodes_(2 * refs), heights_(2 * refs), next_(1) {}

    BinaryNode& operator[](std::size_t i) { return nodes_[i]; }
    std::uint8_t& height_of(std::size_t i) { return heights_[i]; }

    [[nodiscard]] std::uint32_t take_pairs(std::size_t pairs) {
        return next_.fetch_add(static_cast<std::uint32_t>(2 * pairs), std::memory_order_relaxed);
    }
    [[nodiscard]] BinaryTree release(Unfilled<std::uint32_t> items) {
        return {std::move(nodes_), std::move(heights_), next_.load(), std::move(items)};
    }

  private:
    Unfilled<BinaryNode> nodes_;
    Unfilled<std::uint8_t> heights_;
    std::atomic<std::uint32_t> next_;
};

// Pairs for one subtree that one thread builds.
class PairSupply {
  public:
    PairSupply(NodePool& pool, std::size_t refs) : pool_(pool), unclaimed_(refs - 1) {}

    std::uint32_t take() {
        if (here_ == 0) {
            here_ = std::min<std::size_t>(unclaimed_, kChunk);
            unclaimed_ -= here_;
            next_ = pool_.take_pairs(here_);
        }
        --here_;
        next_ += 2;
        return next_ - 2;
    }

  private:
    static constexpr std::size_t kChunk = 64;
    NodePool& pool_;
    std::size_t unclaimed_, here_ = 0;
    std::uint32_t next_ = 0;
};

}  // namespace rc::build
