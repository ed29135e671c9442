// kernels/packet_rays.inl - up to 64 rays of a batch side by side, eight to a vector, and what holds them all.
//
// Lane by lane these are the numbers of ray_setup.inl, by the same operations in the same order, so that a ray meets the
// same triangles in a packet as alone. Axes and signs may differ from lane to lane: they are chosen by lane.

namespace rc::kernel::RC_ISA {
namespace {

inline constexpr int kPacketRays = 64;  // a bit of a mask each
inline constexpr int kPacketGroups = kPacketRays / kWidth;

// A bundle is narrow, and its beam worth a look at nodes, while it opens by less than this a unit of distance, from a
// foot of less than this share of the tree.
inline constexpr float kNarrowSlope = 0.3f;
inline constexpr float kNarrowFoot = 0.05f;

struct Hull {
    float low[3], high[3];
};

// Rays in one frame, on their way through one tree.
struct alignas(64) PacketRays {
    float near_rcp[3][kPacketRays], far_rcp[3][kPacketRays];
    float near_at_zero[3][kPacketRays], far_at_zero[3][kPacketRays];
    float s_min[kPacketRays], s_max[kPacketRays], dz_abs[kPacketRays], s_pad[kPacketRays];
    float at_kx[kPacketRays], at_ky[kPacketRays], at_kz[kPacketRays];
    float shear_x[kPacketRays], shear_y[kPacketRays], dz[kPacketRays];
    std::uint32_t axis[kPacketRays];  // kz, the one a ray runs along most

    // Of the rays that are fit alone; padding included.
    std::uint64_t fit;            // which are
    std::uint64_t along[3], up;   // which run along an axis most, and which of them up it
    Hull origins, slopes, reach;  // reach: of all points where they may meet something
    float s_least, s_most;        // of s_min and s_max
    bool is_bundle, is_narrow;    // all run along axis kz, the same way
    int kx, ky, kz;
    int few;  // rays that are better off by themselves
};

// Eight rays as they are asked.
struct EightRays {
    Float origin[3], direction[3], t_min, t_max;
};

// ray_setup.inl's to_local, eight at a time.
static inline void to_local(const double (&m)[4][4], EightRays& rays) {
    Float origin[3], direction[3];
    for (int row = 0; row < 3; ++row) {
        const auto sum = [&](const Float v[3]) {
            return (splat(m[0][row]) * widen(v[0]) + splat(m[1][row]) * widen(v[1])) +
                   splat(m[2][row]) * widen(v[2]);
        };
        origin[row] = narrow(sum(rays.origin) + splat(m[3][row]));
        direction[row] = narrow(sum(rays.direction));
    }
    for (int a = 0; a < 3; ++a) {
        rays.origin[a] = origin[a];
        rays.direction[a] = direction[a];
    }
}

// Those that may walk in company: finite, on their way at a speed, from no point behind their origins.
static inline std::uint32_t fit_bits(const EightRays& rays) {
    const Float zero = splat(0.0f);
    Float finite = zero;
    for (int a = 0; a < 3; ++a)
        finite = (finite + (rays.origin[a] - rays.origin[a])) + (rays.direction[a] - rays.direction[a]);
    const Float size =
        max(absolute(rays.direction[0]), max(absolute(rays.direction[1]), absolute(rays.direction[2])));
    return less_equal_bits(finite, zero) & less_equal_bits(zero, rays.t_min) &
           less_equal_bits(rays.t_min, rays.t_max) & less_equal_bits(splat(0x1p-80f), size);
}

// ray_setup.inl's sharp_padding and wide_padding in a tree, eight at a time.
struct PacketPadding {
    TreeBounds tree;
    bool is_sharp;
    float extra_pad;
};
static inline Float pad_of(const PacketPadding& padding, Float origin, Float reach, Float reach_z) {
    const Float least = splat(padding.extra_pad + kLeastPad);
    if (padding.is_sharp) return absolute(origin) * splat(0x1p-21f) + (reach_z * splat(0x1p-39f) + least);
    return (absolute(origin) + reach) * splat(0x1p-21f) + (reach_z * splat(0x1p-21f + 0x1p-39f) + least);
}

// What planes are moved by in shares of their distance where all rays are asked at once: 2^-20, with room for the
// roundings of their hull.
inline constexpr float kNearer = 1.0f - 0x1p-19f, kFarther = 1.0f + 0x1p-19f;

// The hulls while they grow, lane by lane.
struct LaneHulls {
    Float low[3][3], high[3][3];  // origins, slopes, reach

