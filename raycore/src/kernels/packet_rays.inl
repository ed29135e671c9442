// kernels/packet_rays.inl - up to 64 rays side by side, eight to a vector, and the beam that holds them all.
//
// Lane by lane these are the numbers of ray_setup.inl, by the same operations in the same order, so that a ray meets
// the same triangles in a packet as alone. The beam is for inner nodes only: it may let boxes through that no ray
// meets, never the other way round.

namespace rc::kernel::RC_ISA {
namespace {

inline constexpr int kPacketRays = 64;
inline constexpr int kPacketGroups = kPacketRays / kWidth;

// The rays' hull along axis kz, on which all run the same way: at distance s along it they lie, on axis a, between
// low[a] + s * slope_low[a] and high[a] + s * slope_high[a], padding included.
struct Beam {
    float low[3], high[3], slope_low[3], slope_high[3];
    float s_min, s_max;
};

struct alignas(32) PacketRays {
    float origin[3][kPacketRays], direction[3][kPacketRays];
    float t_min[kPacketRays], t_max[kPacketRays];
    float rcp[3][kPacketRays], low_at_zero[3][kPacketRays], high_at_zero[3][kPacketRays];
    float s_min[kPacketRays], s_max[kPacketRays];
    float dz_abs[kPacketRays], s_pad[kPacketRays];
    float shear_x[kPacketRays], shear_y[kPacketRays];
    int n, groups;
    int kx, ky, kz;
    bool is_down;  // all run down axis kz
    Beam beam;
};

static inline float least_of(const float* values, int groups) {
    Float m = load(values);
    for (int g = 1; g < groups; ++g) m = min(m, load(values + kWidth * g));
    float lanes[kWidth];
    store(lanes, m);
    for (int i = 1; i < kWidth; ++i) lanes[0] = lanes[i] < lanes[0] ? lanes[i] : lanes[0];
    return lanes[0];
}
static inline float most_of(const float* values, int groups) {
    Float m = load(values);
    for (int g = 1; g < groups; ++g) m = max(m, load(values + kWidth * g));
    float lanes[kWidth];
    store(lanes, m);
    for (int i = 1; i < kWidth; ++i) lanes[0] = lanes[i] > lanes[0] ? lanes[i] : lanes[0];
    return lanes[0];
}

static inline void put_ray(PacketRays& rays, int lane, const float* origin, const float* direction,
                           float t_min, float t_max) {
    for (int a = 0; a < 3; ++a) {
        rays.origin[a][lane] = origin[a];
        rays.direction[a][lane] = direction[a];
    }
    rays.t_min[lane] = t_min;
    rays.t_max[lane] = t_max;
}

// The lanes behind the last ray copy it; they are switched off by aim_packet.
static inline void fill_up(PacketRays& rays, int n) {
    rays.n = n;
    rays.groups = (n + kWidth - 1) / kWidth;
    for (int lane = n; lane < kWidth * rays.groups; ++lane) {
        for (int a = 0; a < 3; ++a) {
            rays.origin[a][lane] = rays.origin[a][n - 1];
            rays.direction[a][lane] = rays.direction[a][n - 1];
        }
        rays.t_min[lane] = rays.t_min[n - 1];
        rays.t_max[lane] = rays.t_max[n - 1];
    }
}

// Whether all are fit to be asked, and run mostly along the same axis the same way: kz and is_down are found here.
static inline bool agree(PacketRays& rays) {
    std::uint32_t along_x = 0, along_y = 0, along_z = 0, down = 0, up = 0, good = 0xFF;
    const Float zero = splat(0.0f);
    for (int lane = 0; lane < kWidth * rays.groups; lane += kWidth) {
        Float finite = zero, d[3];
        for (int a = 0; a < 3; ++a) {
            const Float o = load(rays.origin[a] + lane);
            d[a] = load(rays.direction[a] + lane);
            finite = (finite + (o - o)) + (d[a] - d[a]);
        }
        const Float dx = absolute(d[0]), dy = absolute(d[1]), dz = absolute(d[2]);
        const std::uint32_t x_not_above_y = less_equal_bits(dx, dy);
        const std::uint32_t z_least = less_equal_bits(dx, dz) & less_equal_bits(dy, dz);  // of equals, z
        along_x |= ~x_not_above_y & ~z_least;
        along_y |= x_not_above_y & ~z_least;
        along_z |= z_least;
        const int k = (along_z & 0xFF) != 0 ? 2 : (along_y & 0xFF) != 0 ? 1 : 0;
        down |= ~less_equal_bits(zero, d[k]);
        up |= ~less_equal_bits(d[k], zero);
        good &= less_equal_bits(finite, zero) &
                less_equal_bits(load(rays.t_min + lane), load(rays.t_max + lane)) &
                less_equal_bits(zero, load(rays.t_min + lane)) &
                less_equal_bits(splat(0x1p-80f), absolute(d[k]));
    }
    const int axes = ((along_x & 0xFF) != 0) + ((along_y & 0xFF) != 0) + ((along_z & 0xFF) != 0);
    rays.kz = (along_z & 0xFF) != 0 ? 2 : (along_y & 0xFF) != 0 ? 1 : 0;
    rays.kx = kNextAxis[rays.kz];
    rays.ky = kNextAxis[rays.kx];
    rays.is_down = (down & 0xFF) != 0;
    return (axes == 1) & (good == 0xFF) & (((down & 0xFF) == 0) | ((up & 0xFF) == 0));
}

// ray_setup.inl's sharp_padding and wide_padding, eight at a time.
struct PacketPadding {
    bool is_sharp;
    float extra_pad;
};
static inline Float pad_of(const PacketPadding& padding, Float origin, Float reach, Float slope,
                           Float reach_z) {
    const Float least = splat(padding.extra_pad + kLeastPad);
    if (padding.is_sharp) return absolute(origin) * splat(0x1p-21f) + (reach_z * splat(0x1p-39f) + least);
    return ((absolute(origin) + reach) * splat(0x1p-21f) +
            (absolute(slope) * splat(0x1p-21f) + splat(0x1p-39f)) * reach_z) +
           least;
}

// What planes are moved by in shares of their distance: 2^-20, with room for the roundings of the beam.
inline constexpr float kNearer = 1.0f - 0x1p-19f, kFarther = 1.0f + 0x1p-19f;

// ray_setup.inl's aim, eight at a time. `t_max` is finite, `t_min` not negative.
static inline void aim_packet(PacketRays& rays, const TreeBounds& tree, const PacketPadding& padding) {
    alignas(32) float slope[3][kPacketRays], low[3][kPacketRays], high[3][kPacketRays];
    for (int lane = 0; lane < kWidth * rays.groups; lane += kWidth) {
        const Float dz = load(rays.direction[rays.kz] + lane), dz_abs = absolute(dz);
        Float o[3], reach[3];
        for (int a = 0; a < 3; ++a) {
            o[a] = load(rays.origin[a] + lane);
            reach[a] = max(absolute(splat(tree.min[a]) - o[a]), absolute(splat(tree.max[a]) - o[a]));
        }
        const Float reach_z = reach[rays.kz];
        for (int a = 0; a < 3; ++a) {
            const Float d = load(rays.direction[a] + lane), s = d / dz_abs;
            const Float pad = pad_of(padding, o[a], reach[a], s, reach_z);
            const Float rcp = with_sign_of(dz_abs / max(absolute(d), dz_abs * splat(0x1p-40f)), d);
            store(rays.rcp[a] + lane, rcp);
            store(rays.low_at_zero[a] + lane, (splat(0.0f) - (o[a] + pad)) * rcp);
            store(rays.high_at_zero[a] + lane, (splat(0.0f) - (o[a] - pad)) * rcp);
            // Twice the padding: the beam's own roundings are fewer than those that are padded already.
            store(low[a] + lane, o[a] - (pad + pad));
            store(high[a] + lane, o[a] + (pad + pad));
            store(slope[a] + lane, s);
        }
        store(rays.shear_x + lane, load(rays.direction[rays.kx] + lane) / dz);
        store(rays.shear_y + lane, load(rays.direction[rays.ky] + lane) / dz);
        store(rays.dz_abs + lane, dz_abs);
        const Float s_pad =
            padding.is_sharp ? splat(kLeastPad) : reach_z * splat(0x1p-21f) + splat(kLeastPad);
        store(rays.s_pad + lane, s_pad);
        const Float s_min = load(rays.t_min + lane) * dz_abs;
        store(rays.s_min + lane, max(s_min - (absolute(s_min) * splat(0x1p-21f) + s_pad), splat(-0x1p127f)));
        store(rays.s_max + lane, (load(rays.t_max + lane) * dz_abs) * splat(1.0f + 0x1p-21f) + s_pad);
    }
    for (int lane = rays.n; lane < kWidth * rays.groups; ++lane) rays.s_max[lane] = -__builtin_inff();
    // A ray may start s_pad before its origin, where the steepest is not the outermost.
    const float behind = 2.0f * most_of(rays.s_pad, rays.groups);
    for (int a = 0; a < 3; ++a) {
        rays.beam.low[a] = least_of(low[a], rays.groups) - behind;
        rays.beam.high[a] = most_of(high[a], rays.groups) + behind;
        rays.beam.slope_low[a] = least_of(slope[a], rays.groups) - 0x1p-19f;
        rays.beam.slope_high[a] = most_of(slope[a], rays.groups) + 0x1p-19f;
    }
    rays.beam.s_min = least_of(rays.s_min, rays.groups);
    rays.beam.s_max = most_of(rays.s_max, rays.groups);
}

// Brings s_max of some rays of a group to their t_max.
static inline void shorten(PacketRays& rays, int group, std::uint32_t which) {
    const int at = kWidth * group;
    const Float limit =
        (load(rays.t_max + at) * load(rays.dz_abs + at)) * splat(1.0f + 0x1p-21f) + load(rays.s_pad + at);
    store_where(rays.s_max + at, limit, which);
}

// The children the beam may meet, and how far away.
static inline std::uint32_t meet_beam(const WideNode& node, const PacketRays& rays, float near[kWidth]) {
    const Beam& beam = rays.beam;
    const int kz = rays.kz;
    const Float z_low = load(node.bounds[2 * kz]), z_high = load(node.bounds[2 * kz + 1]);
    Float enter, leave;
    if (rays.is_down) {
        enter = splat(beam.low[kz]) - z_high;
        leave = splat(beam.high[kz]) - z_low;
    } else {
        enter = z_low - splat(beam.high[kz]);
        leave = z_high - splat(beam.low[kz]);
    }
    enter = max(enter * splat(kNearer), splat(beam.s_min));
    leave = min(leave * splat(kFarther), splat(beam.s_max));
    std::uint32_t met = less_equal_bits(enter, leave);
    const int across[2] = {rays.kx, rays.ky};
    for (const int a : across) {
        const Float low = splat(beam.slope_low[a]), high = splat(beam.slope_high[a]);
        const Float from = splat(beam.low[a]) + min(low * enter, low * leave);
        const Float to = splat(beam.high[a]) + max(high * enter, high * leave);
        met &= less_equal_bits(from, load(node.bounds[2 * a + 1])) &
               less_equal_bits(load(node.bounds[2 * a]), to);
    }
    store(near, enter);
    return met;
}

// The rays of a group that meet the box of a lane.
static inline std::uint32_t meet_box(const WideNode& node, int lane, const PacketRays& rays, int group) {
    const int at = kWidth * group;
    Float enter = load(rays.s_min + at), leave = load(rays.s_max + at);
    for (int a = 0; a < 3; ++a) {
        const Float rcp = load(rays.rcp[a] + at);
        const Float low = about_fma(splat(node.bounds[2 * a][lane]), rcp, load(rays.low_at_zero[a] + at));
        const Float high =
            about_fma(splat(node.bounds[2 * a + 1][lane]), rcp, load(rays.high_at_zero[a] + at));
        enter = max(min(low, high) * splat(kNearer), enter);
        leave = min(max(low, high) * splat(kFarther), leave);
    }
    return less_equal_bits(enter, leave);
}

// Rays of a group against one triangle. m.met is 0 where none is met, and then nothing else means anything.
static inline void meet_triangle(const Leaf& leaf, std::uint32_t triangle, const PacketRays& rays, int group,
                                 std::uint32_t asked, Meetings& m) {
    const int at = kWidth * group;
    const Float ox = load(rays.origin[rays.kx] + at), oy = load(rays.origin[rays.ky] + at),
                oz = load(rays.origin[rays.kz] + at);
    const Float sx = load(rays.shear_x + at), sy = load(rays.shear_y + at);
    Corners c;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const float* corner = leaf.rows + 3 * i * leaf.count + triangle;
        c.z[i] = splat(corner[std::uint32_t(rays.kz) * leaf.count]) - oz;
        c.x[i] = (splat(corner[std::uint32_t(rays.kx) * leaf.count]) - ox) - sx * c.z[i];
        c.y[i] = (splat(corner[std::uint32_t(rays.ky) * leaf.count]) - oy) - sy * c.z[i];
    }
    m.met = maybe_bits(c) & asked;
    if (m.met != 0) decide(c, load(rays.direction[rays.kz] + at), m.met, m);
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
