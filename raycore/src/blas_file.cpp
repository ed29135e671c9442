#include "raycore/blas_file.h"

#include "collapse.h"
#include "contract.h"
#include "data.h"
#include "fill_leaves.h"
#include "parallel.h"
#include "triangle_check.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <optional>
#include <utility>

namespace rc {

namespace {

constexpr char kMagic[8] = {'r', 'a', 'y', 'c', 'o', 'r', 'e', '\n'};
constexpr std::uint32_t kVersion = 3;

// Whatever the meaning of a node's bytes depends on; another layout with these same sizes needs another kVersion.
constexpr std::uint32_t kLayout =
    static_cast<std::uint32_t>(sizeof(kernel::WideNode)) << 16 | kernel::kWidth << 8 | kernel::kMaxCorners;

struct Header {
    char magic[8];
    std::uint32_t version;
    std::uint32_t layout;
    std::uint64_t mesh_hash;
    std::uint64_t content_hash;  // of the rest of the header and all that follows
    std::uint64_t vertex_count;
    std::uint64_t triangle_count;
    std::uint64_t node_count;  // nodes, then items
    std::uint64_t item_count;
    std::uint32_t root;
    std::uint32_t can_refit;
    float cost_when_built;
    float cost;
    Box bounds;
};
static_assert(sizeof(Header) == 104 && std::is_trivially_copyable_v<Header>);
constexpr std::size_t kHashedFrom = offsetof(Header, vertex_count);

// Eight bytes at a time; tells damage, not malice.
std::uint64_t hash(std::uint64_t seed, const void* data, std::size_t size) {
    constexpr std::uint64_t kPrime = 0x9E3779B97F4A7C15u;
    const auto* at = static_cast<const unsigned char*>(data);
    std::uint64_t state = seed ^ size * kPrime;
    const auto mix = [&](std::uint64_t word) {
        state = (state ^ word) * kPrime;
        state ^= state >> 29;
    };
    for (; size >= 8; size -= 8, at += 8) {
        std::uint64_t word;
        std::memcpy(&word, at, 8);
        mix(word);
    }
    std::uint64_t rest = 0;
    if (size > 0) std::memcpy(&rest, at, size);
    mix(rest);
    return state;
}

std::uint64_t hash_of(const MeshView& mesh) {
    const std::uint64_t positions = hash(1, mesh.positions.data(), mesh.positions.size_bytes());
    return hash(positions, mesh.triangles.data(), mesh.triangles.size_bytes());
}

// A tree whose leaves are ranges of items, as collapse.h has it: nothing of how a block is laid out.
struct PlainTree {
    Unfilled<kernel::WideNode> nodes;
    std::uint32_t root = kernel::kEmptyTree;
    Unfilled<std::uint32_t> items;
};

PlainTree plain_tree_of(const Blas::Data& blas) {
    PlainTree tree{blas.nodes, blas.root, {}};
    const auto plain = [&](std::uint32_t code) {
        const Leaf leaf(blas.leaves.data(), code);
        const ItemRange range{static_cast<std::uint32_t>(tree.items.size()), leaf.size()};
        for (std::uint32_t i = 0; i < leaf.size(); ++i) tree.items.push_back(leaf.primitive(i));
        return range_code(range);
    };
    if (blas.root != kernel::kEmptyTree && (blas.root & kernel::kLeafBit) != 0) tree.root = plain(blas.root);
    for (kernel::WideNode& node : tree.nodes) {
        for (int lane = 0; lane < kernel::kWidth; ++lane) {
            if (node.layers[lane] == 0)
                node.child[lane] = range_code({0, 1});
            else if (node.child[lane] & kernel::kLeafBit)
                node.child[lane] = plain(node.child[lane]);
        }
    }
    return tree;
}

// Whether the corners in the leaves are the mesh's, where it has any to compare.
bool is_built_from(const Blas::Data& blas, const MeshView& mesh) {
    if (blas.vertex_count != mesh.positions.size() || blas.leaf_of_primitive.size() != mesh.triangles.size())
        return false;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const std::uint32_t code = blas.leaf_of_primitive[i];
        if (fault_of(mesh.positions, mesh.triangles[i]) != TriangleFault::None || code == kNone) continue;
        const Leaf leaf(blas.leaves.data(), code);
        for (std::uint32_t at = 0; at < leaf.size(); ++at) {
            if (leaf.primitive(at) != i) continue;
            for (std::uint32_t c = 0; c < 3; ++c)
                if (leaf.corner(at, c) != mesh.positions[mesh.triangles[i][c]]) return false;
        }
    }
    return true;
}

// A refit may have flattened a triangle of the tree, or mended one that was dropped: loading would refuse either.
bool still_keeps_what_it_kept(const Blas::Data& blas, const MeshView& mesh) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const bool is_kept = blas.leaf_of_primitive[i] != kNone;
        if (is_kept != (fault_of(mesh.positions, mesh.triangles[i]) == TriangleFault::None)) return false;
    }
    return true;
}

