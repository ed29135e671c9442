// kernels/packet_ask.inl - a batch parted into packets and streams, and a packet's way through the instances.

namespace rc::kernel::RC_ISA {
namespace {

// A bundle is narrow, and its beam worth a look at nodes, while it opens by less than this a unit of distance, from a
// foot of less than this share of the tree.
inline constexpr float kNarrowSlope = 0.3f;
inline constexpr float kNarrowFoot = 0.05f;
// Rays that start farther from each other, in shares of the tree, have little in common.
inline constexpr float kWidestFoot = 0.25f;
inline constexpr int kLeastPacket = 16;     // rays of a batch
inline constexpr int kLeastInInstance = 8;  // of those, rays that meet the box of an instance that moved

static inline float size_of(const TreeBounds& tree) {
    float size = 0.0f;
    for (int a = 0; a < 3; ++a) size = larger(size, tree.max[a] - tree.min[a]);
    return size;
}
static inline float width_of(const Hull& hull) {
    return larger(hull.high[0] - hull.low[0], larger(hull.high[1] - hull.low[1], hull.high[2] - hull.low[2]));
}
static inline bool is_narrow(const PacketRays& rays, const TreeBounds& tree) {
    return rays.is_bundle && width_of(rays.slopes) <= kNarrowSlope &&
           width_of(rays.origins) <= kNarrowFoot * size_of(tree);
}

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
          layers_(layers),
          counts_(counts) {
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

    // Closest-hit rays that spread out soon have little in common but the topmost nodes, and wait less in a stream.
    static bool is_worth_it(const PacketRays& rays, const TreeBounds& tree) {
        if (__builtin_popcountll(rays.fit) < kLeastPacket) return false;
        return Alone::kIsAny ? width_of(rays.origins) <= kWidestFoot * size_of(tree) : is_narrow(rays, tree);
    }

    void begin_lanes() {
        for (int at = 0; at < n_; at += kWidth) {
            const EightRays rays = eight(at);
            lanes_.begin(at, rays.t_min, min(rays.t_max, splat(kLargest)));
        }
        for (int i = 0; i < n_; ++i) skips_any_ |= in_[i].skip_instance != kNobody;
        for (std::uint32_t& skip : instance_.skip) skip = kEmptyTree;
    }

    bool ask_instance() {
        const std::uint32_t id = scene_.root & ~kLeafBit;
        const InstanceView& instance = scene_.instances[id];
        if ((instance.layers & layers_) == 0 || (instance.blas.root & kLeafBit) != 0) return false;
        begin_lanes();
        enter(instance, ~std::uint64_t{0} >> (kPacketRays - n_), {instance.blas.min, instance.blas.max},
              outer_);
        if (!is_worth_it(outer_, {instance.blas.min, instance.blas.max})) return false;
        alive_ = outer_.fit;
        walk_inside(id, outer_, alive_);
        return true;
    }

    bool ask_instances() {
        begin_lanes();
        float farthest = 0.0f;
        for (int i = 0; i < n_; ++i)
            for (int a = 0; a < 3; ++a) farthest = larger(farthest, absolute(in_[i].origin[a]));
        const TreeBounds bounds{scene_.min, scene_.max};
        LaneHulls hulls;
        begin_aim(outer_, groups_);
        for (int at = 0; at < n_; at += kWidth) {
            EightRays rays = eight(at);
            const std::uint32_t fit = fit_bits(rays) & lanes_in(at);
            rays.t_max = load(lanes_.t_limit + at);
            aim_eight(outer_, at, rays, fit, bounds, {false, farthest * scene_.condition * 0x1p-20f}, hulls);
        }
        finish_aim(outer_, groups_, hulls);
        if (!is_worth_it(outer_, bounds)) return false;
        alive_ = outer_.fit;
        walk_packet<true, Alone::kIsAny>(
            places_of_scene(scene_), scene_.root, outer_, is_narrow(outer_, bounds), alive_, layers_, counts_,
            [&](std::uint32_t item, std::uint64_t rays) { meet_instance(item & ~kLeafBit, rays); });
        return true;
    }

    std::uint32_t lanes_in(int at) const { return at + kWidth <= n_ ? 0xFFu : (1u << (n_ - at)) - 1; }

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
            aim_eight(rays, at, local, fit, tree, {true, 0.0f}, hulls);
        }
        finish_aim(rays, groups_, hulls);
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
        walk_packet<false, Alone::kIsAny>(places_of_blas(blas.nodes, blas.leaves), blas.root, rays,
                                          is_narrow(rays, {blas.min, blas.max}), alive_, 0, counts_,
                                          [&](std::uint32_t item, std::uint64_t met) {
                                              counts_.leaves += std::uint64_t(__builtin_popcountll(met));
                                              leaves.test(leaf_at(blas.leaves, item), met);
                                          });
    }

    const SceneView& scene_;
    const RayIn* in_;
    int n_, groups_;
    std::uint32_t layers_;
    Counts& counts_;
    bool skips_any_ = false;
    std::uint64_t alive_ = 0;
    RayIn last_[kWidth];  // of the last group, whose last ray fills it up
    Lanes lanes_;
    PacketRays outer_, inner_;
    InstanceOfPacket instance_;
};

// The axis a ray runs along most, and which way.
static inline int heading(const RayIn& ray) {
    const float x = absolute(ray.direction[0]), y = absolute(ray.direction[1]),
                z = absolute(ray.direction[2]);
    const int of_two = x > y ? 0 : 1;
    const int axis = larger(x, y) > z ? of_two : 2;
    return 2 * axis + (ray.direction[axis] < 0.0f ? 1 : 0);
}

// A glance at four rays tells most crowds from bundles before all are laid side by side.
static inline bool may_run_together(const RayIn* rays, std::uint64_t n) {
    const int first = heading(rays[0]);
    return heading(rays[n / 3]) == first && heading(rays[2 * n / 3]) == first &&
           heading(rays[n - 1]) == first;
}

// A batch in packets where its rays start near each other, and in streams where they do not.
template <class Lanes, class Answers>
static void ask_packets(const SceneView& scene, const RayIn* rays, std::uint64_t n, std::uint32_t layers,
                        const Answers& answers, Counts& counts) {
    std::uint64_t waiting = 0;  // rays from here on are for the stream
    for (std::uint64_t first = 0; first < n; first += kPacketRays) {
        const std::uint64_t left = n - first, size = left < kPacketRays ? left : kPacketRays;
        if (size < kLeastPacket) break;
        if (!Lanes::Alone::kIsAny && !may_run_together(rays + first, size)) continue;
        Packet<Lanes, Answers> packet(scene, rays + first, int(size), layers, counts);
        if (!packet.ask(first, answers)) continue;
        add(counts, ask_stream<typename Lanes::Alone>(scene, rays, waiting, first, layers, answers));
        waiting = first + size;
    }
    add(counts, ask_stream<typename Lanes::Alone>(scene, rays, waiting, n, layers, answers));
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
