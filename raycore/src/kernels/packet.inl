// kernels/packet.inl - rays that run together walk together: a beam opens the nodes, its rays are asked at the leaves.

namespace rc::kernel::RC_ISA {
namespace {

// Where a packet pays: the beam stays narrower than this, per unit of distance and against the tree.
inline constexpr float kWidestSlope = 0.3f;
inline constexpr float kWidestFoot = 0.05f;
inline constexpr int kLeastPacket = 16;     // rays of a batch
inline constexpr int kLeastInInstance = 8;  // of those, rays that meet an instance's box

// Opens nodes from `root` down for a packet whose boxes are aimed, nearest first. at_leaf(parent, lane, item) may
// shorten rays and beam.
template <bool kIsTlas, class AtLeaf>
static inline void walk_beam(const Places& places, std::uint32_t root, const PacketRays& rays,
                             std::uint32_t layers, Counts& counts, const AtLeaf& at_leaf) {
    struct Entry {
        std::uint32_t node;
        std::int32_t lane;
        float near;
    };
    Entry stack[kStackSize];
    int top = 0;
    std::uint32_t item = root;
    for (;;) {
        const WideNode& node = places.nodes[item];
        ++counts.nodes;
        alignas(32) float near[kWidth];
        std::uint32_t met = meet_beam(node, rays, near);
        if constexpr (kIsTlas) met &= common_bits(load(node.layers), layers);
        for (const int base = top; met != 0; met &= met - 1) {
            const int lane = __builtin_ctz(met);
            if constexpr (!kIsTlas) prefetch<4>(places, node.child[lane]);
            int i = top++;  // insertion, farthest first
            for (; i > base && stack[i - 1].near < near[lane]; --i) stack[i] = stack[i - 1];
            stack[i] = {item, lane, near[lane]};
        }
        do {
            if (top == 0) return;
            const Entry& entry = stack[--top];
            if (entry.near > rays.beam.s_max) {
                item = kEmptyTree;
                continue;
            }
            const WideNode& parent = places.nodes[entry.node];
            item = parent.child[entry.lane];
            if (item & kLeafBit) at_leaf(parent, entry.lane, item);
        } while (item & kLeafBit);
    }
}

// Rays in an instance's frame, on their way through its tree.
template <class Lanes>
struct InstancePacket {
    PacketRays rays;
    std::uint32_t skip[kPacketRays];
    Lanes found;
    std::uint8_t ray_of[kPacketRays];  // which of the packet outside each lane is
    std::uint64_t taken;               // lanes whose answer has changed

    void walk(const BlasView& blas, Counts& counts) {
        const auto at_leaf = [&](const WideNode& parent, int lane, std::uint32_t item) {
            test_leaf(parent, lane, leaf_at(blas.leaves, item), counts);
        };
        walk_beam<false>(places_of_blas(blas.nodes, blas.leaves), blas.root, rays, 0, counts, at_leaf);
    }

  private:
    void test_leaf(const WideNode& parent, int lane, const Leaf& leaf, Counts& counts) {
        std::uint32_t met[kPacketGroups];
        int groups[kPacketGroups + 1], n = 0;
        for (int group = 0; group < rays.groups; ++group) {  // no branch: which are met can not be predicted
            met[group] = meet_box(parent, lane, rays, group);
            groups[n] = group;
            n += met[group] != 0;
        }
        counts.leaves += std::uint64_t(n);
        const std::uint64_t before = taken;
        bool is_shorter = false;
        for (int i = 0; i < n; ++i)
            for (std::uint32_t triangle = 0; triangle < leaf.count; ++triangle)
                is_shorter |= test_triangle(leaf, triangle, groups[i], met[groups[i]]);
        if (is_shorter | (before != taken)) rays.beam.s_max = most_of(rays.s_max, rays.groups);
    }

