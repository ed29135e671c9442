// kernels/lanes.inl - how the lanes of a wide node are best shared: the inner loop of collapse.cpp.

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

}  // namespace rc::kernel::RC_ISA
