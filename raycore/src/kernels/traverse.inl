// kernels/traverse.inl - one ray's walk: from the top-level tree into instances, from their trees into triangle blocks.
//
// What is done with a hit is the sink's business (sinks.inl): the walk asks `sink.t_limit`, beyond which nothing
// matters, and hands every candidate within it to `sink.take`; a sink that only asks for any ends the walk.

namespace rc::kernel::RC_ISA {
namespace {

inline constexpr std::uint32_t kNobody = 0xFFFFFFFFu;

// Keeps the nearest; equal t keeps the lower instance, then the lower primitive.
struct ClosestSink {
    static constexpr bool kIsAny = false;  // the nearest children come first, and every candidate counts
    float t_min, t_limit;
    Candidate best;  // divided when the walk is over: nobody waits for u and v

    void begin(const RayIn& ray) {
        t_min = finite_start(ray.t_min);
        t_limit = finite_limit(ray.t_max);
        best.primitive = best.instance = kNobody;
    }
    void take(const Candidate& c) {
        const bool lower =
            c.instance < best.instance || (c.instance == best.instance && c.primitive < best.primitive);
        if (c.t < t_limit || lower) {
            best = c;
            t_limit = c.t;
        }
    }
    bool is_done() const { return false; }
};

struct AnySink {
    static constexpr bool kIsAny = true;
    float t_min, t_limit;
    bool is_hit;

