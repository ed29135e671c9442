// kernels/sinks.inl - what each query does with a hit, and the kernel table of this ISA.

namespace rc::kernel::RC_ISA {
namespace {

// Keeps, of those that follow `after`, the nearest `capacity` in order. A primitive met twice (its pieces in two leaves)
// counts once.
struct CrossingsSink {
    static constexpr bool kIsAny = false;
    float t_min, t_limit;
    const HitOut* after;  // null: all
    HitOut* out;
    std::uint32_t capacity;
    std::uint32_t count = 0;

    static bool precedes(const HitOut& a, const HitOut& b) {
        if (a.t != b.t) return a.t < b.t;
        return a.instance != b.instance ? a.instance < b.instance : a.primitive < b.primitive;
    }

    void take(const Candidate& c) {
        const HitOut hit = to_hit(c);
        if (after != nullptr && !precedes(*after, hit)) return;
        std::uint32_t at = count;
        while (at > 0 && precedes(hit, out[at - 1])) --at;
        const bool known = at > 0 && !precedes(out[at - 1], hit);
        if (known || at == capacity) return;
        if (count < capacity) ++count;
        for (std::uint32_t i = count - 1; i > at; --i) out[i] = out[i - 1];
        out[at] = hit;
        if (count == capacity) t_limit = out[count - 1].t;
    }
};

struct HitAnswers {
    HitOut* hits;
    void write(std::uint64_t i, const ClosestSink& sink) const {
        const bool miss = sink.best.primitive == kNobody;
        hits[i] = miss ? HitOut{__builtin_inff(), 0.0f, 0.0f, kNobody, kNobody} : to_hit(sink.best);
    }
};
struct AnyAnswers {
    std::uint8_t* is_hit;
    void write(std::uint64_t i, const AnySink& sink) const { is_hit[i] = sink.is_hit; }
};

// One ray walks alone; of a batch those that run together are packets, the others a stream.
template <class Sink, class Lanes, class Answers>
static void ask(const SceneView& scene, const RayIn* rays, std::uint64_t n, std::uint32_t layers,
                const Answers& answers, Counts* counts) {
    Counts sum;
    if (n == 1 || scene.root == kEmptyTree) {
        for (std::uint64_t i = 0; i < n; ++i) {
            Sink sink;
            sink.begin(rays[i]);
            if (is_good(rays[i])) walk_scene(scene, rays[i], layers, sink, sum);
            answers.write(i, sink);
        }
    } else {
        ask_packets<Lanes>(scene, rays, n, layers, answers, sum);
    }
    if (counts != nullptr) *counts = sum;
}

static void closest(const SceneView& scene, const RayIn* rays, std::uint64_t n, std::uint32_t layers,
                    HitOut* hits, Counts* counts) {
    ask<ClosestSink, ClosestLanes, HitAnswers>(scene, rays, n, layers, {hits}, counts);
}

static void any(const SceneView& scene, const RayIn* rays, std::uint64_t n, std::uint32_t layers,
                std::uint8_t* is_hit, Counts* counts) {
    ask<AnySink, AnyLanes, AnyAnswers>(scene, rays, n, layers, {is_hit}, counts);
}

static std::uint32_t crossings(const SceneView& scene, const RayIn& ray, std::uint32_t layers,
                               const HitOut* after, HitOut* out, std::uint32_t capacity) {
    Counts sum;
    const float t_min = after != nullptr ? larger(ray.t_min, after->t) : ray.t_min;
    CrossingsSink sink{finite_start(t_min), finite_limit(ray.t_max), after, out, capacity};
    if (is_good(ray) && capacity > 0) walk_scene(scene, ray, layers, sink, sum);
    return sink.count;
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
