#include "placement.h"

#include "triangle_check.h"

#include <algorithm>
#include <cmath>

namespace rc {

namespace {

constexpr double kWorstCondition = 1e7;

double row_sum(double a, double b, double c) {
    return std::abs(a) + std::abs(b) + std::abs(c);
}

// rows[r] of a 3x3 matrix; the largest sum of absolute values in a row.
double norm(const double (&rows)[3][3]) {
    double largest = 0;
    for (const auto& r : rows) largest = std::max(largest, row_sum(r[0], r[1], r[2]));
    return largest;
}

bool invert(const double (&m)[3][3], double (&inverse)[3][3]) {
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
            inverse[c][r] = m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
        }
    }
    const double det = (m[0][0] * inverse[0][0] + m[0][1] * inverse[1][0]) + m[0][2] * inverse[2][0];
    if (!(std::abs(det) > 0) || !std::isfinite(det)) return false;
    for (auto& row : inverse) {
        for (double& value : row) {
            value /= det;
            if (!std::isfinite(value)) return false;
        }
    }
    return true;
}

double largest_coordinate(const Box& box) {
    double largest = 0;
    for (std::size_t a = 0; a < 3; ++a)
        largest = std::max({largest, std::abs(double(box.min[a])), std::abs(double(box.max[a]))});
    return largest;
}

}  // namespace

std::optional<Placement> place(const Instance& instance) {
    if (!instance.blas) return std::nullopt;
    const Box local = instance.blas->bounds();
    if (!(local.min.x <= local.max.x)) return std::nullopt;

    const glm::mat4x3& world_from_local = instance.world_from_instance;
    double m[3][3], inverse[3][3], offset[3];
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) m[r][c] = double(world_from_local[c][r]);
        offset[r] = double(world_from_local[3][r]);
    }
    if (!invert(m, inverse)) return std::nullopt;
    const double stretch = norm(m), condition = stretch * norm(inverse);
    const double farthest = std::max({std::abs(offset[0]), std::abs(offset[1]), std::abs(offset[2])});
    if (!(condition <= kWorstCondition)) return std::nullopt;

    Placement p;
    p.condition = float(condition) * 1.001f;
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) p.local_from_world[4 * r + c] = inverse[r][c];
        p.local_from_world[4 * r + 3] =
            -((inverse[r][0] * offset[0] + inverse[r][1] * offset[1]) + inverse[r][2] * offset[2]);
    }

    // What a ray's way into the instance's frame may err by, seen from the world, apart from the part that grows with
    // the ray's own origin (traverse.inl adds that one). Sixteen roundings; eleven can be spent.
    const double pad = 0x1p-20 * (condition * farthest + stretch * largest_coordinate(local));
    for (std::size_t r = 0; r < 3; ++r) {
        double low = offset[r], high = offset[r];
        for (std::size_t c = 0; c < 3; ++c) {
            const double a = m[r][c] * double(local.min[c]), b = m[r][c] * double(local.max[c]);
            low += std::min(a, b);
            high += std::max(a, b);
        }
        p.world_box.min[r] = float(low - pad);
        p.world_box.max[r] = float(high + pad);
        if (!(low - pad >= -double(kLargestCoordinate) && high + pad <= double(kLargestCoordinate)))
            return std::nullopt;
    }
    return p;
}

}  // namespace rc