    void begin(const RayIn& ray) {
        t_min = finite_start(ray.t_min);
        t_limit = finite_limit(ray.t_max);
        is_hit = false;
    }
    bool is_done() const { return is_hit; }
};

// A ray in a tree's own frame.
struct InstanceRay {
    LocalRay ray;
    BoxRay box;
    const WideNode* nodes;
    const float* leaves;
    std::uint32_t root;
    std::uint32_t instance;
    std::uint32_t skip;  // a primitive that is not met
};

static inline void stand_at_root(const SceneView& scene, std::uint32_t id, const RayIn& world,
                                 InstanceRay& local) {
    const BlasView& blas = scene.instances[id].blas;
    local.nodes = blas.nodes;
    local.leaves = blas.leaves;
    local.root = blas.root;
    local.instance = id;
    local.skip = id == world.skip_instance ? world.skip_primitive : kEmptyTree;
}

// False when the ray is not to be met there.
static inline bool enter_instance(const SceneView& scene, std::uint32_t id, const RayIn& world, float t_min,
                                  float t_limit, InstanceRay& local) {
    const InstanceView& instance = scene.instances[id];
    if (instance.is_identity) {
        shear(way_of(world), world.origin, world.direction, local.ray);
    } else {
        const Way way = to_local(instance.local_from_world, world);
        if (!is_way(way)) return false;  // its direction may have vanished, or something may have overflowed
        float origin[4], direction[4];
        __builtin_memcpy(origin, &way.origin, sizeof(origin));
        __builtin_memcpy(direction, &way.direction, sizeof(direction));
        shear(way, origin, direction, local.ray);
    }
    aim_at_boxes(local.ray, {instance.blas.min, instance.blas.max}, t_min, t_limit, local.box);
    stand_at_root(scene, id, world, local);
    return true;
}

// Makes a ray ready for the top-level tree.
static inline void enter_scene(const SceneView& scene, const RayIn& world, float t_min, float t_limit,
                               LocalRay& ray, BoxRay& box) {
    shear(way_of(world), world.origin, world.direction, ray);
    float farthest = 0.0f;
    for (int a = 0; a < 3; ++a) farthest = larger(farthest, absolute(world.origin[a]));
    // 2^-20: sixteen roundings, of which the way into the instance's frame and back to t can spend eleven.
    aim_at_instances(ray, {scene.min, scene.max}, farthest * scene.condition * 0x1p-20f, t_min, t_limit, box);
}

// Instances that stand in the world's own frame take the ray as it is, aimed at boxes that reach as far as the scene.
static inline bool takes_world_ray(const SceneView& scene, std::uint32_t id) {
    return scene.instances[id].is_identity;
}
static inline void aim_in_world(const SceneView& scene, const LocalRay& ray, float t_min, float t_limit,
                                BoxRay& box) {
    aim_at_boxes(ray, {scene.min, scene.max}, t_min, t_limit, box);
}

// Hands the lanes that are met to the sink, in their order.
template <class Sink>
static inline void take_lanes(const Leaf& leaf, const Meetings& m, std::uint32_t met, InstanceRay& local,
                              Sink& sink) {
    alignas(64) double weight1[kWidth], weight2[kWidth], weight_sum[kWidth];
    alignas(32) float t[kWidth];
    store(t, m.t);
    store(weight1, m.weight1);
    store(weight2, m.weight2);
    store(weight_sum, m.weight_sum);
    for (; met != 0; met &= met - 1) {
        const int lane = __builtin_ctz(met);
        if (!(t[lane] <= sink.t_limit)) continue;
        const std::uint32_t primitive = primitive_at(leaf, std::uint32_t(lane));
        sink.take({t[lane], local.instance, primitive, weight1[lane], weight2[lane], weight_sum[lane]});
    }
    local.box.s_max = s_limit(local.box, sink.t_limit);
}

// Those of a leaf's triangles that the filter let through. True when the sink has seen enough.
template <class Sink>
static inline bool test_side_by_side(const Leaf& leaf, const Corners& corners, std::uint32_t maybe,
                                     InstanceRay& local, Sink& sink) {
    Meetings m;
    decide(corners, splat(local.ray.dz), maybe, m);
    const std::uint32_t met = m.met & less_equal_bits(splat(sink.t_min), m.t) &
                              less_equal_bits(m.t, splat(sink.t_limit)) &
                              ~equal_bits(words_at(primitives_of(leaf)), splat(local.skip));
    if (met == 0) return false;
    if constexpr (Sink::kIsAny) {
        sink.is_hit = true;
    } else {
        take_lanes(leaf, m, met, local, sink);
    }
    return Sink::kIsAny;
}

// The same one lane after the other: hardly ever are there two. In a stream, which waits for nothing else, eight
// decisions at once would cost more than one.
template <class Sink>
static inline bool test_in_turn(const Leaf& leaf, std::uint32_t maybe, InstanceRay& local, Sink& sink) {
    for (; maybe != 0; maybe &= maybe - 1) {
        const auto lane = std::uint32_t(__builtin_ctz(maybe));
        Candidate candidate;
        const bool is_met = decide_one(leaf, lane, local.ray, candidate);
        candidate.primitive = primitive_at(leaf, lane);
        const bool is_within = (sink.t_min <= candidate.t) & (candidate.t <= sink.t_limit);
        if (!(is_met & is_within & (candidate.primitive != local.skip))) continue;
        if constexpr (Sink::kIsAny) {
            sink.is_hit = true;
            return true;
        } else {
            candidate.instance = local.instance;
            sink.take(candidate);
            local.box.s_max = s_limit(local.box, sink.t_limit);
        }
    }
    return false;
}

// A lone ray waits for the decision: less long for eight at once, where a register holds eight doubles.
template <class Sink>
static inline bool test_lanes(const Leaf& leaf, const Corners& corners, std::uint32_t maybe,
                              InstanceRay& local, Sink& sink) {
    if constexpr (kHasWideDoubles) return test_side_by_side(leaf, corners, maybe, local, sink);
    return test_in_turn(leaf, maybe, local, sink);
}

// Lanes that may be met.
static inline std::uint32_t filter(const Leaf& leaf, const Corners& corners) {
    return maybe_bits(corners) & triangle_bits(leaf);
}

template <class Sink>
static bool walk_tree(InstanceRay& local, Sink& sink, Counts& counts) {
    ++counts.instances;
    const SpreadRay ray = spread(local.box);
    const Places places = places_of_blas(local.nodes, local.leaves);
    Entry<Sink> stack[kEntries];
    Entry<Sink>* top = start(stack);
    std::uint32_t item = local.root;
    for (;;) {
        const float s_max = local.box.s_max;
        for (; !(item & kLeafBit); ++counts.nodes) {
            const WideNode& node = places.nodes[item];
            const Entrances e = enter_boxes(node, ray, s_max);
            const std::uint32_t met = less_equal_bits(e.enter, e.leave);
            item = met == 0 ? pop(top, s_max) : next_child<true>(places, node, e, met, top);
        }
        if (item == kEmptyTree) return false;
        ++counts.leaves;
        const Leaf leaf = leaf_at(local.leaves, item);
        const Corners corners = corners_of(leaf, local.ray);
        const std::uint32_t maybe = filter(leaf, corners);
        if (maybe != 0 && test_lanes(leaf, corners, maybe, local, sink)) return true;
        item = pop(top, local.box.s_max);
    }
}

template <class Sink>
static bool walk_instance(const SceneView& scene, std::uint32_t id, const RayIn& world, Sink& sink,
                          Counts& counts) {
    InstanceRay local;
    return enter_instance(scene, id, world, sink.t_min, sink.t_limit, local) &&
           walk_tree(local, sink, counts);
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
