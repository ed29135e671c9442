#include "triangle_check.h"

#include "raycore/mesh.h"

#include <algorithm>
#include <cmath>

namespace rc {

namespace {

bool is_usable(const glm::vec3& p) {  // false for NaN as well
    return std::abs(p.x) <= kLargestCoordinate && std::abs(p.y) <= kLargestCoordinate &&
           std::abs(p.z) <= kLargestCoordinate;
}

}  // namespace

TriangleFault fault_of(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    if (!(is_usable(a) && is_usable(b) && is_usable(c))) return TriangleFault::NotFinite;
    // In double, so that neither a triangle of 1e-20 m vanishes nor one of 1e15 m overflows.
    const double x1 = double(b.x) - double(a.x), y1 = double(b.y) - double(a.y),
                 z1 = double(b.z) - double(a.z);
    const double x2 = double(c.x) - double(a.x), y2 = double(c.y) - double(a.y),
                 z2 = double(c.z) - double(a.z);
    const bool has_area = y1 * z2 != z1 * y2 || z1 * x2 != x1 * z2 || x1 * y2 != y1 * x2;
    return has_area ? TriangleFault::None : TriangleFault::ZeroArea;
}

TriangleFault fault_of(std::span<const glm::vec3> positions, const glm::uvec3& triangle) {
    if (std::max({triangle.x, triangle.y, triangle.z}) >= positions.size())
        return TriangleFault::IndexOutOfRange;
    return fault_of(positions[triangle.x], positions[triangle.y], positions[triangle.z]);
}

void count(TriangleFault fault, MeshReport& report) {
    switch (fault) {
        case TriangleFault::None:
            break;
        case TriangleFault::IndexOutOfRange:
            ++report.index_out_of_range;
            break;
        case TriangleFault::NotFinite:
            ++report.not_finite;
            break;
        case TriangleFault::ZeroArea:
            ++report.zero_area;
            break;
    }
}

MeshReport check_mesh(const MeshView& mesh) {
    MeshReport report;
    report.triangles = mesh.triangles.size();
    for (const glm::uvec3& triangle : mesh.triangles) {
        count(fault_of(mesh.positions, triangle), report);
    }
    return report;
}

}  // namespace rc
