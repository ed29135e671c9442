// kernels/packet_boxes.inl - the boxes of a node against the rays of a packet: all at once, eight at a time, or one by one.
//
// All at once is for throwing boxes out: it may let through what no ray meets, never the other way round.

namespace rc::kernel::RC_ISA {
namespace {

inline constexpr int kMany = 24;     // rays that are found in nearly all groups
inline constexpr int kOneByOne = 6;  // rays that are too few for groups

// Which rays of the packet meet each child.
struct ChildRays {
    std::uint64_t of[kWidth];
};

// Children that lie where the rays may meet something. near: how far at least they are from all origins, along the axis
// where that is most; no ray has gone farther along its own axis when it arrives.
static inline std::uint32_t meet_reach(const WideNode& node, const PacketRays& rays, float near[kWidth]) {
    std::uint32_t met = 0xFF;
    Float distance = splat(0.0f);
    for (int a = 0; a < 3; ++a) {
        const Float low = load(node.bounds[2 * a]), high = load(node.bounds[2 * a + 1]);
        met &=
            less_equal_bits(low, splat(rays.reach.high[a])) & less_equal_bits(splat(rays.reach.low[a]), high);
        distance = max(distance, max(low - splat(rays.origins.high[a]), splat(rays.origins.low[a]) - high));
    }
    distance = distance * splat(kNearer);
    store(near, distance);
    return met & less_equal_bits(distance, splat(rays.s_most));
}

// Children that the beam of a bundle meets, and how far along axis kz: at distance s the rays lie, on axis a, between
// origins.low[a] + s * slopes.low[a] and origins.high[a] + s * slopes.high[a].
static inline std::uint32_t meet_beam(const WideNode& node, const PacketRays& rays, float near[kWidth]) {
    const int kz = rays.kz;
    const Float z_low = load(node.bounds[2 * kz]), z_high = load(node.bounds[2 * kz + 1]);
    Float enter, leave;
    if (rays.up == 0) {
        enter = splat(rays.origins.low[kz]) - z_high;
        leave = splat(rays.origins.high[kz]) - z_low;
    } else {
        enter = z_low - splat(rays.origins.high[kz]);
        leave = z_high - splat(rays.origins.low[kz]);
    }
    enter = max(enter * splat(kNearer), splat(rays.s_least));
    leave = min(leave * splat(kFarther), splat(rays.s_most));
    std::uint32_t met = less_equal_bits(enter, leave);
    const int across[2] = {rays.kx, rays.ky};
    for (const int a : across) {
        const Float low = splat(rays.slopes.low[a]), high = splat(rays.slopes.high[a]);
        const Float from = splat(rays.origins.low[a]) + min(low * enter, low * leave);
        const Float to = splat(rays.origins.high[a]) + max(high * enter, high * leave);
        met &= less_equal_bits(from, load(node.bounds[2 * a + 1])) &
               less_equal_bits(load(node.bounds[2 * a]), to);
    }
    store(near, enter);
    return met;
}

// Rays of a group that meet the box of a lane.
static inline std::uint32_t meet_box(const WideNode& node, int lane, const PacketRays& rays, int at) {
    Float enter = load(rays.s_min + at), leave = load(rays.s_max + at);
    for (int a = 0; a < 3; ++a) {
        const Float near_rcp = load(rays.near_rcp[a] + at), far_rcp = load(rays.far_rcp[a] + at);
        const Float low = splat(node.bounds[2 * a][lane]), high = splat(node.bounds[2 * a + 1][lane]);
        const Lanes is_down = has_sign(near_rcp);
        enter = max(about_fma(where(is_down, high, low), near_rcp, load(rays.near_at_zero[a] + at)), enter);
        leave = min(about_fma(where(is_down, low, high), far_rcp, load(rays.far_at_zero[a] + at)), leave);
    }
    return less_equal_bits(enter, leave);
}

// Those of `asked` that meet the box of a lane.
static inline std::uint64_t meet_box(const WideNode& node, int lane, const PacketRays& rays,
                                     std::uint64_t asked) {
    std::uint64_t met = 0;
    if (__builtin_popcountll(asked) > kMany) {  // nearly all groups: no branch that could be guessed wrongly
        for (int at = 0; at < kPacketRays; at += kWidth)
            met |= std::uint64_t{meet_box(node, lane, rays, at)} << at;
        return met & asked;
    }
    for (std::uint64_t left = asked; left != 0;) {
        const int at = __builtin_ctzll(left) & -kWidth;
        met |= std::uint64_t{meet_box(node, lane, rays, at)} << at;
        left &= ~(std::uint64_t{0xFF} << at);
    }
    return met & asked;
}

// The same for all children, one ray after the other: for a few rays.
static inline std::uint32_t meet_children(const WideNode& node, const PacketRays& rays, std::uint64_t asked,
                                          ChildRays& met) {
    std::uint32_t any = 0;
    for (std::uint64_t& of : met.of) of = 0;
    for (std::uint64_t left = asked; left != 0; left &= left - 1) {
        const int i = __builtin_ctzll(left);
        const Entrances e = enter_boxes(node, spread(rays, i), rays.s_max[i]);
        const std::uint32_t children = less_equal_bits(e.enter, e.leave);
        any |= children;
        for (std::uint32_t child = children; child != 0; child &= child - 1)
            met.of[__builtin_ctz(child)] |= std::uint64_t{1} << i;
    }
    return any;
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
