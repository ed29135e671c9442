// kernels/pieces.inl - triangles cut into slabs: what a plane through them would leave on either side.

namespace rc::kernel::RC_ISA {

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
                       Bins& bins) {
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
            ++bins.at[f].entries[a];
            ++bins.at[l].exits[a];
            if (f == l) {
                grow(bins.at[f].boxes[a], box);
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
                grow(bins.at[k].boxes[a], piece < box ? piece : box);
            }
        }
    }
}

}  // namespace rc::kernel::RC_ISA
