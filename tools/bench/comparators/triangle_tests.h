// comparators/triangle_tests.h - other ways to ask whether a ray meets a triangle, for comparison.
//
// A test is made from a ray and then called with corners: `bool test(corners, hit)` fills t, u, v in the way of rc::Hit.
// Intervals and ties are the caller's (closest.h).
#pragma once

#include "raycore/ray.h"

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace comparators {

using Corners = std::array<glm::vec3, 3>;

// Moeller and Trumbore 1997, both sides. Fast and short; leaks between triangles, since neighbours round apart.
template <class Real>
class MoellerTrumbore {
  public:
    using Vector = glm::tvec3<Real>;

    explicit MoellerTrumbore(const rc::Ray& ray) : origin_(ray.origin), direction_(ray.direction) {}

    bool operator()(const Corners& p, rc::Hit& hit) const {
        const Vector a(p[0]), edge1 = Vector(p[1]) - a, edge2 = Vector(p[2]) - a;
        const Vector h = cross(direction_, edge2);
        const Real determinant = dot(edge1, h);
        if (!(determinant != Real(0))) return false;
        const Real inverse = Real(1) / determinant;
        const Vector from_a = origin_ - a;
        const Real u = dot(from_a, h) * inverse;
        const Vector q = cross(from_a, edge1);
        const Real v = dot(direction_, q) * inverse;
        if (!(u >= Real(0) && v >= Real(0) && u + v <= Real(1))) return false;
        hit.t = static_cast<float>(dot(edge2, q) * inverse);
        hit.u = static_cast<float>(u);
        hit.v = static_cast<float>(v);
        return true;
    }

  private:
    static Real dot(const Vector& a, const Vector& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
    static Vector cross(const Vector& a, const Vector& b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }

    Vector origin_, direction_;
};

// Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection": single precision, and double where an edge
// function is zero. Closed at edges; t and barycentrics in single precision.
class Woop {
  public:
    explicit Woop(const rc::Ray& ray) : origin_(ray.origin) {
        const glm::vec3& d = ray.direction;
        z_ = std::abs(d.x) > std::abs(d.y) ? 0 : 1;
        if (std::abs(d.z) >= std::abs(d[z_])) z_ = 2;
        x_ = (z_ + 1) % 3;
        y_ = (z_ + 2) % 3;
        if (d[z_] < 0.0f) std::swap(x_, y_);
        shear_ = {d[x_] / d[z_], d[y_] / d[z_], 1.0f / d[z_]};
    }

    bool operator()(const Corners& p, rc::Hit& hit) const {
        float x[3], y[3], z[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::vec3 c = p[i] - origin_;
            x[i] = c[x_] - shear_.x * c[z_];
            y[i] = c[y_] - shear_.y * c[z_];
            z[i] = shear_.z * c[z_];
        }
        float u = x[2] * y[1] - y[2] * x[1], v = x[0] * y[2] - y[0] * x[2], w = x[1] * y[0] - y[1] * x[0];
        if (u == 0.0f || v == 0.0f || w == 0.0f) {
            u = in_double(x[2], y[1], y[2], x[1]);
            v = in_double(x[0], y[2], y[0], x[2]);
            w = in_double(x[1], y[0], y[1], x[0]);
        }
        if ((u < 0.0f || v < 0.0f || w < 0.0f) && (u > 0.0f || v > 0.0f || w > 0.0f)) return false;
        const float determinant = u + v + w;
        if (!(determinant != 0.0f)) return false;
        const float inverse = 1.0f / determinant;
        hit.t = (u * z[0] + v * z[1] + w * z[2]) * inverse;
        hit.u = v * inverse;
        hit.v = w * inverse;
        return true;
    }

  private:
    static float in_double(float a, float b, float c, float d) {
        return static_cast<float>(static_cast<double>(a) * static_cast<double>(b) -
                                  static_cast<double>(c) * static_cast<double>(d));
    }

    glm::vec3 origin_, shear_;
    std::size_t x_ = 0, y_ = 1, z_ = 2;
};

}  // namespace comparators