    LaneHulls() {
        for (int h = 0; h < 3; ++h)
            for (int a = 0; a < 3; ++a) {
                low[h][a] = splat(__builtin_inff());
                high[h][a] = splat(-__builtin_inff());
            }
    }
    void grow(int hull, int axis, Lanes which, Float from, Float to) {
        low[hull][axis] = min(low[hull][axis], where(which, from, splat(__builtin_inff())));
        high[hull][axis] = max(high[hull][axis], where(which, to, splat(-__builtin_inff())));
    }
    Hull hull(int which) const {
        Hull hull;
        for (int a = 0; a < 3; ++a) {
            hull.low[a] = least_of(low[which][a]);
            hull.high[a] = 0.0f - least_of(splat(0.0f) - high[which][a]);
        }
        return hull;
    }
};

// What triangles ask of eight rays, and how far these go along their axes.
static inline void shear_eight(PacketRays& rays, int at, const EightRays& in, std::uint32_t fit) {
    const Float *o = in.origin, *d = in.direction;
    const Float dx = absolute(d[0]), dy = absolute(d[1]), dz_abs = absolute(d[2]);
    const Float of_two = max(dx, dy);
    const Lanes x_before_y = is_above(dx, dy), not_z = is_above(of_two, dz_abs);
    const auto pick = [&](auto x, auto y, auto z) { return where(not_z, where(x_before_y, x, y), z); };
    const Float dz = pick(d[0], d[1], d[2]);
    store(rays.shear_x + at, pick(d[1], d[2], d[0]) / dz);
    store(rays.shear_y + at, pick(d[2], d[0], d[1]) / dz);
    store(rays.dz + at, dz);
    store(rays.dz_abs + at, absolute(dz));
    store(rays.at_kx + at, pick(o[1], o[2], o[0]));
    store(rays.at_ky + at, pick(o[2], o[0], o[1]));
    store(rays.at_kz + at, pick(o[0], o[1], o[2]));
    store(rays.axis + at, pick(splat(0u), splat(1u), splat(2u)));
    const std::uint32_t z = less_equal_bits(of_two, dz_abs) & fit, y = less_equal_bits(dx, dy) & fit & ~z;
    rays.along[2] |= std::uint64_t{z} << at;
    rays.along[1] |= std::uint64_t{y} << at;
    rays.along[0] |= std::uint64_t{fit & ~z & ~y} << at;
    rays.up |= std::uint64_t{less_equal_bits(splat(0.0f), dz) & fit} << at;
}

// ray_setup.inl's aim, for the eight rays of `fit` at lane `at`; `t_max` is finite. Inlined by force: called, it spills and
// reloads the hulls for every eight rays.
__attribute__((always_inline)) static inline void aim_eight(PacketRays& rays, int at, const EightRays& in,
                                                            std::uint32_t fit, const PacketPadding& padding,
                                                            LaneHulls& hulls) {
    const TreeBounds& tree = padding.tree;
    shear_eight(rays, at, in, fit);
    rays.fit |= std::uint64_t{fit} << at;
    const Float dz_abs = load(rays.dz_abs + at), zero = splat(0.0f);
    Float reach[3];
    for (int a = 0; a < 3; ++a)
        reach[a] =
            max(absolute(splat(tree.min[a]) - in.origin[a]), absolute(splat(tree.max[a]) - in.origin[a]));
    const Float size_x = absolute(in.direction[0]), size_y = absolute(in.direction[1]);
    const Lanes not_z = is_above(max(size_x, size_y), absolute(in.direction[2]));
    const Float reach_z = where(not_z, where(is_above(size_x, size_y), reach[0], reach[1]), reach[2]);
    const Float s_pad = padding.is_sharp ? splat(kLeastPad) : reach_z * splat(0x1p-21f) + splat(kLeastPad);
    const Float s_min = in.t_min * dz_abs, s_end = in.t_max * dz_abs;
    const Lanes which = lanes_of(fit);
    store(rays.s_pad + at, where(which, s_pad, zero));
    store(rays.s_min + at, s_min - (absolute(s_min) * splat(0x1p-21f) + s_pad));
    store(rays.s_max + at, where(which, s_end * splat(1.0f + 0x1p-21f) + s_pad, splat(-__builtin_inff())));

    const Float spread = splat(padding.is_sharp ? 0x1p-20f : 0.0f), one = splat(1.0f);
    const Float s_clip = min(s_end, reach_z * splat(1.0f + 0x1p-18f));  // no tree is farther
    for (int a = 0; a < 3; ++a) {
        const Float o = in.origin[a], d = in.direction[a], slope = d / dz_abs;
        const Float pad = pad_of(padding, o, reach[a], reach_z), towards = with_sign_of(pad, d);
        const Float rcp = with_sign_of(dz_abs / max(absolute(d), dz_abs * splat(0x1p-40f)), d);
        const Float near_rcp = rcp * (one - spread), far_rcp = rcp * (one + spread);
        store(rays.near_rcp[a] + at, near_rcp);
        store(rays.far_rcp[a] + at, far_rcp);
        store(rays.near_at_zero[a] + at, (zero - (o + towards)) * near_rcp);
        store(rays.far_at_zero[a] + at, (zero - (o - towards)) * far_rcp);
        // Twice the padding: the hulls' own roundings are fewer than those that are padded already. And a ray may start
        // s_pad before its origin.
        const Float around = (pad + pad) + (s_pad + s_pad);
        hulls.grow(0, a, which, o - around, o + around);
        hulls.grow(1, a, which, slope - splat(0x1p-19f), slope + splat(0x1p-19f));
        const Float end = o + slope * s_clip, margin = around + s_clip * splat(0x1p-19f);
        hulls.grow(2, a, which, min(o, end) - margin, max(o, end) + margin);
    }
}

static inline float most_of(const float* values, int groups) {
    Float m = load(values);
    for (int g = 1; g < groups; ++g) m = max(m, load(values + kWidth * g));
    return 0.0f - least_of(splat(0.0f) - m);
}

// Before the first group is aimed: nobody is there.
static inline void begin_aim(PacketRays& rays, int groups) {
    rays.fit = rays.up = 0;
    for (std::uint64_t& along : rays.along) along = 0;
    for (int at = 0; at < kWidth * groups; at += kWidth) {
        store(rays.s_max + at, splat(-__builtin_inff()));
        store(rays.s_pad + at, splat(0.0f));
    }
}

static inline float width_of(const Hull& hull) {
    return larger(hull.high[0] - hull.low[0], larger(hull.high[1] - hull.low[1], hull.high[2] - hull.low[2]));
}
static inline float size_of(const TreeBounds& tree) {
    float size = 0.0f;
    for (int a = 0; a < 3; ++a) size = larger(size, tree.max[a] - tree.min[a]);
    return size;
}

// When all groups are aimed: what holds them all.
static inline void finish_aim(PacketRays& rays, int groups, const TreeBounds& tree, const LaneHulls& hulls) {
    rays.origins = hulls.hull(0);
    rays.slopes = hulls.hull(1);
    rays.reach = hulls.hull(2);
    rays.s_most = most_of(rays.s_max, groups);
    rays.kz = rays.along[2] != 0 ? 2 : rays.along[1] != 0 ? 1 : 0;
    rays.kx = kNextAxis[rays.kz];
    rays.ky = kNextAxis[rays.kx];
    rays.is_bundle = rays.along[rays.kz] == rays.fit && (rays.up == 0 || rays.up == rays.fit);
    rays.is_narrow = rays.is_bundle && width_of(rays.slopes) <= kNarrowSlope &&
                     width_of(rays.origins) <= kNarrowFoot * size_of(tree);
    rays.s_least = 0.0f - most_of(rays.s_pad, groups);
}

// Brings s_max of a group to new limits of t.
static inline void shorten(PacketRays& rays, int at, Float t_limit) {
    const Float s = (t_limit * load(rays.dz_abs + at)) * splat(1.0f + 0x1p-21f) + load(rays.s_pad + at);
    const Lanes which = lanes_of(std::uint32_t(rays.fit >> at) & 0xFFu);
    store(rays.s_max + at, where(which, s, splat(-__builtin_inff())));
}

// A ray of the packet as triangles and as boxes ask for it.
struct TriangleRay {
    int kx, ky, kz;
    float shear_x, shear_y, dz;
    float at_kx, at_ky, at_kz;
};
static inline TriangleRay triangle_ray(const PacketRays& rays, int i) {
    const int kz = int(rays.axis[i]), kx = kNextAxis[kz];
    return {kx,
            kNextAxis[kx],
            kz,
            rays.shear_x[i],
            rays.shear_y[i],
            rays.dz[i],
            rays.at_kx[i],
            rays.at_ky[i],
            rays.at_kz[i]};
}
static inline SpreadRay spread(const PacketRays& rays, int i) {
    constexpr std::int64_t kRow = sizeof(float) * kWidth;
    SpreadRay ray;
    for (int a = 0; a < 3; ++a) {
        ray.near_rcp[a] = splat(rays.near_rcp[a][i]);
        ray.far_rcp[a] = splat(rays.far_rcp[a][i]);
        ray.near_at_zero[a] = splat(rays.near_at_zero[a][i]);
        ray.far_at_zero[a] = splat(rays.far_at_zero[a][i]);
        const std::int64_t is_down = rays.near_rcp[a][i] < 0.0f ? 1 : 0;
        ray.near_row[a] = (2 * a + is_down) * kRow;
        ray.far_row[a] = (2 * a + 1 - is_down) * kRow;
    }
    ray.s_min = splat(rays.s_min[i]);
    return ray;
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
