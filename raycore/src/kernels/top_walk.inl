// kernels/top_walk.inl - a ray's walk over the top-level tree, and into the instances it may meet.

namespace rc::kernel::RC_ISA {
namespace {

// What comes after a node of the top-level tree.
template <class Sink>
static inline std::uint32_t open_top(const SceneView& scene, const WideNode& node, std::uint32_t layers,
                                     const BoxRay& box, Entry<Sink>*& top) {
    const Entrances e = enter_boxes(node, box);
    const std::uint32_t met = less_equal_bits(e.enter, e.leave) & common_bits(load(node.layers), layers);
    if (met == 0) return pop(top, box.s_max);
    return next_child<false>(places_of_scene(scene), node, e, met, top);
}

// A ray's walk over the top-level tree: the instances it may meet, the nearest boxes first.
template <class Sink>
struct TopWalk {
    LocalRay ray;
    BoxRay box;
    Entry<Sink> stack[kEntries];
    Entry<Sink>* top;

    void begin(const SceneView& scene, const RayIn& world, float t_min, float t_limit) {
        enter_scene(scene, world, t_min, t_limit, ray, box);
        top = start(stack);
        put(top, scene.root);
    }

    // kEmptyTree when there is none left, which is the last that may be asked for.
    std::uint32_t next(const SceneView& scene, std::uint32_t layers, float t_limit, Counts& counts) {
        box.s_max = s_limit(box, t_limit);
        std::uint32_t item = pop(top, box.s_max);
        while (!(item & kLeafBit)) {
            const WideNode& node = scene.nodes[item];
            ++counts.nodes;
            item = open_top<Sink>(scene, node, layers, box, top);
        }
        return item == kEmptyTree ? kEmptyTree : item & ~kLeafBit;
    }
};

static inline bool is_single_instance(const SceneView& scene) {
    return (scene.root & kLeafBit) != 0;  // which needs no tree
}

// True when the sink has seen enough.
template <class Sink>
static bool walk_top(const SceneView& scene, const RayIn& world, std::uint32_t layers, Sink& sink,
                     Counts& counts) {
    InstanceRay in_world;  // a ray of every tree that stands in the world's own frame
    BoxRay box;            // and of the top-level tree
    enter_scene(scene, world, sink.t_min, sink.t_limit, in_world.ray, box);
    bool is_aimed = false;  // in_world's box, which many a scene has no use for
    Entry<Sink> stack[kEntries];
    Entry<Sink>* top = start(stack);
    std::uint32_t item = scene.root;
    for (;;) {
        while (!(item & kLeafBit)) {
            const WideNode& node = scene.nodes[item];
            ++counts.nodes;
            item = open_top<Sink>(scene, node, layers, box, top);
        }
        if (item == kEmptyTree) return false;
        const std::uint32_t id = item & ~kLeafBit;
        if (takes_world_ray(scene, id)) {
            if (!is_aimed) aim_in_world(scene, in_world.ray, sink.t_min, sink.t_limit, in_world.box);
            is_aimed = true;
            in_world.box.s_max = s_limit(in_world.box, sink.t_limit);
            stand_at_root(scene, id, world, in_world);
            if (walk_tree(in_world, sink, counts)) return true;
        } else if (walk_instance(scene, id, world, sink, counts)) {
            return true;
        }
        box.s_max = s_limit(box, sink.t_limit);
        item = pop(top, box.s_max);
    }
}

template <class Sink>
static void walk_scene(const SceneView& scene, const RayIn& world, std::uint32_t layers, Sink& sink,
                       Counts& counts) {
    if (scene.root == kEmptyTree) return;
    if (!is_single_instance(scene)) {
        walk_top(scene, world, layers, sink, counts);
        return;
    }
    const std::uint32_t id = scene.root & ~kLeafBit;
    if ((scene.instances[id].layers & layers) != 0) walk_instance(scene, id, world, sink, counts);
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
