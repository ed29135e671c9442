// kernels/packet_lanes.inl - what ClosestSink and AnySink do, for the rays of a packet side by side.

namespace rc::kernel::RC_ISA {
namespace {

struct ClosestLanes {
    using Alone = ClosestSink;
    double weight1[kPacketRays], weight2[kPacketRays], weight_sum[kPacketRays];
    float u[kPacketRays], v[kPacketRays];
    std::uint32_t primitive[kPacketRays];

    // A tie at `limits` is taken by the lower id alone: kNobody lets every tie win, 0 none.
    void begin(int lane, std::uint32_t wins_below) { primitive[lane] = wins_below; }

    std::uint32_t take(int at, const Meetings& m, std::uint32_t id, float* limits) {
        const Words ids = splat(id);
        const std::uint32_t farther = less_equal_bits(load(limits + at), m.t);
        const std::uint32_t taken = m.met & (~farther | above_bits(load(primitive + at), ids));
        store_where(limits + at, m.t, taken);
        store_where(primitive + at, ids, taken);
        store_where(weight1 + at, m.weight1, taken);
        store_where(weight2 + at, m.weight2, taken);
        store_where(weight_sum + at, m.weight_sum, taken);
        return taken;
    }
    // What give() needs of a group, eight divisions at a time.
    void settle(int at) {
        store(u + at, narrow(load(weight1 + at) / load(weight_sum + at)));
        store(v + at, narrow(load(weight2 + at) / load(weight_sum + at)));
    }
    void give(int lane, float t, std::uint32_t instance, ClosestSink& sink) const {
        sink.t_limit = t;
        sink.best = {t, instance, primitive[lane], double(u[lane]), double(v[lane]), 0.0};
    }
};

struct AnyLanes {
    using Alone = AnySink;

    void begin(int, std::uint32_t) {}
    std::uint32_t take(int at, const Meetings& m, std::uint32_t, float* limits) {
        store_where(limits + at, splat(-__builtin_inff()), m.met);  // has seen enough
        return m.met;
    }
    void settle(int) {}
    void give(int, float, std::uint32_t, AnySink& sink) const {
        sink.is_hit = true;
        sink.t_limit = -__builtin_inff();
    }
};

}  // namespace
}  // namespace rc::kernel::RC_ISA