// A tree read from bytes that may hold anything: nothing is looked up before it is known to be there.
class TreeCheck {
  public:
    TreeCheck(const Unfilled<kernel::WideNode>& nodes, std::span<const std::uint32_t> items)
        : nodes_(nodes), items_(items), depth_(nodes.size(), 0), covered_(items.size(), false) {}

    // A parent before its children, each child once, no more levels than the stacks are high, every item in one leaf.
    bool is_sound(std::uint32_t root) {
        if (root == kernel::kEmptyTree) return nodes_.empty() && items_.empty();
        if (root & kernel::kLeafBit) return nodes_.empty() && cover(root) && covers_all();
        if (root != 0 || nodes_.empty()) return false;
        depth_[0] = 1;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (depth_[i] == 0 || depth_[i] > kernel::kMaxDepth) return false;
            for (int lane = 0; lane < kernel::kWidth; ++lane)
                if (!is_sound_lane(i, lane)) return false;
        }
        return covers_all() && counts_fit();
    }

  private:
    bool is_sound_lane(std::size_t i, int lane) {
        const std::uint32_t child = nodes_[i].child[lane];
        if (nodes_[i].layers[lane] == 0)  // still the name of a leaf that exists
            return child != kernel::kEmptyTree && (child & kernel::kLeafBit) != 0 && is_inside(child);
        if (child & kernel::kLeafBit) return nodes_[i].layers[lane] == 1 && cover(child);
        if (child <= i || child >= nodes_.size() || depth_[child] != 0) return false;
        depth_[child] = depth_[i] + 1;
        return true;
    }

    [[nodiscard]] bool is_inside(std::uint32_t code) const {
        const ItemRange range = range_of(code);
        return range.first < items_.size() && range.count <= items_.size() - range.first;
    }

    bool cover(std::uint32_t code) {
        if (!is_inside(code)) return false;
        const ItemRange range = range_of(code);
        for (std::uint32_t k = 0; k < range.count; ++k) {
            if (covered_[range.first + k]) return false;
            covered_[range.first + k] = true;
        }
        return true;
    }

    [[nodiscard]] bool covers_all() const {
        return std::find(covered_.begin(), covered_.end(), false) == covered_.end();
    }

    // Lanes of inner nodes say how many nodes are below.
    [[nodiscard]] bool counts_fit() const {
        std::vector<std::uint32_t> size(nodes_.size(), 1);
        for (std::size_t i = nodes_.size(); i-- > 0;) {
            for (int lane = 0; lane < kernel::kWidth; ++lane) {
                const std::uint32_t child = nodes_[i].child[lane];
                if (nodes_[i].layers[lane] == 0 || (child & kernel::kLeafBit) != 0) continue;
                if (nodes_[i].layers[lane] != size[child]) return false;
                size[i] += size[child];
            }
        }
        return true;
    }

    const Unfilled<kernel::WideNode>& nodes_;
    std::span<const std::uint32_t> items_;
    std::vector<int> depth_;  // 0: not reached
    std::vector<bool> covered_;
};

// Every triangle worth keeping at least once, and no other.
bool holds_what_is_kept(std::span<const std::uint32_t> items, const MeshView& mesh,
                        const MeshReport& report) {
    std::vector<bool> held(mesh.triangles.size(), false);
    std::size_t count = 0;
    for (const std::uint32_t item : items) {
        if (item >= held.size() || fault_of(mesh.positions, mesh.triangles[item]) != TriangleFault::None)
            return false;
        count += !held[item];
        held[item] = true;
    }
    return count == report.kept();
}

LoadedBlas refuse(const char* sentence) {
    return {nullptr, sentence};
}

}  // namespace

