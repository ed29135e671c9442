// kernels/boxes.inl - a ray against the eight boxes of a node, and the stacks of what is still to be opened.

namespace rc::kernel::RC_ISA {
namespace {

struct Entrances {
    Float enter, leave;  // distances; a box is met where enter <= leave
};

// What a ray asks of every node, spread over the lanes: a walk of one ray keeps it by value and so in registers, where
// the compiler could not leave what a store to the stack might have changed.
struct SpreadRay {
    Float near_rcp[3], far_rcp[3], near_at_zero[3], far_at_zero[3], s_min;
    std::int64_t near_row[3], far_row[3];
};

static inline SpreadRay spread(const BoxRay& box) {
    SpreadRay ray;
    for (int a = 0; a < 3; ++a) {
        ray.near_rcp[a] = splat(box.near_rcp[a]);
        ray.far_rcp[a] = splat(box.far_rcp[a]);
        ray.near_at_zero[a] = splat(box.near_at_zero[a]);
        ray.far_at_zero[a] = splat(box.far_at_zero[a]);
        ray.near_row[a] = box.octant->near_row[a];
        ray.far_row[a] = box.octant->far_row[a];
    }
    ray.s_min = splat(box.s_min);
    return ray;
}

static inline Entrances enter_boxes(const WideNode& node, const SpreadRay& ray, float s_max) {
    const char* bounds = reinterpret_cast<const char*>(node.bounds);
    const auto row = [&](std::int64_t offset) {
        return load(reinterpret_cast<const float*>(bounds + offset));
    };
    Float near[3], far[3];
    for (int a = 0; a < 3; ++a) {
        near[a] = about_fma(row(ray.near_row[a]), ray.near_rcp[a], ray.near_at_zero[a]);
        far[a] = about_fma(row(ray.far_row[a]), ray.far_rcp[a], ray.far_at_zero[a]);
    }
    // In pairs: a ray waits for two of them, not for three.
    return {max(max(near[0], near[1]), max(near[2], ray.s_min)),
            min(min(far[0], far[1]), min(far[2], splat(s_max)))};
}

static inline Entrances enter_boxes(const WideNode& node, const BoxRay& box) {
    return enter_boxes(node, spread(box), box.s_max);
}

// Of a ray in company: kEmptyTree at the bottom, nearer than anything, ends a walk.
struct Stack {
    std::uint32_t item[kStackSize + kWidth];  // next_below writes eight, whatever they mean
    float near[kStackSize + kWidth];
};

static inline int empty_stack(Stack& stack) {
    stack.item[0] = kEmptyTree;
    stack.near[0] = -__builtin_inff();
    return 1;
}

// The next item after a node: the nearest of its children that are met (kNearestFirst; otherwise the highest lane, which
// is the likeliest to end a walk), or what lies on the stack when there is none. The other children are packed onto the
// stack, however many they are: all without a branch. The nearest alone is worth finding: with the others in no order a
// ray opens 2 % more nodes.
template <bool kNearestFirst, class AnyStack>
static inline std::uint32_t next_below(const WideNode& node, const Entrances& e, std::uint32_t met,
                                       AnyStack& stack, int& top) {
    const std::uint32_t first = kNearestFirst ? lane_of_least(e.enter, met)
                                              : 31u - static_cast<std::uint32_t>(__builtin_clz(met | 1));
    const std::uint32_t others = met & ~(1u << first);
    const std::uint32_t below = node.child[first & (kWidth - 1)], waiting = stack.item[top - 1];
    const Words child = load(node.child);
    const int old_top = top;
    const std::uint32_t is_none =
        std::uint32_t(std::int32_t(met - 1) >> 31);  // a mask: compilers would branch
    top += __builtin_popcount(others) + int(is_none);
    store(stack.item + old_top, compress(child, others));
    store(stack.near + old_top, compress(e.enter, others));
    return below ^ ((below ^ waiting) & is_none);
}

// Takes everything beyond s_max off the stack, above `bottom`.
template <class AnyStack>
static inline int trim(AnyStack& stack, int bottom, int top, float s_max) {
    int kept = bottom;
    for (int i = bottom; i < top; i += kWidth) {
        const Float near = load(stack.near + i);
        const Words item = load(stack.item + i);
        const std::uint32_t valid = top - i >= kWidth ? 0xFFu : (1u << (top - i)) - 1;
        const std::uint32_t keep = less_equal_bits(near, splat(s_max)) & valid;
        store(stack.near + kept, compress(near, keep));
        store(stack.item + kept, compress(item, keep));
        kept += __builtin_popcount(keep);
    }
    return kept;
}

// Where the items of a tree lie.
struct Places {
    const WideNode* nodes;
    const void* leaves;
    std::uint32_t leaf_mask, leaf_bytes;
};

static inline Places places_of_blas(const WideNode* nodes, const float* leaves) {
    return {nodes, leaves, kUnitMask, kWordsPerUnit * sizeof(float)};
}
static inline Places places_of_scene(const SceneView& scene) {
    return {scene.nodes, scene.instances, ~kLeafBit, sizeof(InstanceView)};
}

// Asks for an item's memory before it is its turn: nodes and leaves of a large scene are a cache miss each. No branch
// on what it is: a wrong guess would cost more than the miss. Inlined by force: to GCC a function that asks for memory and
// does nothing else has no effect, and it drops calls of it.
template <int kLines>
__attribute__((always_inline)) static inline void prefetch(const Places& places, std::uint32_t item) {
    const std::uint64_t node =
        reinterpret_cast<std::uint64_t>(places.nodes) + std::uint64_t{item} * sizeof(WideNode);
    const std::uint64_t leaf = reinterpret_cast<std::uint64_t>(places.leaves) +
                               std::uint64_t{item & places.leaf_mask} * places.leaf_bytes;
    const std::uint64_t is_leaf = 0 - std::uint64_t{item >> 31};
    // NOLINTNEXTLINE(performance-no-int-to-ptr): an address that is asked for, never read through
    const char* at = reinterpret_cast<const char*>(node ^ ((node ^ leaf) & is_leaf));
    for (int line = 0; line < kLines; ++line) __builtin_prefetch(at + 64 * line);
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