    bool test_triangle(const Leaf& leaf, std::uint32_t triangle, int group, std::uint32_t asked) {
        Meetings m;
        meet_triangle(leaf, triangle, rays, group, asked, m);
        if (m.met == 0) return false;
        const int at = kWidth * group;
        std::uint32_t primitive;
        __builtin_memcpy(&primitive, leaf.rows + 9 * leaf.count + triangle, sizeof(primitive));
        m.met &= less_equal_bits(load(rays.t_min + at), m.t) & less_equal_bits(m.t, load(rays.t_max + at)) &
                 ~equal_bits(load(skip + at), splat(primitive));
        const std::uint32_t changed = found.take(at, m, primitive, rays.t_max);
        taken |= std::uint64_t{changed} << at;
        shorten(rays, group, changed);
        return changed != 0;
    }
};

// Up to 64 rays of a batch that run together.
template <class Lanes, class Answers>
class Packet {
    using Alone = typename Lanes::Alone;

  public:
    Packet(const SceneView& scene, const RayIn* rays, std::uint32_t layers, Counts& counts)
        : scene_(scene), in_(rays), layers_(layers), counts_(counts) {}

    // False, and nothing asked, when the rays [first, first + n) do not run together well enough.
    bool ask(std::uint64_t first, int n, const Answers& answers) {
        in_ += first;
        for (int i = 0; i < n; ++i) {
            sinks_[i].begin(in_[i]);
            rays_.t_max[i] = sinks_[i].t_limit;
        }
        if (!(is_single_instance(scene_) ? ask_instance(n) : ask_instances(n))) return false;
        for (int i = 0; i < n; ++i) answers.write(first + std::uint64_t(i), sinks_[i]);
        return true;
    }

  private:
    bool ask_instance(int n) {
        const std::uint32_t id = scene_.root & ~kLeafBit;
        const InstanceView& instance = scene_.instances[id];
        const bool has_tree = (instance.layers & layers_) != 0 && (instance.blas.root & kLeafBit) == 0;
        if (!has_tree || !enter(instance, id, ~std::uint64_t{0} >> (kPacketRays - n))) return false;
        if (!is_narrow(inner_.rays, instance.blas.min, instance.blas.max)) return false;
        walk_inside(instance, id);
        return true;
    }

    bool ask_instances(int n) {
        float farthest = 0.0f;
        for (int i = 0; i < n; ++i) {
            put_ray(rays_, i, in_[i].origin, in_[i].direction, in_[i].t_min, rays_.t_max[i]);
            for (int a = 0; a < 3; ++a) farthest = larger(farthest, absolute(in_[i].origin[a]));
        }
        fill_up(rays_, n);
        if (!agree(rays_)) return false;
        aim_packet(rays_, {scene_.min, scene_.max}, {false, farthest * scene_.condition * 0x1p-20f});
        if (!is_narrow(rays_, scene_.min, scene_.max)) return false;
        walk_instances();
        return true;
    }

    static bool is_narrow(const PacketRays& rays, const float* tree_min, const float* tree_max) {
        float size = 0.0f, foot = 0.0f, slope = 0.0f;
        for (int a = 0; a < 3; ++a) {
            size = larger(size, tree_max[a] - tree_min[a]);
            foot = larger(foot, rays.beam.high[a] - rays.beam.low[a]);
            slope = larger(slope, rays.beam.slope_high[a] - rays.beam.slope_low[a]);
        }
        return (slope <= kWidestSlope) & (foot <= kWidestFoot * size);
    }

    void walk_instances() {
        const auto at_leaf = [&](const WideNode& parent, int lane, std::uint32_t item) {
            std::uint64_t met = 0;
            for (int group = 0; group < rays_.groups; ++group)
                met |= std::uint64_t{meet_box(parent, lane, rays_, group)} << (kWidth * group);
            if (met != 0) meet_instance(item & ~kLeafBit, met);
        };
        walk_beam<true>(places_of_scene(scene_), scene_.root, rays_, layers_, counts_, at_leaf);
    }

