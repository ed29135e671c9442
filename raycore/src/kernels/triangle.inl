// kernels/triangle.inl - one ray against up to eight triangles.
//
// The decision. Every corner is sheared by one formula into the frame where the ray runs along z through (0, 0);
// triangles that share a corner see the same numbers. The ray meets a triangle when (0, 0) lies in the closed hull of
// its three sheared corners *exactly*: edge functions of floats are exact in sign when taken in double, where the
// products have no rounding at all. So a closed mesh stays closed under every ray (raycore/README.md).
//
// The filter. Single precision only throws out lanes that are outside for certain: a*b - c*d of two separately
// rounded products is never of the wrong sign (rounding is monotone), only sometimes zero. Fused, it would be.

namespace rc::kernel::RC_ISA {

struct Candidate {
    float t;
    std::uint32_t instance, primitive;
    double weight1, weight2, weight_sum;  // barycentrics u = weight1 / weight_sum, v = weight2 / weight_sum
};

struct ShearedBlock {
    float x[3][kWidth], y[3][kWidth], z[3][kWidth];
};

// Whether the lane is met at all, and where. An edge-on triangle is not met: its neighbours are.
static inline bool decide(const ShearedBlock& block, int lane, float dz, Candidate& c) {
    const double x0 = double(block.x[0][lane]), x1 = double(block.x[1][lane]), x2 = double(block.x[2][lane]);
    const double y0 = double(block.y[0][lane]), y1 = double(block.y[1][lane]), y2 = double(block.y[2][lane]);
    const double w0 = x2 * y1 - y2 * x1;
    const double w1 = x0 * y2 - y0 * x2;
    const double w2 = x1 * y0 - y1 * x0;
    const bool front = (w0 >= 0) & (w1 >= 0) & (w2 >= 0);
    const bool back = (w0 <= 0) & (w1 <= 0) & (w2 <= 0);
    const double sum = (w0 + w1) + w2;
    if (!((front | back) & (sum != 0))) return false;
    const double z0 = double(block.z[0][lane]), z1 = double(block.z[1][lane]), z2 = double(block.z[2][lane]);
    c.t = float(((w0 * z0 + w1 * z1) + w2 * z2) / (sum * double(dz)));
    c.weight1 = w1;
    c.weight2 = w2;
    c.weight_sum = sum;
    return true;
}

// Lanes that may be met, and all lanes sheared.
static inline std::uint32_t filter(const float* rows, std::uint32_t count, const LocalRay& ray,
                                   ShearedBlock& out) {
    Float x[3], y[3], z[3];
    const Float ox = splat(ray.at_kx), oy = splat(ray.at_ky), oz = splat(ray.at_kz);
    const Float sx = splat(ray.shear_x), sy = splat(ray.shear_y);
    const std::uint32_t to_x = std::uint32_t(ray.kx) * count, to_y = std::uint32_t(ray.ky) * count,
                        to_z = std::uint32_t(ray.kz) * count;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const float* corner = rows + 3 * i * count;
        z[i] = load(corner + to_z) - oz;
        x[i] = (load(corner + to_x) - ox) - sx * z[i];
        y[i] = (load(corner + to_y) - oy) - sy * z[i];
    }
    const Float u = x[2] * y[1] - y[2] * x[1];
    const Float v = x[0] * y[2] - y[0] * x[2];
    const Float w = x[1] * y[0] - y[1] * x[0];
    // A lane whose products overflow is NaN there, and judged by the others or by decide().
    const std::uint32_t outside = opposite_bits(min(u, min(v, w)), max(u, max(v, w)));
    const std::uint32_t maybe = ~outside & ((1u << count) - 1);
    if (maybe != 0) {
        for (int i = 0; i < 3; ++i) {
            store(out.x[i], x[i]);
            store(out.y[i], y[i]);
            store(out.z[i], z[i]);
        }
    }
    return maybe;
}

}  // namespace rc::kernel::RC_ISA
