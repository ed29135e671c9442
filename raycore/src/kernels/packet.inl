// kernels/packet.inl - rays that start near each other walk together: a node's boxes are asked for all of them at once,
// for eight at a time, or for the few that are left.
//
// Any order of asking gives the same answers. Together they wait for a node once, and throw most of its boxes out once.

namespace rc::kernel::RC_ISA {
namespace {

// What is still to be opened: a child, for whom, and where its box is.
struct PacketEntry {
    std::uint64_t rays;
    std::uint32_t item, parent, lane;
    float near;
};

// The children of a node that some of `asked` may meet. A narrow bundle's rays meet what its beam meets, near enough.
template <bool kIsTlas>
static inline std::uint32_t meet_node(const WideNode& node, const PacketRays& rays, std::uint64_t asked,
                                      std::uint32_t layers, float near[kWidth], ChildRays& met) {
    std::uint32_t children = rays.is_bundle ? meet_beam(node, rays, near) : 0xFF;
    if (!rays.is_narrow) children &= meet_reach(node, rays, near);
    if constexpr (kIsTlas) children &= common_bits(load(node.layers), layers);
    if (rays.is_narrow) {
        for (std::uint64_t& of : met.of) of = asked;
        return children;
    }
    if (__builtin_popcountll(asked) <= kOneByOne) return meet_children(node, rays, asked, met) & children;
    for (std::uint32_t left = children; left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        met.of[lane] = meet_box(node, lane, rays, asked);
        children ^= std::uint32_t{met.of[lane] == 0} << lane;
    }
    return children;
}

// Where a packet walks.
struct PacketTree {
    Places places;
    std::uint32_t root;
    std::uint32_t layers;  // of a top level
};

// Opens nodes from the root down, nearest first; an any-hit walk takes the highest lane, the likeliest to end it.
// at_leaf(item, rays) may shorten rays and take some out of `alive`;
// keep(node, near, rays) may put off what is left to few.
template <bool kIsTlas, bool kIsAny, class AtLeaf, class Keep>
static inline void walk_packet(const PacketTree& tree, const PacketRays& rays, const std::uint64_t& alive,
                               Counts& counts, const AtLeaf& at_leaf, const Keep& keep) {
    const Places& places = tree.places;
    PacketEntry stack[kStackSize + kWidth];
    stack[0] = {rays.fit, tree.root, 0, 0, -__builtin_inff()};
    for (int top = 1; top > 0;) {
        const PacketEntry& entry = stack[--top];
        const std::uint32_t item = entry.item;
        std::uint64_t asked = entry.rays & alive;
        if ((asked == 0) | (entry.near > rays.s_most)) continue;
        if ((item & kLeafBit) != 0) {
            if (rays.is_narrow || !kIsAny)
                asked = meet_box(places.nodes[entry.parent], int(entry.lane), rays, asked);
            if (asked != 0) at_leaf(item, asked);
            continue;
        }
        if (__builtin_popcountll(asked) <= rays.few && keep(item, entry.near, asked)) continue;
        const WideNode& node = places.nodes[item];
        ++counts.nodes;
        alignas(32) float near[kWidth];
        ChildRays met;
        std::uint32_t children = meet_node<kIsTlas>(node, rays, asked, tree.layers, near, met);
        for (const int base = top; children != 0; children &= children - 1) {
            const int lane = __builtin_ctz(children);
            if constexpr (!kIsTlas) prefetch<4>(places, node.child[lane]);
            int i = top++;
            if constexpr (!kIsAny)
                for (; i > base && stack[i - 1].near < near[lane]; --i) stack[i] = stack[i - 1];
            stack[i] = {met.of[lane], node.child[lane], item, std::uint32_t(lane), near[lane]};
        }
    }
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