std::vector<std::byte> save_blas(const Blas& blas, const MeshView& mesh) {
    const Blas::Data& data = blas.data();
    const bool fits = is_built_from(data, mesh);
    RC_EXPECTS(fits, "save_blas with the mesh the tree was built from");
    if (!fits || !still_keeps_what_it_kept(data, mesh)) return {};
    const PlainTree tree = plain_tree_of(data);
    Header header{};
    std::memcpy(header.magic, kMagic, sizeof(kMagic));
    header.version = kVersion;
    header.layout = kLayout;
    header.mesh_hash = hash_of(mesh);
    header.vertex_count = data.vertex_count;
    header.triangle_count = mesh.triangles.size();
    header.node_count = tree.nodes.size();
    header.item_count = tree.items.size();
    header.root = tree.root;
    header.can_refit = data.can_refit ? 1 : 0;
    header.cost_when_built = data.cost_when_built;
    header.cost = data.cost;
    header.bounds = data.bounds;

    const std::size_t node_bytes = tree.nodes.size() * sizeof(kernel::WideNode);
    const std::size_t item_bytes = tree.items.size() * sizeof(std::uint32_t);
    std::vector<std::byte> bytes(sizeof(Header) + node_bytes + item_bytes);
    std::memcpy(bytes.data(), &header, sizeof(header));
    if (node_bytes > 0) std::memcpy(bytes.data() + sizeof(Header), tree.nodes.data(), node_bytes);
    if (item_bytes > 0)
        std::memcpy(bytes.data() + sizeof(Header) + node_bytes, tree.items.data(), item_bytes);
    header.content_hash = hash(kVersion, bytes.data() + kHashedFrom, bytes.size() - kHashedFrom);
    std::memcpy(bytes.data(), &header, sizeof(header));
    return bytes;
}

LoadedBlas load_blas(std::span<const std::byte> bytes, const MeshView& mesh) {
    Header header;
    if (bytes.size() < sizeof(header)) return refuse("too short to be a saved tree");
    std::memcpy(&header, bytes.data(), sizeof(header));
    if (std::memcmp(header.magic, kMagic, sizeof(kMagic)) != 0) return refuse("not a saved tree");
    if (header.version != kVersion || header.layout != kLayout)
        return refuse("the tree was saved by another version of raycore");
    if (mesh.triangles.size() > kMaxTriangles || header.vertex_count != mesh.positions.size() ||
        header.triangle_count != mesh.triangles.size() || header.mesh_hash != hash_of(mesh))
        return refuse("the tree was saved for another mesh");
    const std::size_t content = bytes.size() - sizeof(header);
    if (header.node_count > content / sizeof(kernel::WideNode) ||
        header.item_count > content / sizeof(std::uint32_t) ||
        header.node_count * sizeof(kernel::WideNode) + header.item_count * sizeof(std::uint32_t) != content)
        return refuse("the saved tree is cut short or too long");
    if (header.content_hash != hash(kVersion, bytes.data() + kHashedFrom, bytes.size() - kHashedFrom))
        return refuse("the saved tree is damaged: its checksum does not fit");

    auto data = std::make_unique<Blas::Data>();
    data->nodes.resize(header.node_count);
    Unfilled<std::uint32_t> items(header.item_count);
    const std::byte* from = bytes.data() + sizeof(header);
    const std::size_t node_bytes = header.node_count * sizeof(kernel::WideNode);
    if (node_bytes > 0) std::memcpy(data->nodes.data(), from, node_bytes);
    if (!items.empty()) std::memcpy(items.data(), from + node_bytes, items.size() * sizeof(std::uint32_t));
    data->root = header.root;
    data->report = check_mesh(mesh);
    if (!TreeCheck(data->nodes, items).is_sound(data->root) || !holds_what_is_kept(items, mesh, data->report))
        return refuse("the saved tree contradicts itself");
    data->vertex_count = mesh.positions.size();
    data->can_refit = header.can_refit != 0;
    data->cost_when_built = header.cost_when_built;
    data->cost = header.cost;
    data->bounds = header.bounds;
    data->leaf_of_primitive.assign(mesh.triangles.size(), kNone);
    if (!fill_leaves(*data, items, mesh)) return refuse("the saved tree contradicts itself");
    return {std::make_shared<Blas>(std::move(data)), {}};
}

}  // namespace rc
