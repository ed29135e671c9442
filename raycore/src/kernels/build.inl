// kernels/build.inl - the inner loops of builders by the surface-area heuristic. Compiled once per ISA.
//
// Everything is written in the compiler's own vectors of four and eight floats: without AVX, two of four.

namespace rc::kernel::RC_ISA {

typedef float Quad __attribute__((vector_size(16)));
typedef std::int32_t QuadBits __attribute__((vector_size(16)));
typedef float Oct __attribute__((vector_size(32)));

template <class Vector>
static inline Vector load_as(const void* p) {
    Vector v;
    __builtin_memcpy(&v, p, sizeof(v));
    return v;
}
template <class Vector>
static inline void store_as(void* p, const Vector& v) {
    __builtin_memcpy(p, &v, sizeof(v));
}
static inline Quad quad_of(float a) {
    return Quad{a, a, a, a};
}

static inline void grow(GrowingBox& box, const Oct& by) {
    const Oct old = load_as<Oct>(&box);
    store_as<Oct>(&box, by > old ? by : old);
}

static inline void empty(GrowingBox& box) {
    constexpr float kNothing = -0x1.fffffep127f;
    store_as<Oct>(&box, Oct{kNothing, kNothing, kNothing, kNothing, kNothing, kNothing, kNothing, kNothing});
}

static inline float half_area(const GrowingBox& box) {
    const Quad d = load_as<Quad>(box.max) + load_as<Quad>(box.neg_min);
    return (d[0] * d[1] + d[1] * d[2]) + d[2] * d[0];
}

// Twice the centre. The lane behind the axes holds an integer; as a float it may be denormal, which is slow.
static inline Quad centre_of(const BuildRef& ref) {
    const Quad c = load_as<Quad>(ref.max) - load_as<Quad>(ref.neg_min);
    return reinterpret_cast<Quad>(reinterpret_cast<QuadBits>(c) & QuadBits{-1, -1, -1, 0});
}

static void clear(Bins& bins, std::int32_t used) {
    bins.used = used;
    for (std::int32_t b = 0; b < used; ++b) {
        for (int a = 0; a < 3; ++a) empty(bins.boxes[b][a]);
        store_as<QuadBits>(bins.counts[b], QuadBits{0, 0, 0, 0});
    }
}

static void bin(const BuildRef* refs, std::uint64_t n, const BinGrid& grid, Bins& bins) {
    const Quad origin = load_as<Quad>(grid.origin), scale = load_as<Quad>(grid.scale);
    const Quad last = quad_of(float(grid.count - 1)), zero = quad_of(0.0f);
    for (std::uint64_t i = 0; i < n; ++i) {
        const Oct box = load_as<Oct>(&refs[i]);
        const Quad at = (centre_of(refs[i]) - origin) * scale;
        const Quad low = at < last ? at : last;
        const QuadBits index = __builtin_convertvector(low > zero ? low : zero, QuadBits);
        for (int a = 0; a < 3; ++a) {
            grow(bins.boxes[index[a]][a], box);
            ++bins.counts[index[a]][a];
        }
    }
}

// The cheapest border, where `lefts[b]` things end up left of a border above bin b and `rights[b]` right of one below.
static inline void best_border(const GrowingBox (*boxes)[3], const std::uint32_t (*lefts)[4],
                               const std::uint32_t (*rights)[4], std::int32_t used, Split& split) {
    split.axis = -1;
    split.bin = 0;
    split.cost = __builtin_inff();
    split.left_count = split.right_count = 0;
    for (int a = 0; a < 3; ++a) {
        float right_cost[kMaxBins];
        std::uint32_t right_count[kMaxBins];
        GrowingBox side;
        empty(side);
        std::uint32_t n = 0;
        for (std::int32_t b = used - 1; b > 0; --b) {
            grow(side, load_as<Oct>(&boxes[b][a]));
            n += rights[b][a];
            right_count[b] = n;
            right_cost[b] = n > 0 ? half_area(side) * float(n) : __builtin_inff();
        }
        empty(side);
        n = 0;
        for (std::int32_t b = 1; b < used; ++b) {
            grow(side, load_as<Oct>(&boxes[b - 1][a]));
            n += lefts[b - 1][a];
            if (n == 0) continue;
            const float cost = half_area(side) * float(n) + right_cost[b];
            if (cost < split.cost) {
                split.axis = a;
                split.bin = b;
                split.cost = cost;
                split.left_count = n;
                split.right_count = right_count[b];
            }
        }
    }
    empty(split.left);
    empty(split.right);
    if (split.axis < 0) return;
    for (std::int32_t b = 0; b < used; ++b)
        grow(b < split.bin ? split.left : split.right, load_as<Oct>(&boxes[b][split.axis]));
}

static void best_split(const Bins& bins, Split& split) {
    best_border(bins.boxes, bins.counts, bins.counts, bins.used, split);
}

static void best_plane(const SlabBins& bins, Split& split) {
    best_border(bins.boxes, bins.entries, bins.exits, bins.used, split);
}

static std::uint64_t partition(BuildRef* refs, std::uint64_t n, const BinGrid& grid, std::int32_t axis,
                               std::int32_t bin) {
    const float origin = grid.origin[axis], scale = grid.scale[axis], border = float(bin);
    std::uint64_t lefts = 0;
    for (std::uint64_t i = 0; i < n; ++i) {  // no branch: where a ref goes can not be predicted
        const Oct ref = load_as<Oct>(&refs[i]);
        const float centre = refs[i].max[axis] - refs[i].neg_min[axis];
        store_as<Oct>(&refs[i], load_as<Oct>(&refs[lefts]));
        store_as<Oct>(&refs[lefts], ref);
        // Neither truncation nor clamping to a bin moves a number from one side of a border to the other.
        lefts += (centre - origin) * scale < border;
    }
    return lefts;
}

static void measure(const BuildRef* refs, std::uint64_t n, GrowingBox& boxes, GrowingBox& centres) {
    GrowingBox around = boxes, middle = centres;
    for (std::uint64_t i = 0; i < n; ++i) {
        const Quad c = centre_of(refs[i]), d = -c;
        grow(around, load_as<Oct>(&refs[i]));
        grow(middle, Oct{d[0], d[1], d[2], d[3], c[0], c[1], c[2], c[3]});
    }
    boxes = around;
    centres = middle;
}

static void measure_subsets(const BuildRef* refs, std::uint32_t n, Subsets& subsets) {
    empty(subsets.boxes[0]);
    for (std::uint32_t set = 1; set < 1u << n; ++set) {
        const GrowingBox& less = subsets.boxes[set & (set - 1)];
        const Oct a = load_as<Oct>(&less), b = load_as<Oct>(&refs[__builtin_ctz(set)]);
        store_as<Oct>(&subsets.boxes[set], a > b ? a : b);
        subsets.costs[set] = half_area(subsets.boxes[set]) * float(__builtin_popcount(set));
    }
}

static void clear_slabs(SlabBins& bins, std::int32_t used) {
    bins.used = used;
    for (std::int32_t b = 0; b < used; ++b) {
        for (int a = 0; a < 3; ++a) empty(bins.boxes[b][a]);
        store_as<QuadBits>(bins.entries[b], QuadBits{0, 0, 0, 0});
        store_as<QuadBits>(bins.exits[b], QuadBits{0, 0, 0, 0});
    }
}

static inline void grow_to_point(GrowingBox& box, const Quad& p) {
    const Quad n = -p, low = load_as<Quad>(box.neg_min), high = load_as<Quad>(box.max);
    store_as<Quad>(box.neg_min, n > low ? n : low);
    store_as<Quad>(box.max, p > high ? p : high);
}

struct SlabRun {
    int axis;
    std::int32_t first, last;  // both included
};

// Grows the run's pieces by what of the way from `a` to `b` lies in each slab, within the ref's own share of it.
static inline void cut_edge(Quad a, Quad b, const BuildRef& ref, const SlabGrid& grid, SlabRun run,
                            GrowingBox* pieces) {
    const int axis = run.axis;
    if (a[axis] > b[axis]) {
        const Quad swap = a;
        a = b;
        b = swap;
    }
    const float low = -ref.neg_min[axis], high = ref.max[axis];
    if (b[axis] < low || a[axis] > high) return;
    const float length = b[axis] - a[axis];
    const Quad per_unit = (b - a) / quad_of(length);
    const float start = a[axis];
    const auto at = [&](float x) { return a + per_unit * quad_of(x - start); };
    const auto slab = [&](float x) {
        const std::int32_t k = std::int32_t((x - grid.origin[axis]) * grid.scale[axis]);
        return k < run.first ? run.first : k > run.last ? run.last : k;
    };
    const Quad from = a[axis] < low ? at(low) : a, to = b[axis] > high ? at(high) : b;
    std::int32_t k = slab(from[axis]);
    const std::int32_t end = slab(to[axis]);
    grow_to_point(pieces[k], from);
    for (; k < end; ++k) {
        const Quad border = at(grid.origin[axis] + grid.width[axis] * float(k + 1));
        grow_to_point(pieces[k], border);
        grow_to_point(pieces[k + 1], border);
    }
    grow_to_point(pieces[end], to);
}

static inline Quad corner_of(const MeshArrays& mesh, std::uint32_t vertex) {
    const float* p = mesh.positions + 3 * std::uint64_t{vertex};
    return Quad{p[0], p[1], p[2], 0.0f};
}

static void bin_pieces(const BuildRef* refs, std::uint64_t n, const MeshArrays& mesh, const SlabGrid& grid,
                       SlabBins& bins) {
    const Quad origin = load_as<Quad>(grid.origin), scale = load_as<Quad>(grid.scale);
    const Quad top = quad_of(float(grid.count - 1)), zero = quad_of(0.0f);
    const auto slabs_of = [&](Quad p) {
        const Quad at = (p - origin) * scale;
        const Quad low = at < top ? at : top;
        return __builtin_convertvector(low > zero ? low : zero, QuadBits);
    };
    for (std::uint64_t i = 0; i < n; ++i) {
        const BuildRef& ref = refs[i];
        const Oct box = load_as<Oct>(&ref);
        const Quad low{-ref.neg_min[0], -ref.neg_min[1], -ref.neg_min[2], 0.0f};
        const Quad high{ref.max[0], ref.max[1], ref.max[2], 0.0f};
        const QuadBits first = slabs_of(low), last = slabs_of(high);
        for (int a = 0; a < 3; ++a) {
            const std::int32_t f = first[a], l = last[a];
            ++bins.entries[f][a];
            ++bins.exits[l][a];
            if (f == l) {
                grow(bins.boxes[f][a], box);
                continue;
            }
            GrowingBox pieces[kMaxBins];
            for (std::int32_t k = f; k <= l; ++k) empty(pieces[k]);
            const std::uint32_t* t = mesh.triangles + 3 * std::uint64_t{ref.item};
            const Quad p = corner_of(mesh, t[0]), q = corner_of(mesh, t[1]), r = corner_of(mesh, t[2]);
            const SlabRun run{a, f, l};
            cut_edge(p, q, ref, grid, run, pieces);
            cut_edge(q, r, ref, grid, run, pieces);
            cut_edge(r, p, ref, grid, run, pieces);
            for (std::int32_t k = f; k <= l; ++k) {
                const Oct piece = load_as<Oct>(&pieces[k]);
                grow(bins.boxes[k][a], piece < box ? piece : box);
            }
        }
    }
}

}  // namespace rc::kernel::RC_ISA
