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

static void best_split(const Bins& bins, Split& split) {
    split.axis = -1;
    split.bin = 0;
    split.cost = __builtin_inff();
    for (int a = 0; a < 3; ++a) {
        float right_cost[kMaxBins];
        GrowingBox side;
        empty(side);
        std::uint32_t n = 0;
        for (std::int32_t b = bins.used - 1; b > 0; --b) {
            grow(side, load_as<Oct>(&bins.boxes[b][a]));
            n += bins.counts[b][a];
            right_cost[b] = n > 0 ? half_area(side) * float(n) : __builtin_inff();
        }
        empty(side);
        n = 0;
        for (std::int32_t b = 1; b < bins.used; ++b) {
            grow(side, load_as<Oct>(&bins.boxes[b - 1][a]));
            n += bins.counts[b - 1][a];
            if (n == 0) continue;
            const float cost = half_area(side) * float(n) + right_cost[b];
            if (cost < split.cost) {
                split.axis = a;
                split.bin = b;
                split.cost = cost;
            }
        }
    }
    empty(split.left);
    empty(split.right);
    if (split.axis < 0) return;
    for (std::int32_t b = 0; b < bins.used; ++b)
        grow(b < split.bin ? split.left : split.right, load_as<Oct>(&bins.boxes[b][split.axis]));
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

}  // namespace rc::kernel::RC_ISA