    void meet_instance(std::uint32_t id, std::uint64_t met) {
        const InstanceView& instance = scene_.instances[id];
        if ((instance.layers & layers_) == 0) return;
        const bool is_packet = (instance.blas.root & kLeafBit) == 0 &&
                               __builtin_popcountll(met) >= kLeastInInstance && enter(instance, id, met);
        if (is_packet) {
            walk_inside(instance, id);
        } else {
            for (std::uint64_t left = met; left != 0; left &= left - 1) {
                const int i = __builtin_ctzll(left);
                walk_instance(scene_, id, in_[i], sinks_[i], counts_);
                rays_.t_max[i] = sinks_[i].is_done() ? -__builtin_inff() : sinks_[i].t_limit;
            }
        }
        for (int group = 0; group < rays_.groups; ++group)
            shorten(rays_, group, std::uint32_t(met >> (kWidth * group)) & 0xFFu);
        rays_.beam.s_max = most_of(rays_.s_max, rays_.groups);
    }

    // False when the rays do not run together in the instance's frame.
    bool enter(const InstanceView& instance, std::uint32_t id, std::uint64_t met) {
        int n = 0;
        for (; met != 0; met &= met - 1) {
            const int i = __builtin_ctzll(met);
            float origin[4], direction[4];
            if (instance.is_identity) {
                __builtin_memcpy(origin, in_[i].origin, sizeof(in_[i].origin));
                __builtin_memcpy(direction, in_[i].direction, sizeof(in_[i].direction));
            } else {
                to_local(instance.local_from_world, in_[i], origin, direction);
            }
            put_ray(inner_.rays, n, origin, direction, in_[i].t_min, rays_.t_max[i]);
            inner_.ray_of[n] = std::uint8_t(i);
            ++n;
        }
        fill_up(inner_.rays, n);
        if (!agree(inner_.rays)) return false;
        for (int lane = 0; lane < kWidth * inner_.rays.groups; ++lane) {
            const int i = inner_.ray_of[lane < n ? lane : n - 1];
            inner_.skip[lane] = in_[i].skip_instance == id ? in_[i].skip_primitive : kEmptyTree;
            inner_.found.begin(lane, instance_of(sinks_[i]) < id ? 0 : kNobody);
        }
        inner_.taken = 0;
        aim_packet(inner_.rays, {instance.blas.min, instance.blas.max}, {true, 0.0f});
        return true;
    }

    void walk_inside(const InstanceView& instance, std::uint32_t id) {
        counts_.instances += std::uint64_t(inner_.rays.n);
        inner_.walk(instance.blas, counts_);
        for (int group = 0; group < inner_.rays.groups; ++group)
            if ((inner_.taken >> (kWidth * group) & 0xFF) != 0) inner_.found.settle(kWidth * group);
        for (std::uint64_t left = inner_.taken; left != 0; left &= left - 1) {
            const int lane = __builtin_ctzll(left), i = inner_.ray_of[lane];
            inner_.found.give(lane, inner_.rays.t_max[lane], id, sinks_[i]);
            rays_.t_max[i] = sinks_[i].t_limit;
        }
    }

    static std::uint32_t instance_of(const ClosestSink& sink) { return sink.best.instance; }
    static std::uint32_t instance_of(const AnySink&) { return kNobody; }

    const SceneView& scene_;
    const RayIn* in_;
    std::uint32_t layers_;
    Counts& counts_;
    PacketRays rays_;  // in the world; their t_max are the sinks' limits
    Alone sinks_[kPacketRays];
    InstancePacket<Lanes> inner_;
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

// A batch in packets where its rays run together, and in streams where they do not.
template <class Lanes, class Answers>
static void ask_packets(const SceneView& scene, const RayIn* rays, std::uint64_t n, std::uint32_t layers,
                        const Answers& answers, Counts& counts) {
    std::uint64_t waiting = 0;  // rays from here on are for the stream
    for (std::uint64_t first = 0; first < n; first += kPacketRays) {
        const std::uint64_t left = n - first, size = left < kPacketRays ? left : kPacketRays;
        if (size < kLeastPacket) break;
        if (!may_run_together(rays + first, size)) continue;
        Packet<Lanes, Answers> packet(scene, rays, layers, counts);
        if (!packet.ask(first, int(size), answers)) continue;
        add(counts, ask_stream<typename Lanes::Alone>(scene, rays, waiting, first, layers, answers));
        waiting = first + size;
    }
    add(counts, ask_stream<typename Lanes::Alone>(scene, rays, waiting, n, layers, answers));
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
