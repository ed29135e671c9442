// kernels/packet.inl - rays that start near each other walk together: a node's boxes are asked for all of them at once,
// for eight at a time, or for the few that are left.
//
// Any order of asking gives the same answers. Together they wait for a node once, and throw most of its boxes out once.

namespace rc::kernel::RC_ISA {
namespace {

inline constexpr int kFew = 3;  // rays that are asked one by one

// What is still to be opened: a child, for whom, and where its box is.
struct PacketEntry {
    std::uint64_t rays;
    std::uint32_t item, parent, lane;
    float near;
};

// The children of a node that some of `asked` may meet. A narrow bundle's rays meet what its beam meets, near enough.
template <bool kIsTlas>
static inline std::uint32_t meet_node(const WideNode& node, const PacketRays& rays, bool is_narrow,
                                      std::uint64_t asked, std::uint32_t layers, float near[kWidth],
                                      ChildRays& met) {
    std::uint32_t children = is_narrow ? meet_beam(node, rays, near) : meet_reach(node, rays, near);
    if constexpr (kIsTlas) children &= common_bits(load(node.layers), layers);
    if (is_narrow) {
        for (std::uint64_t& of : met.of) of = asked;
        return children;
    }
    if (__builtin_popcountll(asked) <= kFew) return meet_children(node, rays, asked, met) & children;
    for (std::uint32_t left = children; left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        met.of[lane] = meet_box(node, lane, rays, asked);
        children ^= std::uint32_t{met.of[lane] == 0} << lane;
    }
    return children;
}

// Opens nodes from `root` down, nearest first; an any-hit walk takes the highest lane, the likeliest to end it.
// at_leaf(item, rays) may shorten rays and take some out of `alive`.
template <bool kIsTlas, bool kIsAny, class AtLeaf>
static inline void walk_packet(const Places& places, std::uint32_t root, const PacketRays& rays,
                               bool is_narrow, const std::uint64_t& alive, std::uint32_t layers,
                               Counts& counts, const AtLeaf& at_leaf) {
    PacketEntry stack[kStackSize + kWidth];
    stack[0] = {rays.fit, root, 0, 0, -__builtin_inff()};
    for (int top = 1; top > 0;) {
        const PacketEntry entry = stack[--top];
        std::uint64_t asked = entry.rays & alive;
        if ((asked == 0) | (entry.near > rays.s_most)) continue;
        if (entry.item & kLeafBit) {
            if (is_narrow || !kIsAny)
                asked = meet_box(places.nodes[entry.parent], int(entry.lane), rays, asked);
            if (asked != 0) at_leaf(entry.item, asked);
            continue;
        }
        const WideNode& node = places.nodes[entry.item];
        ++counts.nodes;
        alignas(32) float near[kWidth];
        ChildRays met;
        std::uint32_t children = meet_node<kIsTlas>(node, rays, is_narrow, asked, layers, near, met);
        for (const int base = top; children != 0; children &= children - 1) {
            const int lane = __builtin_ctz(children);
            if constexpr (!kIsTlas) prefetch<4>(places, node.child[lane]);
            int i = top++;
            if constexpr (!kIsAny)
                for (; i > base && stack[i - 1].near < near[lane]; --i) stack[i] = stack[i - 1];
            stack[i] = {met.of[lane], node.child[lane], entry.item, std::uint32_t(lane), near[lane]};
        }
    }
}

// A group of rays against one triangle, which must be a bundle's. m.met is 0 where none is met, and then nothing else
// means anything.
static inline void meet_triangle(const Leaf& leaf, std::uint32_t triangle, const PacketRays& rays, int at,
                                 std::uint32_t asked, Meetings& m) {
    const Float ox = load(rays.at_kx + at), oy = load(rays.at_ky + at), oz = load(rays.at_kz + at);
    const Float sx = load(rays.shear_x + at), sy = load(rays.shear_y + at);
    Corners c;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const float* corner = leaf.rows + 3 * i * leaf.count + triangle;
        c.z[i] = splat(corner[std::uint32_t(rays.kz) * leaf.count]) - oz;
        c.x[i] = (splat(corner[std::uint32_t(rays.kx) * leaf.count]) - ox) - sx * c.z[i];
        c.y[i] = (splat(corner[std::uint32_t(rays.ky) * leaf.count]) - oy) - sy * c.z[i];
    }
    m.met = maybe_bits(c) & asked;
    if (m.met != 0) decide(c, load(rays.dz + at), m.met, m);
}

// Whom rays ask about in a leaf's tree.
struct InstanceOfPacket {
    std::uint32_t id;
    std::uint32_t skip[kPacketRays];
};

// The leaves of one tree, for rays in its frame.
template <class Lanes>
class PacketLeaves {
  public:
    PacketLeaves(PacketRays& rays, int groups, const InstanceOfPacket& instance, Lanes& lanes,
                 std::uint64_t& alive)
        : rays_(rays), groups_(groups), instance_(instance), lanes_(lanes), alive_(alive) {}

