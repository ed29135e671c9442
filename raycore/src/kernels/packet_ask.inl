// kernels/packet_ask.inl - a batch parted into packets and streams, and a packet's way through the instances.

namespace rc::kernel::RC_ISA {
namespace {

// Rays that start farther from each other, in shares of the tree, have little in common.
inline constexpr float kWidestFoot = 0.25f;
inline constexpr int kFewAny = 12, kFewClosest = 24;  // rays that are left to a node
inline constexpr int kLeastPacket = 16;               // rays of a batch
inline constexpr int kLeastInInstance = 12;  // of those, rays that meet the box of an instance that moved

// Up to 64 rays of a batch that start near each other.
template <class Lanes, class Answers>
class Packet {
    using Alone = typename Lanes::Alone;

  public:
    Packet(const SceneView& scene, const RayIn* rays, int n, std::uint32_t layers, Counts& counts)
        : scene_(scene),
          in_(rays),
          n_(n),
          groups_((n + kWidth - 1) / kWidth),
          counts_(counts),
          layers_(layers) {
        if (n % kWidth == 0) return;
        for (int i = groups_ * kWidth - kWidth; i < groups_ * kWidth; ++i)
            last_[i & (kWidth - 1)] = in_[i < n ? i : n - 1];
    }

    // False, and nothing asked, when the rays do not start near each other. `first` is where their answers go.
    bool ask(std::uint64_t first, const Answers& answers) {
        if (!(is_single_instance(scene_) ? ask_instance() : ask_instances())) return false;
        const std::uint64_t fit = outer_.fit, all = ~std::uint64_t{0} >> (kPacketRays - n_);
        for (int at = 0; at < n_; at += kWidth) lanes_.write(answers, first, at, fit);
        for (std::uint64_t left = all & ~fit; left != 0; left &= left - 1) {
            const auto i = std::uint64_t(__builtin_ctzll(left));
            Alone sink;
            sink.begin(in_[i]);
            if (is_good(in_[i])) walk_scene(scene_, in_[i], layers_, sink, counts_);
            answers.write(first + i, sink);
        }
        return true;
    }

  private:
    EightRays eight(int at) const {
        Float turned[kWidth];
        load_turned(at + kWidth <= n_ ? in_ + at : last_, sizeof(RayIn), turned);
        return {{turned[0], turned[1], turned[2]}, {turned[3], turned[4], turned[5]}, turned[6], turned[7]};
    }

    static bool start_together(const PacketRays& rays, const TreeBounds& tree) {
        return width_of(rays.origins) <= kWidestFoot * size_of(tree);
    }
    // How many rays a node must be left to for them to go on by themselves; a narrow bundle stays together. Rays that only
    // ask for any have no order to lose.
    static int few(const PacketRays& rays, const TreeBounds& tree) {
        if (rays.is_narrow) return 0;
        if (Alone::kIsAny) return kFewAny;
        return start_together(rays, tree) ? kFewClosest : kPacketRays;
    }

    void begin_skips() {
        for (int i = 0; i < n_; ++i) skips_any_ |= in_[i].skip_instance != kNobody;
        for (std::uint32_t& skip : instance_.skip) skip = kEmptyTree;
    }
    // A group as it is asked, with finite limits; which of it may walk in company is said first.
    EightRays begin_group(int at, std::uint32_t& fit) {
        EightRays rays = eight(at);
        fit = fit_bits(rays) & (at + kWidth <= n_ ? 0xFFu : (1u << (n_ - at)) - 1);
        rays.t_max = min(rays.t_max, splat(kLargest));
        lanes_.begin(at, rays.t_min, rays.t_max);
        return rays;
    }

    bool ask_instance() {
        const std::uint32_t id = scene_.root & ~kLeafBit;
        const InstanceView& instance = scene_.instances[id];
        if ((instance.layers & layers_) == 0 || (instance.blas.root & kLeafBit) != 0) return false;
        begin_skips();
        const TreeBounds tree{instance.blas.min, instance.blas.max};
        LaneHulls hulls;
        begin_aim(outer_, groups_);
        for (int at = 0; at < n_; at += kWidth) {
            std::uint32_t fit;
            EightRays rays = begin_group(at, fit);
            if (!instance.is_identity) {
                to_local(instance.local_from_world, rays);
                fit &= fit_bits(rays);
            }
            aim_eight(outer_, at, rays, fit, {tree, true, 0.0f}, hulls);
        }
        finish_aim(outer_, groups_, tree, hulls);
        outer_.few = few(outer_, tree);
        if (__builtin_popcountll(outer_.fit) < kLeastPacket) return false;
        alive_ = outer_.fit;
        walk_inside(id, outer_, alive_);
        return true;
    }

