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
namespace {

struct Candidate {
    float t;
    std::uint32_t instance, primitive;
    double weight1, weight2, weight_sum;  // barycentrics u = weight1 / weight_sum, v = weight2 / weight_sum
};

// Lanes that may be met; the others are outside for certain.
static inline std::uint32_t filter(const float* rows, std::uint32_t count, const LocalRay& ray) {
    Float x[3], y[3];
    const Float ox = splat(ray.at_kx), oy = splat(ray.at_ky), oz = splat(ray.at_kz);
    const Float sx = splat(ray.shear_x), sy = splat(ray.shear_y);
    const std::uint32_t to_x = std::uint32_t(ray.kx) * count, to_y = std::uint32_t(ray.ky) * count,
                        to_z = std::uint32_t(ray.kz) * count;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const float* corner = rows + 3 * i * count;
        const Float z = load(corner + to_z) - oz;
        x[i] = (load(corner + to_x) - ox) - sx * z;
        y[i] = (load(corner + to_y) - oy) - sy * z;
    }
    const Float u = x[2] * y[1] - y[2] * x[1];
    const Float v = x[0] * y[2] - y[0] * x[2];
    const Float w = x[1] * y[0] - y[1] * x[0];
    // A lane whose products overflow is NaN there, and judged by the others or by decide().
    const std::uint32_t outside = opposite_bits(min(u, min(v, w)), max(u, max(v, w)));
    return ~outside & ((1u << count) - 1);
}

// Whether the lane is met at all, and where: the same shear again, then in double. An edge-on triangle is not met: its
// neighbours are.
static inline bool decide(const float* rows, std::uint32_t count, std::uint32_t lane, const LocalRay& ray,
                          Candidate& c) {
    const float *at_x = rows + std::uint32_t(ray.kx) * count + lane,
                *at_y = rows + std::uint32_t(ray.ky) * count + lane,
                *at_z = rows + std::uint32_t(ray.kz) * count + lane;
    double x[3], y[3], z[3];
    for (std::uint32_t i = 0; i < 3; ++i) {
        const float z_of = at_z[3 * i * count] - ray.at_kz;
        x[i] = double((at_x[3 * i * count] - ray.at_kx) - ray.shear_x * z_of);
        y[i] = double((at_y[3 * i * count] - ray.at_ky) - ray.shear_y * z_of);
        z[i] = double(z_of);
    }
    const double w0 = x[2] * y[1] - y[2] * x[1];
    const double w1 = x[0] * y[2] - y[0] * x[2];
    const double w2 = x[1] * y[0] - y[1] * x[0];
    const bool front = (w0 >= 0) & (w1 >= 0) & (w2 >= 0);
    const bool back = (w0 <= 0) & (w1 <= 0) & (w2 <= 0);
    const double sum = (w0 + w1) + w2;
    c.t = float(((w0 * z[0] + w1 * z[1]) + w2 * z[2]) / (sum * double(ray.dz)));  // NaN when the sum is zero
    c.weight1 = w1;
    c.weight2 = w2;
    c.weight_sum = sum;
    return (front | back) & (sum != 0);
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
