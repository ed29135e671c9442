// kernels/fit.inl - triangle blocks and boxes brought to where the vertices are: the inner loops of a refit.

namespace rc::kernel::RC_ISA {

typedef double Doubles __attribute__((vector_size(32)));

static inline Quad absolute(Quad a) {
    return reinterpret_cast<Quad>(reinterpret_cast<QuadBits>(a) &
                                  QuadBits{INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX});
}

// As fault_of in triangle_check.h, which is the specification.
static inline bool is_worth_keeping(const Quad& a, const Quad& b, const Quad& c) {
    const Quad most = quad_of(kLargestCoordinate);
    const QuadBits near = (absolute(a) <= most) & (absolute(b) <= most) & (absolute(c) <= most);
    if ((near[0] & near[1] & near[2]) == 0) return false;
    // The products of a cross product, three at a time.
    const Doubles from = __builtin_convertvector(a, Doubles);
    const Doubles u = __builtin_convertvector(b, Doubles) - from,
                  v = __builtin_convertvector(c, Doubles) - from;
    const auto differs =
        __builtin_shufflevector(u, u, 1, 2, 0, 3) * __builtin_shufflevector(v, v, 2, 0, 1, 3) !=
        __builtin_shufflevector(u, u, 2, 0, 1, 3) * __builtin_shufflevector(v, v, 1, 2, 0, 3);
    return (differs[0] | differs[1] | differs[2]) != 0;
}

static void fit_block(float* block, std::uint32_t corners, const float* positions, GrowingBox& box,
                      GrowingBox& with_slack) {
    std::uint16_t halves[kWidth];
    __builtin_memcpy(halves, block + 3 * corners, sizeof(halves));
    const std::uint32_t n = (halves[0] >> kCountShift & kCountMask) + 1;
    const float* vertices = block + 3 * corners + (n + 1) / 2 + n;
    Quad corner[kMaxCorners];
    for (std::uint32_t c = 0; c < corners; ++c) {
        std::uint32_t vertex;
        __builtin_memcpy(&vertex, vertices + c, sizeof(vertex));
        const Quad p = corner[c] = corner_of({positions, nullptr}, vertex);
        for (std::uint32_t a = 0; a < 3; ++a) block[a * corners + c] = p[a];
    }
    Quad low = quad_of(0x1.fffffep127f), high = -low, low_of_all = low, high_of_all = high;
    for (std::uint32_t t = 0; t < n; ++t) {
        const auto p = [&](std::uint32_t i) -> const Quad& {
            return corner[std::uint32_t{halves[t]} >> (kCornerBits * i) & (kMaxCorners - 1)];
        };
        const bool is_met = is_worth_keeping(p(0), p(1), p(2));
        halves[t] = std::uint16_t((halves[t] & ~kIsMet) | (is_met ? kIsMet : 0));
        if (!is_met) continue;
        const Quad least = lesser(p(0), lesser(p(1), p(2))), most = greater(p(0), greater(p(1), p(2)));
        const Quad extent = most - least;
        const float of_two = extent[0] > extent[1] ? extent[0] : extent[1];
        const Quad slack = quad_of((of_two > extent[2] ? of_two : extent[2]) * kSlack);
        low = lesser(least, low);
        high = greater(most, high);
        low_of_all = lesser(least - slack, low_of_all);
        high_of_all = greater(most + slack, high_of_all);
    }
    __builtin_memcpy(block + 3 * corners, halves, n * sizeof(halves[0]));
    store_as<Quad>(box.neg_min, -low);
    store_as<Quad>(box.max, high);
    store_as<Quad>(with_slack.neg_min, -low_of_all);
    store_as<Quad>(with_slack.max, high_of_all);
}

static void measure_lanes(const WideNode& node, GrowingBox& box, float (&half_areas)[kWidth]) {
    Oct extent[3];
    empty(box);
    for (int a = 0; a < 3; ++a) {
        const Oct low = load_as<Oct>(node.bounds[2 * a]), high = load_as<Oct>(node.bounds[2 * a + 1]);
        for (int i = 0; i < kWidth; ++i) {
            box.neg_min[a] = -low[i] > box.neg_min[a] ? -low[i] : box.neg_min[a];
            box.max[a] = high[i] > box.max[a] ? high[i] : box.max[a];
        }
        extent[a] = high - low;
    }
    const Oct area = (extent[0] * extent[1] + extent[1] * extent[2]) + extent[2] * extent[0];
    for (int i = 0; i < kWidth; ++i) half_areas[i] = extent[0][i] >= 0.0f ? area[i] : 0.0f;
}

}  // namespace rc::kernel::RC_ISA
