// kernels/lanes.inl - how the lanes of a wide node are best shared, and who gets which: the inner loops of collapse.cpp.

namespace rc::kernel::RC_ISA {

static inline OctBits bits_of(std::int32_t a) {
    return OctBits{a, a, a, a, a, a, a, a};
}

// Every number one lane up, `first` in the lowest.
template <class Vector>
static inline Vector one_up(const Vector& v, const Vector& first) {
    return __builtin_shufflevector(first, v, 0, 8, 9, 10, 11, 12, 13, 14);
}

static void share_lanes(const LaneCosts& left, const LaneCosts& right, LaneCosts& both,
                        std::uint8_t (&lefts)[kWidth]) {
    const Oct infinite = oct_of(__builtin_inff());
    Oct area = infinite, rest = load_as<Oct>(right.area);
    OctBits nodes = bits_of(0), best = nodes, nodes_of_rest = load_as<OctBits>(right.nodes);
    for (std::int32_t k = 1; k <= left.lanes && k < kWidth; ++k) {
        // In lane i, what the right one costs with the i + 1 - k lanes that k leave over.
        rest = one_up(rest, infinite);
        nodes_of_rest = one_up(nodes_of_rest, bits_of(0));
        const Oct sum = oct_of(left.area[k - 1]) + rest;
        const auto better = sum < area;
        area = better ? sum : area;
        nodes = better ? bits_of(std::int32_t(left.nodes[k - 1])) + nodes_of_rest : nodes;
        best = better ? bits_of(k) : best;
    }
    // More lanes never cost more, since neither side's do.
    best = area < one_up(area, infinite) ? best : bits_of(0);
    both.lanes = left.lanes + right.lanes < kWidth ? left.lanes + right.lanes : kWidth;
    store_as<Oct>(both.area, area);
    store_as<OctBits>(both.nodes, nodes);
    for (int i = 1; i < kWidth; ++i) {
        lefts[i] = std::uint8_t(best[i]);
        both.nodes[i] = best[i] == 0 ? both.nodes[i - 1] : both.nodes[i];
    }
}

// Rows become columns.
static inline void transpose(Oct (&m)[kWidth]) {
    Oct two[kWidth], four[kWidth];
    for (int i = 0; i < kWidth; i += 2) {
        two[i] = __builtin_shufflevector(m[i], m[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
        two[i + 1] = __builtin_shufflevector(m[i], m[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
    }
    for (int i = 0; i < kWidth; i += 4) {
        for (int k = 0; k < 2; ++k) {
            const Oct &a = two[i + k], &b = two[i + k + 2];
            four[i + 2 * k] = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
            four[i + 2 * k + 1] = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
        }
    }
    for (int i = 0; i < 4; ++i) {
        m[i] = __builtin_shufflevector(four[i], four[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        m[i + 4] = __builtin_shufflevector(four[i], four[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    }
}

// The columns of eight nodes: minima, `first`, maxima, `count`.
static inline void load_columns(const BinaryNode* const (&nodes)[kWidth], Oct (&columns)[kWidth]) {
    for (int i = 0; i < kWidth; ++i) columns[i] = load_as<Oct>(nodes[i]);
    transpose(columns);
}

static void fill_boxes(const BinaryNode* (&children)[kWidth], WideNode& node) {
    Oct c[kWidth];
    load_columns(children, c);
    const Oct x = c[4] - c[0], y = c[5] - c[1], z = c[6] - c[2];
    const OctBits items = reinterpret_cast<OctBits>(c[7]) & bits_of(INT32_MAX);
    const Oct worth = ((x * y + y * z) + z * x) / __builtin_convertvector(items, Oct);
    // A child's lane is how many come before it.
    const OctBits lane{0, 1, 2, 3, 4, 5, 6, 7};
    OctBits before = bits_of(0);
    for (int i = 0; i < kWidth; ++i) {
        const Oct other = oct_of(worth[i]);
        before -= (other < worth) | ((other == worth) & (lane > bits_of(i)));
    }
    const BinaryNode* as_given[kWidth];
    for (int i = 0; i < kWidth; ++i) as_given[i] = children[i];
    for (int i = 0; i < kWidth; ++i) children[before[i]] = as_given[i];
    load_columns(children, c);
    for (int a = 0; a < 3; ++a) {
        store_as<Oct>(node.bounds[2 * a], c[a]);
        store_as<Oct>(node.bounds[2 * a + 1], c[a + 4]);
    }
}

}  // namespace rc::kernel::RC_ISA
