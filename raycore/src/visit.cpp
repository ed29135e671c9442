#include "visit.h"

#include <algorithm>
#include <cmath>

namespace rc {

std::uint32_t overlapping_children(const kernel::WideNode& node, const Box& box) {
    std::uint32_t met = 0;
    for (int i = 0; i < kernel::kWidth; ++i) {
        bool overlap = true;
        for (std::size_t a = 0; a < 3; ++a)
            overlap =
                overlap && node.bounds[2 * a][i] <= box.max[a] && box.min[a] <= node.bounds[2 * a + 1][i];
        met |= std::uint32_t{overlap} << i;
    }
    return met;
}

void square_distances(const kernel::WideNode& node, const glm::dvec3& point, double (&out)[kernel::kWidth]) {
    for (int i = 0; i < kernel::kWidth; ++i) {
        out[i] = 0;
        for (std::size_t a = 0; a < 3; ++a) {
            const double below = double(node.bounds[2 * a][i]) - point[a];
            const double above = point[a] - double(node.bounds[2 * a + 1][i]);
            const double off = std::max({below, above, 0.0});
            out[i] += off * off;
        }
    }
}

Box local_box(const kernel::InstanceView& instance, const glm::mat4x3& world_from_instance,
              const Box& world_box) {
    // The pad covers world_corner's own rounding, seen from the instance's frame: three roundings of every term.
    double farthest = 0, reach = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        farthest = std::max({farthest, std::abs(double(world_box.min[a])), std::abs(double(world_box.max[a])),
                             std::abs(double(world_from_instance[3][a]))});
        for (std::size_t c = 0; c < 3; ++c)
            reach = std::max(reach, std::abs(double(world_from_instance[c][a])) *
                                        std::max(std::abs(double(instance.blas.min[c])),
                                                 std::abs(double(instance.blas.max[c]))));
    }
    const double pad = 0x1p-20 * (farthest + 3 * reach);
    Box box;
    for (std::size_t r = 0; r < 3; ++r) {
        const auto& column = instance.local_from_world;
        double low = column[3][r], high = column[3][r], slack = std::abs(column[3][r]) * 0x1p-50;
        for (std::size_t c = 0; c < 3; ++c) {
            const double a = column[c][r] * (double(world_box.min[c]) - pad),
                         b = column[c][r] * (double(world_box.max[c]) + pad);
            low += std::min(a, b);
            high += std::max(a, b);
            slack += (std::abs(a) + std::abs(b)) * 0x1p-50;
        }
        // Rounding to float may go inwards; one more part in 2^23 does not.
        box.min[r] = float(low - slack - std::abs(low) * 0x1p-23);
        box.max[r] = float(high + slack + std::abs(high) * 0x1p-23);
    }
    return box;
}

glm::vec3 world_corner(const glm::mat4x3& m, const glm::vec3& p) {
    return ((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3];
}

}  // namespace rc
