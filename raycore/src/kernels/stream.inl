// kernels/stream.inl - many rays of a batch in flight at once, a step of each in turn.
//
// One ray alone waits for memory and for its own last step; kInFlight of them fill those gaps. Each pass takes every
// ray that stands before an inner node one step on, without a branch that could be guessed wrongly, and asks for the
// memory of its next; then come the rays that stand before leaves. What a ray is told does not depend on its company:
// it is tested against the same triangles by the same arithmetic as alone.

namespace rc::kernel::RC_ISA {
namespace {  // members of templates must not leave this file as weak symbols

inline constexpr int kInFlight = 32;

template <class Sink>
struct Walker {
    InstanceRay local;
    std::uint32_t item;  // what comes next
    int top;
    std::uint32_t maybe;  // lanes of the leaf that the filter let through
    std::uint64_t ray;    // of the batch
    Sink sink;
    Stack stack;
    TopWalk<Sink> above;  // untouched where a scene is a single instance
};

template <class Sink, class Answers>
class Stream {
    using Rays = Walker<Sink> * [kInFlight + 1];  // one more: what is appended may be taken back

  public:
    // Rays [begin, end) of the batch.
    Stream(const SceneView& scene, const RayIn* rays, std::uint64_t begin, std::uint64_t end,
           std::uint32_t layers, const Answers& answers)
        : scene_(scene), rays_(rays), next_(begin), end_(end), layers_(layers), answers_(answers) {}

    Counts run() {
        for (Walker<Sink>& walker : walkers_) start(walker);
        while (at_node_ + at_leaf_ > 0) {
            const int n = at_leaf_;  // those whose memory was asked for a pass ago
            open_nodes();
            test_leaves(n);
        }
        return counts_;
    }

  private:
    void open_nodes() {
        const int n = at_node_;
        for (int i = 0; i < n; ++i) {
            Walker<Sink>& walker = *node_rays_[i];
            const WideNode& node = walker.local.nodes[walker.item];
            const Entrances e = enter_boxes(node, walker.local.box);
            const std::uint32_t met = less_equal_bits(e.enter, e.leave);
            int top = walker.top;
            walker.item = next_below<!Sink::kIsAny>(node, e, met, walker.stack, top);
            walker.top = top;
        }
        counts_.nodes += std::uint64_t(n);
        at_node_ = 0;
        queue(node_rays_, n);  // in a loop of its own: nobody waits for what was just written
    }

    // Puts rays into the queue of what they stand before; `from` may be the nodes' own.
    void queue(Walker<Sink>** from, int n) {
        int nodes = at_node_, leaves = at_leaf_;
        for (int i = 0; i < n; ++i) {
            Walker<Sink>& walker = *from[i];
            const std::uint32_t item = walker.item;
            prefetch<4>(places_of_blas(walker.local.nodes, walker.local.leaves), item);
            node_rays_[nodes] = leaf_rays_[leaves] = &walker;
            nodes += int(item >> 31) ^ 1;
            leaves += int(item >> 31);
        }
        at_node_ = nodes;
        at_leaf_ = leaves;
    }

    // The first n of the queue.
    void test_leaves(int n) {
        Rays at_end, testing, maybe;
        int n_at_end = 0, n_testing = 0, n_maybe = 0;
        for (int i = 0; i < n; ++i) {
            Walker<Sink>& walker = *leaf_rays_[i];
            const int is_at_end = walker.item == kEmptyTree;
            at_end[n_at_end] = testing[n_testing] = &walker;
            n_at_end += is_at_end;
            n_testing += is_at_end ^ 1;
        }
        at_leaf_ -= n;
        for (int i = 0; i < at_leaf_; ++i) leaf_rays_[i] = leaf_rays_[i + n];
        for (int i = 0; i < n_testing; ++i) {
            Walker<Sink>& walker = *testing[i];
            const Leaf leaf = leaf_at(walker.local.leaves, walker.item);
            walker.maybe = filter(leaf, corners_of(leaf, walker.local.ray));
            maybe[n_maybe] = &walker;
            n_maybe += walker.maybe != 0;
        }
        counts_.leaves += std::uint64_t(n_testing);
        for (int i = 0; i < n_maybe; ++i) decide_leaf(*maybe[i]);
        for (int i = 0; i < n_testing; ++i) testing[i]->item = testing[i]->stack.item[--testing[i]->top];
        queue(testing, n_testing);
        for (int i = 0; i < n_at_end; ++i)
            if (!enter_next(*at_end[i])) finish(*at_end[i]);
    }

