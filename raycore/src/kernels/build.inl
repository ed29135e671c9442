// kernels/build.inl - boxes in vectors, and the builders' loops over refs. Compiled once per ISA.
//
// Everything is written in the compiler's own vectors of four and eight floats: without AVX, two of four.

namespace rc::kernel::RC_ISA {

typedef float Quad __attribute__((vector_size(16)));
typedef std::int32_t QuadBits __attribute__((vector_size(16)));
typedef float Oct __attribute__((vector_size(32)));
typedef std::int32_t OctBits __attribute__((vector_size(32)));

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
static inline Oct oct_of(float a) {
    return Oct{a, a, a, a, a, a, a, a};
}

template <class Vector>
static inline Vector lesser(const Vector& a, const Vector& b) {
    return a < b ? a : b;
}
template <class Vector>
static inline Vector greater(const Vector& a, const Vector& b) {
    return a > b ? a : b;
}

static inline void grow(GrowingBox& box, const Oct& by) {
    store_as<Oct>(&box, greater(by, load_as<Oct>(&box)));
}

static inline Oct nothing() {
    return oct_of(-0x1.fffffep127f);
}

static inline void empty(GrowingBox& box) {
    store_as<Oct>(&box, nothing());
}

static inline Quad extent_of(const Oct& box) {
    return __builtin_shufflevector(box, box, 4, 5, 6, 7) + __builtin_shufflevector(box, box, 0, 1, 2, 3);
}

static inline float half_area(const Oct& box) {
    const Quad d = extent_of(box);
    return (d[0] * d[1] + d[1] * d[2]) + d[2] * d[0];
}

// The lane behind the axes holds an integer; as a float it may be denormal, which is slow.
static inline Quad without_item(const Quad& v) {
    return reinterpret_cast<Quad>(reinterpret_cast<QuadBits>(v) & QuadBits{-1, -1, -1, 0});
}
static inline Oct without_items(const Oct& v) {
    return reinterpret_cast<Oct>(reinterpret_cast<OctBits>(v) & OctBits{-1, -1, -1, 0, -1, -1, -1, 0});
}

// Twice the centre.
static inline Quad centre_of(const BuildRef& ref) {
    return without_item(load_as<Quad>(ref.max) - load_as<Quad>(ref.neg_min));
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
        const Oct both = greater(a, b);
        store_as<Oct>(&subsets.boxes[set], both);
        subsets.costs[set] = half_area(both) * float(__builtin_popcount(set));
    }
}

}  // namespace rc::kernel::RC_ISA