    void test(const Leaf& leaf, std::uint64_t asked) {
        const bool is_shorter = rays_.is_bundle ? test_groups(leaf, asked) : test_singly(leaf, asked);
        if (is_shorter && !Lanes::Alone::kIsAny) rays_.s_most = most_of(rays_.s_max, groups_);
    }

  private:
    static std::uint32_t primitive_at(const Leaf& leaf, std::uint32_t lane) {
        std::uint32_t primitive;
        __builtin_memcpy(&primitive, leaf.rows + 9 * leaf.count + lane, sizeof(primitive));
        return primitive;
    }

    bool test_groups(const Leaf& leaf, std::uint64_t asked) {
        bool is_shorter = false;
        while (asked != 0) {
            const int at = __builtin_ctzll(asked) & -kWidth;
            std::uint32_t left = std::uint32_t(asked >> at) & 0xFFu, changed = 0;
            asked &= ~(std::uint64_t{0xFF} << at);
            for (std::uint32_t triangle = 0; triangle < leaf.count; ++triangle) {
                const std::uint32_t taken = test_triangle(leaf, triangle, at, left);
                changed |= taken;
                if constexpr (Lanes::Alone::kIsAny) left &= ~taken;
            }
            if (changed == 0) continue;
            is_shorter = true;
            settle(at, changed);
        }
        return is_shorter;
    }
    std::uint32_t test_triangle(const Leaf& leaf, std::uint32_t triangle, int at, std::uint32_t asked) {
        Meetings m;
        meet_triangle(leaf, triangle, rays_, at, asked, m);
        if (m.met == 0) return 0;
        const std::uint32_t primitive = primitive_at(leaf, triangle);
        m.met = within(lanes_.t_min + at, lanes_.t_limit + at, m) &
                ~equal_bits(load(instance_.skip + at), splat(primitive));
        return lanes_.take(at, m, instance_.id, primitive);
    }
    void settle(int at, std::uint32_t changed) {
        if constexpr (Lanes::Alone::kIsAny) {
            alive_ &= ~(std::uint64_t{changed} << at);
        } else {
            shorten(rays_, at, load(lanes_.t_limit + at));
        }
    }

    // Rays along several axes: a leaf's triangles side by side, for one ray after the other.
    bool test_singly(const Leaf& leaf, std::uint64_t asked) {
        std::uint32_t maybe[kPacketRays];
        std::int32_t who[kPacketRays];
        int n = 0;
        for (; asked != 0; asked &= asked - 1) {  // no branch on what is met: it can not be predicted
            const int i = __builtin_ctzll(asked);
            maybe[n] = filter(leaf, corners_of(leaf.rows, leaf.count, triangle_ray(rays_, i)));
            who[n] = i;
            n += maybe[n] != 0;
        }
        bool is_shorter = false;
        for (int k = 0; k < n; ++k) is_shorter |= decide_leaf(leaf, maybe[k], who[k]);
        return is_shorter;
    }
    bool decide_leaf(const Leaf& leaf, std::uint32_t maybe, int i) {
        InstanceRay local;  // what test_lanes asks of it
        const TriangleRay ray = triangle_ray(rays_, i);
        local.ray.dz = ray.dz;
        local.skip = instance_.skip[i];
        local.instance = instance_.id;
        local.box.dz_abs = rays_.dz_abs[i];
        local.box.s_pad = rays_.s_pad[i];
        local.box.s_max = rays_.s_max[i];
        auto sink = lanes_.alone(i);
        const float limit = sink.t_limit;
        const bool is_done = test_lanes(leaf, corners_of(leaf.rows, leaf.count, ray), maybe, local, sink);
        lanes_.put(i, sink);
        if constexpr (Lanes::Alone::kIsAny) {
            alive_ &= ~(std::uint64_t{is_done} << i);
            return is_done;
        } else {
            if (sink.t_limit == limit) return false;
            rays_.s_max[i] = local.box.s_max;
            return true;
        }
    }

    PacketRays& rays_;
    int groups_;
    const InstanceOfPacket& instance_;
    Lanes& lanes_;
    std::uint64_t& alive_;
};

}  // namespace
}  // namespace rc::kernel::RC_ISA