    void decide_leaf(Walker<Sink>& walker) {
        const Leaf leaf = leaf_at(walker.local.leaves, walker.item);
        if constexpr (Sink::kIsAny) {
            const Corners corners = corners_of(leaf, walker.local.ray);
            if (test_lanes(leaf, corners, walker.maybe, walker.local, walker.sink))
                walker.top = 1;  // seen enough: only the end is left on the stack
        } else {
            const float limit = walker.sink.t_limit;
            test_in_turn(leaf, walker.maybe, walker.local, walker.sink);
            if (walker.sink.t_limit != limit)
                walker.top = trim(walker.stack, 1, walker.top, walker.local.box.s_max);
        }
    }

    // Takes the walk into the next instance; false when there is none, or none matters any more.
    bool enter_next(Walker<Sink>& walker) {
        if (is_single_instance(scene_) || walker.sink.is_done()) return false;
        for (;;) {
            const std::uint32_t id = walker.above.next(scene_, layers_, walker.sink.t_limit, counts_);
            if (id == kEmptyTree) return false;
            if (enter(walker, id)) return true;
        }
    }

    bool enter(Walker<Sink>& walker, std::uint32_t id) {
        const Sink& sink = walker.sink;
        const RayIn& ray = rays_[walker.ray];
        if (!is_single_instance(scene_) && takes_world_ray(scene_, id)) {
            walker.local.ray = walker.above.ray;
            aim_in_world(scene_, walker.local.ray, sink.t_min, sink.t_limit, walker.local.box);
            stand_at_root(scene_, id, ray, walker.local);
        } else if (!enter_instance(scene_, id, ray, sink.t_min, sink.t_limit, walker.local)) {
            return false;
        }
        ++counts_.instances;
        walker.top = empty_stack(walker.stack);
        walker.item = walker.local.root;
        Walker<Sink>* one[1] = {&walker};
        queue(one, 1);
        return true;
    }

    void finish(Walker<Sink>& walker) {
        answers_.write(walker.ray, walker.sink);
        start(walker);
    }

    // The next ray of the batch that has a way to go.
    void start(Walker<Sink>& walker) {
        while (next_ < end_) {
            walker.ray = next_++;
            const RayIn& ray = rays_[walker.ray];
            walker.sink.begin(ray);
            if (is_good(ray) && begin_walk(walker, ray)) return;
            answers_.write(walker.ray, walker.sink);
        }
    }

    bool begin_walk(Walker<Sink>& walker, const RayIn& ray) {
        if (is_single_instance(scene_)) {
            const std::uint32_t id = scene_.root & ~kLeafBit;
            return (scene_.instances[id].layers & layers_) != 0 && enter(walker, id);
        }
        walker.above.begin(scene_, ray, walker.sink.t_min, walker.sink.t_limit);
        return enter_next(walker);
    }

    const SceneView& scene_;
    const RayIn* rays_;
    std::uint64_t next_, end_;
    std::uint32_t layers_;
    const Answers& answers_;
    Counts counts_;
    int at_node_ = 0, at_leaf_ = 0;
    Rays node_rays_, leaf_rays_;
    Walker<Sink> walkers_[kInFlight];
};

static inline void add(Counts& counts, const Counts& added) {
    counts.instances += added.instances;
    counts.nodes += added.nodes;
    counts.leaves += added.leaves;
}

// What it cost to answer rays [begin, end) of the batch.
template <class Sink, class Answers>
static Counts ask_stream(const SceneView& scene, const RayIn* rays, std::uint64_t begin, std::uint64_t end,
                         std::uint32_t layers, const Answers& answers) {
    if (begin == end) return {};
    return Stream<Sink, Answers>(scene, rays, begin, end, layers, answers).run();
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
