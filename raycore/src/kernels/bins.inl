// kernels/bins.inl - refs put into bins, and the border between bins that parts them best.

namespace rc::kernel::RC_ISA {

static void clear(Bins& bins, std::int32_t used) {
    bins.used = used;
    for (std::int32_t b = 0; b < used; ++b) {
        Bin& bin = bins.at[b];
        for (int a = 0; a < 3; ++a) empty(bin.boxes[a]);
        store_as<QuadBits>(bin.entries, QuadBits{0, 0, 0, 0});
        store_as<QuadBits>(bin.exits, QuadBits{0, 0, 0, 0});
    }
}

static void join(Bins& bins, const Bins& others) {
    for (std::int32_t b = 0; b < bins.used; ++b) {
        Bin& bin = bins.at[b];
        const Bin& by = others.at[b];
        for (int a = 0; a < 3; ++a) grow(bin.boxes[a], load_as<Oct>(&by.boxes[a]));
        store_as<QuadBits>(bin.entries, load_as<QuadBits>(bin.entries) + load_as<QuadBits>(by.entries));
        store_as<QuadBits>(bin.exits, load_as<QuadBits>(bin.exits) + load_as<QuadBits>(by.exits));
    }
}

static inline Oct twice(const float (&four)[4]) {
    const Quad v = load_as<Quad>(four);
    return __builtin_shufflevector(v, v, 0, 1, 2, 3, 0, 1, 2, 3);
}

// The bin of every ref's centre along each axis, of two refs at a time.
static inline void find_bins(const BuildRef* refs, std::uint64_t n, const BinGrid& grid,
                             std::uint32_t (*found)[4]) {
    const Oct origin = twice(grid.origin), scale = twice(grid.scale);
    const Oct last = oct_of(float(grid.count - 1)), zero = oct_of(0.0f);
    for (std::uint64_t i = 0; i < n; i += 2) {
        const Oct a = load_as<Oct>(&refs[i]), b = load_as<Oct>(&refs[i + 1 < n ? i + 1 : i]);
        const Oct centre = without_items(__builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15) -
                                         __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11));
        const Oct at = greater(lesser((centre - origin) * scale, last), zero);
        store_as<OctBits>(found[i], __builtin_convertvector(at, OctBits));
    }
}

static inline void put(const BuildRef& ref, const std::uint32_t (&in)[4], Bins& bins) {
    const Oct box = load_as<Oct>(&ref);
    for (int a = 0; a < 3; ++a) {
        Bin& bin = bins.at[in[a]];
        grow(bin.boxes[a], box);
        ++bin.entries[a];
    }
}

// Neighbours fall into the same bins, and each would wait until what the one before it wrote there can be read again. So of
// four each has bins of its own, where there are enough of them to pay for joining those.
static void bin(const BuildRef* refs, std::uint64_t n, const BinGrid& grid, Bins& bins) {
    constexpr std::uint64_t kEnough = 256, kAtATime = 64;
    const bool are_enough = n >= kEnough;
    Bins others[3];
    for (int k = 0; are_enough && k < 3; ++k) clear(others[k], grid.count);
    std::uint32_t found[kAtATime][4];
    for (std::uint64_t begin = 0; begin < n; begin += kAtATime) {
        const BuildRef* some = refs + begin;
        const std::uint64_t count = n - begin < kAtATime ? n - begin : kAtATime;
        find_bins(some, count, grid, found);
        std::uint64_t i = 0;
        for (; are_enough && i + 4 <= count; i += 4) {
            put(some[i], found[i], bins);
            put(some[i + 1], found[i + 1], others[0]);
            put(some[i + 2], found[i + 2], others[1]);
            put(some[i + 3], found[i + 3], others[2]);
        }
        for (; i < count; ++i) put(some[i], found[i], bins);
    }
    for (int k = 0; are_enough && k < 3; ++k) join(bins, others[k]);
}

// What lies on one side of a border, along all three axes at once.
struct Side {
    Oct boxes[3];
    QuadBits counts{0, 0, 0, 0};

    Side() {
        for (Oct& box : boxes) box = nothing();
    }
    inline void grow(const Bin& by, const std::uint32_t (&count)[4]) {
        for (int a = 0; a < 3; ++a) boxes[a] = greater(load_as<Oct>(&by.boxes[a]), boxes[a]);
        counts += load_as<QuadBits>(count);
    }
    // Half areas times counts. Of nothing it is infinity times zero, which is no number and never the least.
    [[nodiscard]] inline Quad cost() const {
        const Quad d0 = extent_of(boxes[0]), d1 = extent_of(boxes[1]), d2 = extent_of(boxes[2]);
        const Quad xys = __builtin_shufflevector(d0, d1, 0, 4, 1, 5),
                   zs = __builtin_shufflevector(d0, d1, 2, 6, 3, 7);
        const Quad x = __builtin_shufflevector(xys, d2, 0, 1, 4, 4),
                   y = __builtin_shufflevector(xys, d2, 2, 3, 5, 5),
                   z = __builtin_shufflevector(zs, d2, 0, 1, 6, 6);
        return ((x * y + y * z) + z * x) * __builtin_convertvector(counts, Quad);
    }
};

// The cheapest border: things count as left of it by their entries, as right of it by `rights`.
static inline void best_border(const Bins& bins, std::uint32_t (Bin::*rights)[4], Split& split) {
    Quad right_costs[kMaxBins];
    Side right, left;
    for (std::int32_t b = bins.used - 1; b > 0; --b) {
        right.grow(bins.at[b], bins.at[b].*rights);
        right_costs[b] = right.cost();
    }
    Quad least = quad_of(__builtin_inff());
    QuadBits best{0, 0, 0, 0};
    for (std::int32_t b = 1; b < bins.used; ++b) {
        left.grow(bins.at[b - 1], bins.at[b - 1].entries);
        const Quad cost = left.cost() + right_costs[b];
        best = cost < least ? QuadBits{b, b, b, b} : best;
        least = cost < least ? cost : least;
    }
    split = {-1, 0, __builtin_inff(), 0, 0, {}, {}};
    for (int a = 0; a < 3; ++a) {
        if (!(least[a] < split.cost)) continue;
        split.axis = a;
        split.bin = best[a];
        split.cost = least[a];
    }
    const int a = split.axis;
    Oct below = nothing(), above = nothing();
    std::int32_t b = 0;
    for (; a >= 0 && b < split.bin; ++b) {
        below = greater(load_as<Oct>(&bins.at[b].boxes[a]), below);
        split.left_count += bins.at[b].entries[a];
    }
    for (; a >= 0 && b < bins.used; ++b) {
        above = greater(load_as<Oct>(&bins.at[b].boxes[a]), above);
        split.right_count += (bins.at[b].*rights)[a];
    }
    store_as<Oct>(&split.left, below);
    store_as<Oct>(&split.right, above);
}

static void best_split(const Bins& bins, Split& split) {
    best_border(bins, &Bin::entries, split);
}

static void best_plane(const Bins& bins, Split& split) {
    best_border(bins, &Bin::exits, split);
}

}  // namespace rc::kernel::RC_ISA
