#include "fill_leaves.h"

#include "collapse.h"
#include "dispatch.h"
#include "parallel.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>
#include <numeric>
#include <vector>

namespace rc {

namespace {

constexpr std::size_t kNodesAtOnce = 256;
constexpr std::size_t kTooMuch = std::size_t{kernel::kUnitMask} + 1;

// The lowest of the leaves that hold a primitive, whichever is filled first.
void note_leaf(std::uint32_t& leaf_of_primitive, std::uint32_t leaf) {
    std::atomic_ref<std::uint32_t> lowest(leaf_of_primitive);
    std::uint32_t known = lowest.load(std::memory_order_relaxed);
    while (leaf < known && !lowest.compare_exchange_weak(known, leaf, std::memory_order_relaxed)) {
    }
}

bool is_leaf_lane(const kernel::WideNode& node, int lane) {
    return node.layers[lane] != 0 && (node.child[lane] & kernel::kLeafBit) != 0;
}

// Blocks lie in the order of their nodes and lanes. What the leaves of a part of the nodes take is found first, by several
// threads, and tells where each part's blocks begin.
class Filling {
  public:
    Filling(Blas::Data& blas, std::span<const std::uint32_t> items, const MeshView& mesh)
        : blas_(blas), items_(items), mesh_(mesh), kernels_(active_build_kernels()) {}

    bool run() {
        if (blas_.root & kernel::kLeafBit) {
            std::size_t unit = 0;
            const kernel::SharedCorners shared = shared_in(blas_.root);
            if (!make_room(units_of(shared, blas_.root))) return false;
            blas_.root = fill_leaf(blas_.root, shared, unit);
            return true;
        }
        const std::size_t parts = (blas_.nodes.size() + kNodesAtOnce - 1) / kNodesAtOnce;
        std::vector<std::size_t> starts(parts + 1, 0);
        shared_.resize(parts);
        for_in_parallel(parts, [&](std::size_t part) { starts[part + 1] = units_of_part(part); });
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        if (!make_room(starts.back())) return false;
        first_leaf_ = leaf_code(first_shared().count, 0);
        for_in_parallel(parts, [&](std::size_t part) { fill_part(part, starts[part]); });
        return true;
    }

  private:
    template <class Visit>
    void for_lanes(std::size_t part, const Visit& visit) const {
        const std::size_t end = std::min(blas_.nodes.size(), (part + 1) * kNodesAtOnce);
        for (std::size_t i = part * kNodesAtOnce; i < end; ++i)
            for (int lane = 0; lane < kernel::kWidth; ++lane) visit(blas_.nodes[i], lane);
    }

    [[nodiscard]] kernel::SharedCorners shared_in(std::uint32_t range) const {
        const auto [first, count] = range_of(range);
        kernel::SharedCorners shared;
        kernels_.share_corners({items_.data(), static_cast<std::uint32_t>(items_.size()), first, count},
                               mesh_arrays_of(mesh_), blas_.can_refit, shared);
        return shared;
    }

    // kTooMuch where there are more corners than a block holds.
    [[nodiscard]] std::size_t units_of(const kernel::SharedCorners& shared, std::uint32_t range) const {
        if (shared.count > kernel::kMaxCorners) return kTooMuch;
        return units_of_leaf(shared.count, range_of(range).count, blas_.can_refit);
    }
    std::size_t units_of_part(std::size_t part) {
        std::size_t units = 0;
        shared_[part].reserve(kernel::kWidth / 2 * kNodesAtOnce);
        for_lanes(part, [&](const kernel::WideNode& node, int lane) {
            if (!is_leaf_lane(node, lane)) return;
            shared_[part].push_back(shared_in(node.child[lane]));
            units += units_of(shared_[part].back(), node.child[lane]);
        });
        return units;
    }

    bool make_room(std::size_t units) {
        if (units >= kTooMuch) return false;
        blas_.leaves.resize(units * kernel::kWordsPerUnit + kernel::kLeafPadding);
        std::fill(blas_.leaves.end() - kernel::kLeafPadding, blas_.leaves.end(), 0.0f);
        return true;
    }

    [[nodiscard]] const kernel::SharedCorners& first_shared() const {
        return std::find_if(shared_.begin(), shared_.end(), [](const auto& part) { return !part.empty(); })
            ->front();
    }

    // Leaves are named by their blocks from now on, and empty lanes by a leaf that is there.
    void fill_part(std::size_t part, std::size_t unit) {
        const kernel::SharedCorners* shared = shared_[part].data();
        for_lanes(part, [&](kernel::WideNode& node, int lane) {
            if (node.layers[lane] == 0) node.child[lane] = first_leaf_;
            if (is_leaf_lane(node, lane)) node.child[lane] = fill_leaf(node.child[lane], *shared++, unit);
        });
    }

    // Gives a leaf its block at `unit`, which moves on, and every primitive in it its leaf; the leaf's name.
    std::uint32_t fill_leaf(std::uint32_t range, const kernel::SharedCorners& shared, std::size_t& unit) {
        const auto [first, count] = range_of(range);
        const LeafPlaces places = places_in_leaf(shared.count, count);
        const std::uint32_t code = leaf_code(shared.count, unit);
        float* block = blas_.leaves.data() + unit * kernel::kWordsPerUnit;
        unit += units_of_leaf(shared.count, count, blas_.can_refit);
        // What nobody reads is the same in every tree as well.
        block[places.primitives - 1] = 0.0f;
        std::fill(block + places.vertices, blas_.leaves.data() + unit * kernel::kWordsPerUnit, 0.0f);
        for (std::uint32_t i = 0; i < shared.count; ++i) {
            const glm::vec3& corner = mesh_.positions[shared.vertices[i]];
            for (std::uint32_t a = 0; a < 3; ++a) block[a * shared.count + i] = corner[a];
            if (blas_.can_refit) block[places.vertices + i] = std::bit_cast<float>(shared.vertices[i]);
        }
        std::memcpy(block + places.halves, shared.halves, count * sizeof(shared.halves[0]));
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t primitive = items_[first + i];
            block[places.primitives + i] = std::bit_cast<float>(primitive);
            note_leaf(blas_.leaf_of_primitive[primitive], code);
        }
        return code;
    }

    Blas::Data& blas_;
    std::span<const std::uint32_t> items_;
    const MeshView& mesh_;
    const kernel::BuildKernels& kernels_;
    std::vector<std::vector<kernel::SharedCorners>> shared_;  // by part, in the order of its leaves
    std::uint32_t first_leaf_ = kernel::kEmptyTree;
};

}  // namespace

bool fill_leaves(Blas::Data& blas, std::span<const std::uint32_t> items, const MeshView& mesh) {
    if (blas.root != kernel::kEmptyTree) return Filling(blas, items, mesh).run();
    blas.leaves.assign(kernel::kLeafPadding, 0.0f);
    return true;
}

}  // namespace rc
