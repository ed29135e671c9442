// kernels/packet_leaves.inl - a leaf's triangles and the rays of a packet: a triangle and eight rays of a bundle side by
// side, or a ray and eight triangles.

namespace rc::kernel::RC_ISA {
namespace {

// Rays of a bundle that are asked in groups at a leaf: fewer are scattered over too many.
inline constexpr int kFewInGroups = 16;

// A leaf's corners as a group of rays sees them, which must be a bundle's: each once, whoever shares it.
struct GroupCorners {
    Float x[kMaxCorners], y[kMaxCorners], z[kMaxCorners];
};
static inline void shear_corners(const Leaf& leaf, const PacketRays& rays, int at, GroupCorners& out) {
    const Float ox = load(rays.at_kx + at), oy = load(rays.at_ky + at), oz = load(rays.at_kz + at);
    const Float sx = load(rays.shear_x + at), sy = load(rays.shear_y + at);
    const float *at_x = row_of(leaf, rays.kx), *at_y = row_of(leaf, rays.ky), *at_z = row_of(leaf, rays.kz);
    for (std::uint32_t i = 0; i < leaf.corners; ++i) {
        const Float z = splat(at_z[i]) - oz;
        out.z[i] = z;
        out.x[i] = (splat(at_x[i]) - ox) - sx * z;
        out.y[i] = (splat(at_y[i]) - oy) - sy * z;
    }
}

// A group of rays against one triangle. m.met is 0 where none is met, and then nothing else means anything.
static inline void meet_triangle(const GroupCorners& corners, std::uint32_t half, Float dz,
                                 std::uint32_t asked, Meetings& m) {
    Corners c;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t corner = corner_of(half, i);
        c.x[i] = corners.x[corner];
        c.y[i] = corners.y[corner];
        c.z[i] = corners.z[corner];
    }
    m.met = maybe_bits(c) & asked;
    if (m.met != 0) decide(c, dz, m.met, m);
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
            if (!decide_one(leaf, lane, ray, candidate)) continue;
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
    bool test_groups(const Leaf& leaf, std::uint64_t asked) {
        bool is_shorter = false;
        const std::uint32_t triangles = triangle_bits(leaf);
        while (asked != 0) {
            const int at = __builtin_ctzll(asked) & -kWidth;
            std::uint32_t left = std::uint32_t(asked >> at) & 0xFFu, changed = 0;
            asked &= ~(std::uint64_t{0xFF} << at);
            GroupCorners corners;
            shear_corners(leaf, rays_, at, corners);
            for (std::uint32_t rest = triangles; rest != 0; rest &= rest - 1) {
                const auto triangle = std::uint32_t(__builtin_ctz(rest));
                const std::uint32_t taken = test_triangle(leaf, corners, triangle, at, left);
                changed |= taken;
                if constexpr (Lanes::Alone::kIsAny) left &= ~taken;
            }
            if (changed == 0) continue;
            is_shorter = true;
            settle(at, changed);
        }
        return is_shorter;
    }
    std::uint32_t test_triangle(const Leaf& leaf, const GroupCorners& corners, std::uint32_t triangle, int at,
                                std::uint32_t asked) {
        Meetings m;
        meet_triangle(corners, half_of(leaf, triangle), load(rays_.dz + at), asked, m);
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
            maybe[n] = filter(leaf, corners_of(leaf, triangle_ray(rays_, i)));
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
