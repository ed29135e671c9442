#include "contract.h"
#include "data.h"

#include "raycore/scene.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace rc {

namespace {

struct Vec3d {
    double x, y, z;
};
Vec3d to_double(const glm::vec3& p) {
    return {double(p.x), double(p.y), double(p.z)};
}
Vec3d operator-(const Vec3d& a, const Vec3d& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

// pbrt's gamma_n: the relative error n roundings can add up to.
constexpr double gamma(int n) {
    return n * 0x1p-24 / (1 - n * 0x1p-24);
}

// Column c of the matrix times v, added up in a fixed order.
double row_of(const glm::mat4x3& m, std::size_t r, const Vec3d& v) {
    return (double(m[0][r]) * v.x + double(m[1][r]) * v.y) + double(m[2][r]) * v.z;
}
double absolute_row_of(const glm::mat4x3& m, std::size_t r, const Vec3d& v) {
    return (std::abs(double(m[0][r])) * v.x + std::abs(double(m[1][r])) * v.y) +
           std::abs(double(m[2][r])) * v.z;
}

Vec3d cross(const Vec3d& a, const Vec3d& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Normals of a triangle in the world: the cross product of its moved edges, turned when the instance mirrors, so that
// the corners still run counter-clockwise seen from its tip.
glm::vec3 unit_normal(const glm::mat4x3& m, const std::array<glm::vec3, 3>& p) {
    const Vec3d e1 = to_double(p[1]) - to_double(p[0]), e2 = to_double(p[2]) - to_double(p[0]);
    const Vec3d w1{row_of(m, 0, e1), row_of(m, 1, e1), row_of(m, 2, e1)};
    const Vec3d w2{row_of(m, 0, e2), row_of(m, 1, e2), row_of(m, 2, e2)};
    const Vec3d n = cross(w1, w2);
    const double length = std::sqrt((n.x * n.x + n.y * n.y) + n.z * n.z);
    return {float(n.x / length), float(n.y / length), float(n.z / length)};
}

}  // namespace

std::array<glm::vec3, 3> Scene::triangle(std::uint32_t instance, std::uint32_t primitive) const {
    RC_EXPECTS(instance < data_->instances.size() && data_->instances[instance].blas,
               "an instance with a mesh");
    const Blas::Data& blas = data_->instances[instance].blas->data();
    RC_EXPECTS(primitive < blas.leaf_of_primitive.size() && blas.leaf_of_primitive[primitive] != kNone,
               "a primitive that was not dropped at build");
    const Leaf leaf(blas.leaves.data(), blas.leaf_of_primitive[primitive]);
    std::uint32_t at = 0;
    while (at + 1 < leaf.size() && leaf.primitive(at) != primitive) ++at;
    return {leaf.corner(at, 0), leaf.corner(at, 1), leaf.corner(at, 2)};
}

SurfacePoint Scene::surface(const Hit& hit) const {
    RC_EXPECTS(!hit.is_miss(), "a hit: a miss lies nowhere");
    const std::array<glm::vec3, 3> p = triangle(hit.instance, hit.primitive);
    const glm::mat4x3& m = data_->instances[hit.instance].world_from_instance;
    const double b1 = double(hit.u), b2 = double(hit.v), b0 = (1.0 - b1) - b2;

    Vec3d at{}, size{};  // the point in the instance's frame, and what its terms amount to
    const Vec3d p0 = to_double(p[0]), p1 = to_double(p[1]), p2 = to_double(p[2]);
    const auto blend = [&](double a, double b, double c) { return (b0 * a + b1 * b) + b2 * c; };
    const auto amount = [&](double a, double b, double c) {
        return (std::abs(b0 * a) + std::abs(b1 * b)) + std::abs(b2 * c);
    };
    at = {blend(p0.x, p1.x, p2.x), blend(p0.y, p1.y, p2.y), blend(p0.z, p1.z, p2.z)};
    size = {amount(p0.x, p1.x, p2.x), amount(p0.y, p1.y, p2.y), amount(p0.z, p1.z, p2.z)};

    // A triangle that lies in a plane through zero has no error across it by the blend, yet the shear that decides hits
    // mixes the axes: it errs by up to five roundings of the triangle's extent, in any direction.
    double extent = 0;
    for (const Vec3d& corner : {p0, p1, p2}) {
        const Vec3d d = corner - at;
        extent = std::max({extent, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    const Vec3d shear_error{extent * gamma(5), extent * gamma(5), extent * gamma(5)};

    SurfacePoint point;
    for (std::size_t r = 0; r < 3; ++r) {
        const double offset = double(m[3][r]);
        point.position[r] = float(row_of(m, r, at) + offset);
        // As pbrt bounds it in single precision: seven roundings of the blend, carried into the world by |M|, and three
        // of the transform. Taken in double here, so only the last rounding is really spent; the rest covers the way
        // back, when a ray from this point is rounded into the instance's frame.
        point.position_error[r] = float((gamma(3) + 1) * absolute_row_of(m, r, size) * gamma(7) +
                                        gamma(3) * (absolute_row_of(m, r, size) + std::abs(offset)) +
                                        absolute_row_of(m, r, shear_error));
    }
    point.normal = unit_normal(m, p);
    point.instance = hit.instance;
    point.primitive = hit.primitive;
    return point;
}

}  // namespace rc
