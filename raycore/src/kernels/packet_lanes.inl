// kernels/packet_lanes.inl - what ClosestSink and AnySink do, for the rays of a packet side by side.

namespace rc::kernel::RC_ISA {
namespace {

// Which of a group lie within their limits.
static inline std::uint32_t within(const float* t_min, const float* t_limit, const Meetings& m) {
    return m.met & less_equal_bits(load(t_min), m.t) & less_equal_bits(m.t, load(t_limit));
}

struct ClosestLanes {
    using Alone = ClosestSink;
    alignas(64) float t_min[kPacketRays];
    float t_limit[kPacketRays];
    double weight1[kPacketRays], weight2[kPacketRays], weight_sum[kPacketRays];
    std::uint32_t primitive[kPacketRays], instance[kPacketRays];

    void begin(int at, Float from, Float to) {
        store(t_min + at, from);
        store(t_limit + at, to);
        store(primitive + at, splat(kNobody));
        store(instance + at, splat(kNobody));
    }
    // Of a group's meetings with a triangle; which rays' answers have changed.
    std::uint32_t take(int at, const Meetings& m, std::uint32_t instance_id, std::uint32_t id) {
        const Words instances = splat(instance_id), ids = splat(id);
        const std::uint32_t farther = less_equal_bits(load(t_limit + at), m.t);
        const std::uint32_t lower =
            above_bits(load(instance + at), instances) |
            (equal_bits(load(instance + at), instances) & above_bits(load(primitive + at), ids));
        const std::uint32_t taken = m.met & (~farther | lower);
        store_where(t_limit + at, m.t, taken);
        store_where(primitive + at, ids, taken);
        store_where(instance + at, instances, taken);
        store_where(weight1 + at, m.weight1, taken);
        store_where(weight2 + at, m.weight2, taken);
        store_where(weight_sum + at, m.weight_sum, taken);
        return taken;
    }
    // Of one ray's; whether its answer has changed.
    bool take(int i, const Candidate& c) {
        const bool lower =
            c.instance < instance[i] || (c.instance == instance[i] && c.primitive < primitive[i]);
        if (!(t_min[i] <= c.t && (c.t < t_limit[i] || (c.t == t_limit[i] && lower)))) return false;
        t_limit[i] = c.t;
        instance[i] = c.instance;
        primitive[i] = c.primitive;
        weight1[i] = c.weight1;
        weight2[i] = c.weight2;
        weight_sum[i] = c.weight_sum;
        return true;
    }
    // A ray as it would stand if it had walked alone, and back.
    ClosestSink alone(int i) const {
        return {t_min[i],
                t_limit[i],
                {t_limit[i], instance[i], primitive[i], weight1[i], weight2[i], weight_sum[i]}};
    }
    void put(int i, const ClosestSink& sink) {
        t_limit[i] = sink.t_limit;
        instance[i] = sink.best.instance;
        primitive[i] = sink.best.primitive;
        weight1[i] = sink.best.weight1;
        weight2[i] = sink.best.weight2;
        weight_sum[i] = sink.best.weight_sum;
    }
    // The answers of a group's rays in `which`, eight divisions at a time.
    template <class Answers>
    void write(const Answers& answers, std::uint64_t first, int at, std::uint64_t which) const {
        const std::uint32_t bits = std::uint32_t(which >> at) & 0xFFu;
        const Words ids = load(primitive + at);
        const Lanes miss = lanes_of(equal_bits(ids, splat(kNobody)));
        const Float zero = splat(0.0f);
        const Float t = where(miss, splat(__builtin_inff()), load(t_limit + at));
        const Float u = where(miss, zero, narrow(load(weight1 + at) / load(weight_sum + at)));
        const Float v = where(miss, zero, narrow(load(weight2 + at) / load(weight_sum + at)));
        HitOut some[kWidth];
        HitOut* out = bits == 0xFF ? answers.hits + first + std::uint64_t(at) : some;
        store_turned(out, sizeof(HitOut), t, u, v, as_floats(ids));
        for (int i = 0; i < kWidth; ++i) out[i].instance = instance[at + i];
        if (bits == 0xFF) return;
        for (std::uint32_t left = bits; left != 0; left &= left - 1) {
            const int i = __builtin_ctz(left);
            answers.hits[first + std::uint64_t(at + i)] = some[i];
        }
    }
};

struct AnyLanes {
    using Alone = AnySink;
    alignas(64) float t_min[kPacketRays];
    float t_limit[kPacketRays];
    std::uint64_t hit = 0;

    void begin(int at, Float from, Float to) {
        store(t_min + at, from);
        store(t_limit + at, to);
    }
    std::uint32_t take(int at, const Meetings& m, std::uint32_t, std::uint32_t) {
        hit |= std::uint64_t{m.met} << at;
        return m.met;
    }
    bool take(int i, const Candidate& c) {
        const bool is_met = (t_min[i] <= c.t) & (c.t <= t_limit[i]);
        hit |= std::uint64_t{is_met} << i;
        return is_met;
    }
    AnySink alone(int i) const { return {t_min[i], t_limit[i], (hit >> i & 1) != 0}; }
    void put(int i, const AnySink& sink) { hit |= std::uint64_t{sink.is_hit} << i; }
    template <class Answers>
    void write(const Answers& answers, std::uint64_t first, int at, std::uint64_t which) const {
        for (std::uint32_t left = std::uint32_t(which >> at) & 0xFFu; left != 0; left &= left - 1) {
            const int i = at + __builtin_ctz(left);
            answers.is_hit[first + std::uint64_t(i)] = std::uint8_t(hit >> i & 1);
        }
    }
};

}  // namespace
}  // namespace rc::kernel::RC_ISA
