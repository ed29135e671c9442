// kernels/triangle.inl - triangles as a ray sees them: one ray and up to eight triangles, or one triangle and eight rays.
//
// The decision. Every corner is sheared by one formula into the frame where the ray runs along z through (0, 0);
// triangles that share a corner see the same numbers. The ray meets a triangle when (0, 0) lies in the closed hull of
// its three sheared corners *exactly*: edge functions of floats are exact in sign when taken in double, where the
// products have no rounding at all. So a closed mesh stays closed under every ray (README.md).
//
// The filter. Single precision only throws out lanes that are outside for certain: a*b - c*d of two separately
// rounded products is never of the wrong sign (rounding is monotone), only sometimes zero. Fused, it would be.

namespace rc::kernel::RC_ISA {
namespace {

struct Candidate {
    float t;
    std::uint32_t instance, primitive;
    // Barycentrics u = weight1 / weight_sum, v = weight2 / weight_sum; a sum of zero says they are divided already.
    double weight1, weight2, weight_sum;
};

static inline HitOut to_hit(const Candidate& c) {
    if (c.weight_sum == 0.0) return {c.t, float(c.weight1), float(c.weight2), c.primitive, c.instance};
    return {c.t, float(c.weight1 / c.weight_sum), float(c.weight2 / c.weight_sum), c.primitive, c.instance};
}

// Sheared corners, z still to be scaled. A lane is a triangle or a ray.
struct Corners {
    Float x[3], y[3], z[3];
};

// Lanes that may be met; the others are outside for certain. Products that overflow are NaN, and such a lane is judged
// by its other edges or by decide().
static inline std::uint32_t maybe_bits(const Corners& c) {
    const Float u = c.x[2] * c.y[1] - c.y[2] * c.x[1];
    const Float v = c.x[0] * c.y[2] - c.y[0] * c.x[2];
    const Float w = c.x[1] * c.y[0] - c.y[1] * c.x[0];
    return ~opposite_bits(min(u, min(v, w)), max(u, max(v, w)));
}

struct Meetings {
    std::uint32_t met;
    Float t;
    Double weight1, weight2, weight_sum;
};

// Which of the lanes `asked` are met, and where; `dz` is the rays' displacement along z for one t. An edge-on triangle
// is not met: its neighbours are.
static inline void decide(const Corners& c, Float dz, std::uint32_t asked, Meetings& m) {
    const Double x0 = widen(c.x[0]), x1 = widen(c.x[1]), x2 = widen(c.x[2]);
    const Double y0 = widen(c.y[0]), y1 = widen(c.y[1]), y2 = widen(c.y[2]);
    const Double w0 = x2 * y1 - y2 * x1;
    const Double w1 = x0 * y2 - y0 * x2;
    const Double w2 = x1 * y0 - y1 * x0;
    const std::uint32_t front = not_negative_bits(w0) & not_negative_bits(w1) & not_negative_bits(w2);
    const std::uint32_t back = not_positive_bits(w0) & not_positive_bits(w1) & not_positive_bits(w2);
    const Double sum = (w0 + w1) + w2;
    m.met = asked & (front | back) & ~(not_negative_bits(sum) & not_positive_bits(sum));
    m.t = narrow(((w0 * widen(c.z[0]) + w1 * widen(c.z[1])) + w2 * widen(c.z[2])) / (sum * widen(dz)));
    m.weight1 = w1;
    m.weight2 = w2;
    m.weight_sum = sum;
}

// The same for one ray and one triangle of a leaf: shear and decision again, lane by lane the same operations.
template <class Ray>
static inline bool decide_one(const Leaf& leaf, std::uint32_t triangle, const Ray& ray, Candidate& c) {
    const float *at_x = row_of(leaf, ray.kx), *at_y = row_of(leaf, ray.ky), *at_z = row_of(leaf, ray.kz);
    const std::uint32_t half = half_of(leaf, triangle);
    double x[3], y[3], z[3];
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t corner = corner_of(half, i);
        const float dz = at_z[corner] - ray.at_kz;
        x[i] = double((at_x[corner] - ray.at_kx) - ray.shear_x * dz);
        y[i] = double((at_y[corner] - ray.at_ky) - ray.shear_y * dz);
        z[i] = double(dz);
    }
    const double w0 = x[2] * y[1] - y[2] * x[1];
    const double w1 = x[0] * y[2] - y[0] * x[2];
    const double w2 = x[1] * y[0] - y[1] * x[0];
    const bool front = (w0 >= 0) & (w1 >= 0) & (w2 >= 0);
    const bool back = (w0 <= 0) & (w1 <= 0) & (w2 <= 0);
    c.weight1 = w1;
    c.weight2 = w2;
    c.weight_sum = (w0 + w1) + w2;
    c.t = float(((w0 * z[0] + w1 * z[1]) + w2 * z[2]) / (c.weight_sum * double(ray.dz)));
    return (front | back) & (c.weight_sum != 0);
}

// A leaf's triangles for one ray; lanes beyond the last mean nothing. Every corner is sheared once, whoever shares it.
template <class Ray>
static inline Corners corners_of(const Leaf& leaf, const Ray& ray) {
    const Row z = load_row(row_of(leaf, ray.kz)) - splat_row(ray.at_kz);
    const Row x = (load_row(row_of(leaf, ray.kx)) - splat_row(ray.at_kx)) - splat_row(ray.shear_x) * z;
    const Row y = (load_row(row_of(leaf, ray.ky)) - splat_row(ray.at_ky)) - splat_row(ray.shear_y) * z;
    const Words first = halves_of(leaf), second = shift_right(first, kCornerBits),
                third = shift_right(second, kCornerBits);
    return {{pick_low(x, first), pick(x, second), pick(x, third)},
            {pick_low(y, first), pick(y, second), pick(y, third)},
            {pick_low(z, first), pick(z, second), pick(z, third)}};
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