    bool ask_instances() {
        begin_skips();
        // Of finite numbers: a bad ray among them must not spoil what forgives the others.
        float farthest = 0.0f;
        for (int i = 0; i < n_; ++i) {
            for (const float at : in_[i].origin)
                if (absolute(at) <= kLargest) farthest = larger(farthest, absolute(at));
        }
        const TreeBounds bounds{scene_.min, scene_.max};
        LaneHulls hulls;
        begin_aim(outer_, groups_);
        for (int at = 0; at < n_; at += kWidth) {
            std::uint32_t fit;
            const EightRays rays = begin_group(at, fit);
            aim_eight(outer_, at, rays, fit, {bounds, false, farthest * scene_.condition * 0x1p-20f}, hulls);
        }
        finish_aim(outer_, groups_, bounds, hulls);
        if (__builtin_popcountll(outer_.fit) < kLeastPacket || !start_together(outer_, bounds)) return false;
        outer_.few = 0;
        alive_ = outer_.fit;
        walk_packet<true, Alone::kIsAny>(
            {places_of_scene(scene_), scene_.root, layers_}, outer_, alive_, counts_,
            [&](std::uint32_t item, std::uint64_t rays) { meet_instance(item & ~kLeafBit, rays); },
            [](std::uint32_t, float, std::uint64_t) { return false; });
        return true;
    }

    // Rays `asked`, made ready for a tree in the instance's frame.
    void enter(const InstanceView& instance, std::uint64_t asked, const TreeBounds& tree, PacketRays& rays) {
        LaneHulls hulls;
        begin_aim(rays, groups_);
        for (int at = 0; at < n_; at += kWidth) {
            const std::uint32_t bits = std::uint32_t(asked >> at) & 0xFFu;
            if (bits == 0) continue;
            EightRays local = eight(at);
            if (!instance.is_identity) to_local(instance.local_from_world, local);
            const std::uint32_t fit = fit_bits(local) & bits;
            local.t_max = load(lanes_.t_limit + at);
            aim_eight(rays, at, local, fit, {tree, true, 0.0f}, hulls);
        }
        finish_aim(rays, groups_, tree, hulls);
        rays.few = few(rays, tree);
    }

    void meet_instance(std::uint32_t id, std::uint64_t met) {
        const InstanceView& instance = scene_.instances[id];
        if ((instance.layers & layers_) == 0) return;
        std::uint64_t alone = met;
        const TreeBounds tree{instance.blas.min, instance.blas.max};
        if (__builtin_popcountll(met) >= kLeastInInstance && (instance.blas.root & kLeafBit) == 0) {
            enter(instance, met, tree, inner_);
            alone &= ~inner_.fit;
            walk_inside(id, inner_, met & inner_.fit);
        }
        for (; alone != 0; alone &= alone - 1) {
            const int i = __builtin_ctzll(alone);
            Alone sink = lanes_.alone(i);
            walk_instance(scene_, id, in_[i], sink, counts_);
            lanes_.put(i, sink);
            if (sink.is_done()) alive_ &= ~(std::uint64_t{1} << i);
        }
        if constexpr (!Alone::kIsAny) {
            for (int at = 0; at < n_; at += kWidth) shorten(outer_, at, load(lanes_.t_limit + at));
            outer_.s_most = most_of(outer_.s_max, groups_);
        }
    }

    void walk_inside(std::uint32_t id, PacketRays& rays, std::uint64_t asked) {
        const BlasView& blas = scene_.instances[id].blas;
        counts_.instances += std::uint64_t(__builtin_popcountll(asked));
        instance_.id = id;
        for (int i = 0; i < n_ && skips_any_; ++i)
            instance_.skip[i] = in_[i].skip_instance == id ? in_[i].skip_primitive : kEmptyTree;
        PacketLeaves<Lanes> leaves(rays, groups_, instance_, lanes_, alive_);
        PacketTail<Lanes> tail(blas, rays, leaves, alive_, counts_);
        walk_packet<false, Alone::kIsAny>(
            {places_of_blas(blas.nodes, blas.leaves), blas.root, 0}, rays, alive_, counts_,
            [&](std::uint32_t item, std::uint64_t met) {
                counts_.leaves += std::uint64_t(__builtin_popcountll(met));
                leaves.test(leaf_at(blas.leaves, item), met);
            },
            [&](std::uint32_t item, float near, std::uint64_t met) { return tail.keep(item, near, met); });
        tail.walk();
    }

    PacketRays outer_, inner_;
    Lanes lanes_;
    InstanceOfPacket instance_;
    RayIn last_[kWidth];  // of the last group, whose last ray fills it up
    const SceneView& scene_;
    const RayIn* in_;
    int n_, groups_;
    Counts& counts_;
    std::uint64_t alive_ = 0;
    std::uint32_t layers_;
    bool skips_any_ = false;
};

// A batch in packets where its rays start near each other, and in streams where they do not.
template <class Lanes, class Answers>
static void ask_packets(const SceneView& scene, const RayIn* rays, std::uint64_t n, std::uint32_t layers,
                        const Answers& answers, Counts& counts) {
    std::uint64_t waiting = 0;  // rays from here on are for the stream
    for (std::uint64_t first = 0; first < n; first += kPacketRays) {
        const std::uint64_t left = n - first, size = left < kPacketRays ? left : kPacketRays;
        if (size < kLeastPacket) break;
        Packet<Lanes, Answers> packet(scene, rays + first, int(size), layers, counts);
        if (!packet.ask(first, answers)) continue;
        add(counts, ask_stream<typename Lanes::Alone>(scene, rays, waiting, first, layers, answers));
        waiting = first + size;
    }
    add(counts, ask_stream<typename Lanes::Alone>(scene, rays, waiting, n, layers, answers));
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
