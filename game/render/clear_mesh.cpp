#include "render/clear_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace gh::render {

namespace {

bool is_before(const glm::vec3& a, const glm::vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

// For every vertex the first of those at the same place.
std::vector<std::uint32_t> welded(const std::vector<glm::vec3>& positions) {
    std::vector<std::uint32_t> order(positions.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        if (is_before(positions[a], positions[b])) return true;
        return !is_before(positions[b], positions[a]) && a < b;
    });
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_same = i > 0 && positions[order[i]] == positions[order[i - 1]];
        first[order[i]] = is_same ? first[order[i - 1]] : order[i];
    }
    return first;
}

}  // namespace

bool is_closed_glass(const world::Level& level, const world::Mesh& mesh) {
    const auto is_clear = [&](std::size_t triangle) {
        return level.materials[mesh.materials[triangle]].transmission > 0.0f;
    };
    std::size_t clear_count = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) clear_count += is_clear(t) ? 1u : 0u;
    if (clear_count == 0) return false;

    const std::vector<std::uint32_t> weld = welded(mesh.positions);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges, reversed;
    edges.reserve(clear_count * 3);
    reversed.reserve(clear_count * 3);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!is_clear(t)) continue;
        const glm::uvec3& corner = mesh.triangles[t];
        const std::array<std::uint32_t, 3> at = {weld[corner.x], weld[corner.y], weld[corner.z]};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = at[i], b = at[(i + 1) % 3];
            if (a == b) continue;  // a triangle without area joins its neighbours
            edges.emplace_back(a, b);
            reversed.emplace_back(b, a);
        }
    }
    std::sort(edges.begin(), edges.end());
    std::sort(reversed.begin(), reversed.end());
    return !edges.empty() && edges == reversed;
}

}  // namespace gh::render
