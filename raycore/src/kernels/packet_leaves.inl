// kernels/packet_leaves.inl - a leaf's triangles and the rays of a packet: a triangle and eight rays of a bundle side by
// side, or a ray and eight triangles.

namespace rc::kernel::RC_ISA {
namespace {

// Rays of a bundle that are asked in groups at a leaf: fewer are scattered over too many.
inline constexpr int kFewInGroups = 16;

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
        const bool in_groups =
            rays_.is_narrow || (rays_.is_bundle && __builtin_popcountll(asked) > kFewInGroups);
        const bool is_shorter = in_groups ? test_groups(leaf, asked) : test_singly(leaf, asked);
        if (is_shorter && !Lanes::Alone::kIsAny) rays_.s_most = most_of(rays_.s_max, groups_);
    }

    // Ray i and the triangles the filter let through; whether its answer has changed.
    bool decide(const Leaf& leaf, std::uint32_t maybe, int i) {
        const TriangleRay ray = triangle_ray(rays_, i);
        bool has_changed = false;
        for (; maybe != 0; maybe &= maybe - 1) {
            const auto lane = std::uint32_t(__builtin_ctz(maybe));
            Candidate candidate;
            if (!decide_one(leaf.rows, leaf.count, lane, ray, candidate)) continue;
            candidate.primitive = primitive_at(leaf, lane);
            candidate.instance = instance_.id;
            if (candidate.primitive != instance_.skip[i]) has_changed |= lanes_.take(i, candidate);
        }
        if constexpr (Lanes::Alone::kIsAny) {
            alive_ &= ~(std::uint64_t{has_changed} << i);
        } else if (has_changed) {
            rays_.s_max[i] = lanes_.t_limit[i] * rays_.dz_abs[i] * (1.0f + 0x1p-21f) + rays_.s_pad[i];
        }
        return has_changed;
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
        for (int k = 0; k < n; ++k) is_shorter |= decide(leaf, maybe[k], who[k]);
        return is_shorter;
    }

    PacketRays& rays_;
    int groups_;
    const InstanceOfPacket& instance_;
    Lanes& lanes_;
    std::uint64_t& alive_;
};

}  // namespace
}  // namespace rc::kernel::RC_ISA
