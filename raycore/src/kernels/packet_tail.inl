// kernels/packet_tail.inl - where a packet has thinned out: each ray opens by itself what was kept for it, a step of each
// in turn.
//
// A node that is left to a few rays is waited for by a few rays. So it is kept on their own stacks, the nearest on top,
// until nothing is left that many share; then all of them go on at once, as in a stream (stream.inl), and fill each
// other's gaps.

namespace rc::kernel::RC_ISA {
namespace {

inline constexpr int kMostKept = 64;  // what can be kept for a ray

template <class Lanes>
class PacketTail {
    static constexpr bool kIsAny = Lanes::Alone::kIsAny;

  public:
    PacketTail(const BlasView& blas, PacketRays& rays, PacketLeaves<Lanes>& leaves,
               const std::uint64_t& alive, Counts& counts)
        : places_(places_of_blas(blas.nodes, blas.leaves)),
          blas_(blas),
          rays_(rays),
          leaves_(leaves),
          alive_(alive),
          counts_(counts) {
        for (std::uint8_t& bottom : bottom_) bottom = kMostKept + 1;
    }

    // False when there is no room left; then the packet has to open `item` itself.
    bool keep(std::uint32_t item, float near, std::uint64_t rays) {
        std::uint32_t lowest = kMostKept;
        for (std::uint64_t left = rays; left != 0; left &= left - 1) {
            const std::uint32_t bottom = bottom_[__builtin_ctzll(left)];
            lowest = bottom < lowest ? bottom : lowest;
        }
        if (lowest <= 1) return false;
        for (std::uint64_t left = rays; left != 0; left &= left - 1) {  // what comes first comes on top
            const int i = __builtin_ctzll(left), at = --bottom_[i];
            stacks_[i].item[at] = item;
            stacks_[i].near[at] = near;
        }
        kept_ |= rays;
        return true;
    }

    // Opens all that was kept.
    void walk() {
        int who[kPacketRays + 1], n = 0;
        for (std::uint64_t left = kept_ & alive_; left != 0; left &= left - 1) {
            const int i = __builtin_ctzll(left);
            RayStack& stack = stacks_[i];
            stack.item[bottom_[i] - 1] = kEmptyTree;
            stack.near[bottom_[i] - 1] = -__builtin_inff();
            top_[i] = kMostKept + 1;
            if constexpr (!kIsAny) top_[i] = trim(stack, bottom_[i], top_[i], rays_.s_max[i]);
            octant_[i] =
                std::uint8_t((rays_.near_rcp[0][i] < 0.0f ? 1 : 0) | (rays_.near_rcp[1][i] < 0.0f ? 2 : 0) |
                             (rays_.near_rcp[2][i] < 0.0f ? 4 : 0));
            item_[i] = stack.item[--top_[i]];
            who[n++] = i;
        }
        at_node_ = at_leaf_ = 0;
        queue(who, n);
        while (at_node_ + at_leaf_ > 0) {
            const int leaves = at_leaf_;  // those whose memory was asked for a pass ago
            open_nodes();
            test_leaves(leaves);
        }
    }

  private:
    struct RayStack {
        std::uint32_t item[kMostKept + kStackSize + kWidth];
        float near[kMostKept + kStackSize + kWidth];
    };

    // What boxes ask of a ray.
    Entrances enter(const WideNode& node, int i) const {
        const Octant& octant = kOctants.of[octant_[i]];
        Entrances e{splat(rays_.s_min[i]), splat(rays_.s_max[i])};
        const char* bounds = reinterpret_cast<const char*>(node.bounds);
        const auto row = [&](std::int64_t offset) {
            return load(reinterpret_cast<const float*>(bounds + offset));
        };
        for (int a = 0; a < 3; ++a) {
            e.enter = max(about_fma(row(octant.near_row[a]), splat(rays_.near_rcp[a][i]),
                                    splat(rays_.near_at_zero[a][i])),
                          e.enter);
            e.leave = min(
                about_fma(row(octant.far_row[a]), splat(rays_.far_rcp[a][i]), splat(rays_.far_at_zero[a][i])),
                e.leave);
        }
        return e;
    }

    void open_nodes() {
        const int n = at_node_;
        for (int k = 0; k < n; ++k) {
            const int i = node_rays_[k];
            const WideNode& node = places_.nodes[item_[i]];
            const Entrances e = enter(node, i);
            int top = top_[i];
            item_[i] = next_below<!kIsAny>(node, e, less_equal_bits(e.enter, e.leave), stacks_[i], top);
            top_[i] = top;
        }
        counts_.nodes += std::uint64_t(n);
        at_node_ = 0;
        queue(node_rays_, n);  // in a loop of its own: nobody waits for what was just written
    }

    // Puts rays into the queue of what they stand before; `from` may be the nodes' own. Those at their end drop out.
    void queue(const int* from, int n) {
        int nodes = at_node_, leaves = at_leaf_;
        for (int k = 0; k < n; ++k) {
            const int i = from[k];
            const std::uint32_t item = item_[i];
            prefetch<4>(places_, item);
            node_rays_[nodes] = leaf_rays_[leaves] = i;
            nodes += int(item >> 31) ^ 1;
            leaves += int(item >> 31) & int(item != kEmptyTree);
        }
        at_node_ = nodes;
        at_leaf_ = leaves;
    }

    // The first n of the queue.
    void test_leaves(int n) {
        int testing[kPacketRays + 1], who[kPacketRays + 1];
        std::uint32_t maybe[kPacketRays + 1];
        int n_maybe = 0;
        for (int k = 0; k < n; ++k) testing[k] = leaf_rays_[k];
        at_leaf_ -= n;
        for (int k = 0; k < at_leaf_; ++k) leaf_rays_[k] = leaf_rays_[k + n];
        for (int k = 0; k < n; ++k) {
            const int i = testing[k];
            const Leaf leaf = leaf_at(blas_.leaves, item_[i]);
            maybe[n_maybe] = filter(leaf, corners_of(leaf, triangle_ray(rays_, i)));
            who[n_maybe] = i;
            n_maybe += maybe[n_maybe] != 0;
        }
        counts_.leaves += std::uint64_t(n);
        for (int k = 0; k < n_maybe; ++k) {
            const int i = who[k];
            if (!leaves_.decide(leaf_at(blas_.leaves, item_[i]), maybe[k], i)) continue;
            top_[i] = kIsAny ? int(bottom_[i]) : trim(stacks_[i], bottom_[i], top_[i], rays_.s_max[i]);
        }
        for (int k = 0; k < n; ++k) item_[testing[k]] = stacks_[testing[k]].item[--top_[testing[k]]];
        queue(testing, n);
    }

    const Places places_;
    const BlasView& blas_;
    PacketRays& rays_;
    PacketLeaves<Lanes>& leaves_;
    const std::uint64_t& alive_;
    Counts& counts_;
    std::uint64_t kept_ = 0;
    int at_node_ = 0, at_leaf_ = 0;
    int node_rays_[kPacketRays + 1], leaf_rays_[kPacketRays + 1];
    std::uint32_t item_[kPacketRays];
    int top_[kPacketRays];
    std::uint8_t bottom_[kPacketRays], octant_[kPacketRays];
    RayStack stacks_[kPacketRays];
};

}  // namespace
}  // namespace rc::kernel::RC_ISA
