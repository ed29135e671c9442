// kernels/traverse.inl - the walk: from the top-level tree into instances, from their trees into triangle blocks.
//
// What is done with a hit is the sink's business (sinks.inl): the walk asks `sink.t_limit`, beyond which nothing
// matters, and hands every candidate within it to `sink.take`, which says whether to stop.

namespace rc::kernel::RC_ISA {

struct StackEntry {
    std::uint32_t item;
    float near;
};

// Where the ray enters the boxes it meets, as bits and distances.
static inline std::uint32_t meet_boxes(const WideNode& node, const BoxRay& box, float near[kWidth]) {
    Float enter = splat(box.s_min), leave = splat(box.s_max);
    const char* bounds = reinterpret_cast<const char*>(node.bounds);
    const auto row = [&](std::int32_t offset) {
        return load(reinterpret_cast<const float*>(bounds + offset));
    };
    for (int a = 0; a < 3; ++a) {
        enter = max(about_fma(row(box.near_row[a]), box.slope_rcp[a], box.near_at_zero[a]), enter);
        leave = min(about_fma(row(box.far_row[a]), box.slope_rcp[a], box.far_at_zero[a]), leave);
    }
    store(near, enter);
    return less_equal_bits(enter, leave);
}

// Asks for a child's memory before it is its turn: nodes and leaves of a large scene are a cache miss each.
static inline void prefetch(const WideNode* nodes, const float* leaves, std::uint32_t item) {
    const char* node = reinterpret_cast<const char*>(nodes + item);
    const char* leaf =
        reinterpret_cast<const char*>(leaves + std::uint64_t{item & kLeafFirstMask} * kWordsPerTriangle);
    const char* at = item & kLeafBit ? leaf : node;
    __builtin_prefetch(at);
    __builtin_prefetch(at + 64);
    __builtin_prefetch(at + 128);
}

// The nearest child that is met; the others go onto the stack, the next nearest on top.
static inline std::uint32_t order_children(const WideNode* nodes, const float* leaves, const WideNode& node,
                                           const float near[kWidth], std::uint32_t met, StackEntry* stack,
                                           int& top) {
    const int first = __builtin_ctz(met);
    met &= met - 1;
    StackEntry nearest{node.child[first], near[first]};
    if (met == 0) return nearest.item;
    prefetch(nodes, leaves, nearest.item);
    const int base = top;
    do {  // insertion, farthest first: two or three are met on average
        const int lane = __builtin_ctz(met);
        met &= met - 1;
        const StackEntry entry{node.child[lane], near[lane]};
        prefetch(nodes, leaves, entry.item);
        const bool swap = entry.near < nearest.near;
        const StackEntry farther = swap ? nearest : entry;
        nearest = swap ? entry : nearest;
        int i = top++;
        for (; i > base && stack[i - 1].near < farther.near; --i) stack[i] = stack[i - 1];
        stack[i] = farther;
    } while (met != 0);
    return nearest.item;
}

// Opens inner nodes from `item` down to a leaf, leaving the farther children on the stack, nearest on top.
// kEmptyTree when nothing is met.
template <bool kIsTlas>
static inline std::uint32_t descend(const WideNode* nodes, const float* leaves, std::uint32_t item,
                                    const BoxRay& box, std::uint32_t layers, StackEntry* stack, int& top,
                                    Counts& counts) {
    while (!(item & kLeafBit)) {
        const WideNode& node = nodes[item];
        ++counts.nodes;
        alignas(32) float near[kWidth];
        std::uint32_t met = meet_boxes(node, box, near);
        if constexpr (kIsTlas) {
            std::uint32_t visible = 0;
            for (int i = 0; i < kWidth; ++i) visible |= std::uint32_t{(node.layers[i] & layers) != 0} << i;
            met &= visible;
        }
        if (met == 0) return kEmptyTree;
        item = order_children(nodes, leaves, node, near, met, stack, top);
    }
    return item;
}

// True when the sink has seen enough.
template <class Sink>
static inline bool test_leaf(const float* leaves, std::uint32_t leaf, std::uint32_t instance,
                             std::uint32_t skip, const LocalRay& ray, BoxRay& box, Sink& sink) {
    const std::uint32_t count = ((leaf & ~kLeafBit) >> 28) + 1;
    const float* rows = leaves + std::uint64_t{leaf & kLeafFirstMask} * kWordsPerTriangle;
    ShearedBlock sheared;
    for (std::uint32_t maybe = filter(rows, count, ray, sheared); maybe != 0; maybe &= maybe - 1) {
        const int lane = __builtin_ctz(maybe);
        Candidate candidate;
        if (!decide(sheared, lane, ray.dz, candidate)) continue;
        if (!(sink.t_min <= candidate.t && candidate.t <= sink.t_limit)) continue;
        __builtin_memcpy(&candidate.primitive, rows + 9 * count + lane, sizeof(candidate.primitive));
        if (candidate.primitive == skip) continue;
        candidate.instance = instance;
        if (sink.take(candidate)) return true;
        box.s_max = s_limit(box, sink.t_limit);
    }
    return false;
}

template <class Sink>
static bool walk_instance(const InstanceView& instance, std::uint32_t id, const RayIn& world, Sink& sink,
                          Counts& counts) {
    LocalRay ray;
    if (instance.is_identity) {
        if (!shear(world.origin, world.direction, ray)) return false;
    } else {
        float origin[4] = {}, direction[4] = {};
        to_local(instance.local_from_world, world, origin, direction);
        if (!shear(origin, direction, ray)) return false;
    }
    const BlasView& blas = instance.blas;
    BoxRay box;
    aim_at_boxes(ray, {blas.min, blas.max, 0.0f}, sink.t_min, sink.t_limit, box);
    const std::uint32_t skip = id == world.skip_instance ? world.skip_primitive : kEmptyTree;

    ++counts.instances;
    StackEntry stack[kStackSize];
    int top = 0;
    std::uint32_t item = blas.root;
    for (;;) {
        item = descend<false>(blas.nodes, blas.leaves, item, box, 0, stack, top, counts);
        if (item != kEmptyTree) {
            ++counts.leaves;
            if (test_leaf(blas.leaves, item, id, skip, ray, box, sink)) return true;
        }
        do {
            if (top == 0) return false;
            --top;
        } while (stack[top].near > box.s_max);
        item = stack[top].item;
    }
}

template <class Sink>
static void walk_scene(const SceneView& scene, const RayIn& world, std::uint32_t layers, Sink& sink,
                       Counts& counts) {
    if (scene.root == kEmptyTree) return;
    if (scene.root & kLeafBit) {  // one instance needs no tree
        const std::uint32_t id = scene.root & ~kLeafBit;
        if ((scene.instances[id].layers & layers) != 0)
            walk_instance(scene.instances[id], id, world, sink, counts);
        return;
    }
    LocalRay ray;
    if (!shear(world.origin, world.direction, ray)) return;
    float farthest = 0.0f;
    for (int a = 0; a < 3; ++a) farthest = larger(farthest, absolute(world.origin[a]));
    BoxRay box;
    // 2^-20: sixteen roundings, of which the way into the instance's frame and back to t can spend eleven.
    aim_at_boxes(ray, {scene.min, scene.max, farthest * scene.condition * 0x1p-20f}, sink.t_min, sink.t_limit,
                 box);

    StackEntry stack[kStackSize];
    int top = 0;
    std::uint32_t item = scene.root;
    for (;;) {
        item = descend<true>(scene.nodes, nullptr, item, box, layers, stack, top, counts);
        if (item != kEmptyTree) {
            const std::uint32_t id = item & ~kLeafBit;
            if ((scene.instances[id].layers & layers) != 0) {
                if (walk_instance(scene.instances[id], id, world, sink, counts)) return;
                box.s_max = s_limit(box, sink.t_limit);
            }
        }
        do {
            if (top == 0) return;
            --top;
        } while (stack[top].near > box.s_max);
        item = stack[top].item;
    }
}

}  // namespace rc::kernel::RC_ISA
