#include "load/open_edges.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace gh::load {
namespace {

bool comes_before(const glm::vec3& a, const glm::vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

// For every vertex the first (in order of position) that lies in the same place. -0 and +0 are one place.
std::vector<std::uint32_t> weld(const std::vector<glm::vec3>& positions) {
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        if (comes_before(positions[a], positions[b])) return true;
        return !comes_before(positions[b], positions[a]) && a < b;
    });
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_same = i > 0 && !comes_before(positions[order[i - 1]], positions[order[i]]);
        first[order[i]] = is_same ? first[order[i - 1]] : order[i];
    }
    return first;
}

}  // namespace

OpenEdges find_open_edges(const world::Mesh& mesh) {
    const std::vector<std::uint32_t> corner_of = weld(mesh.positions);
    using Edge = std::array<std::uint32_t, 2>;
    std::vector<Edge> edges;
    for (const glm::uvec3& t : mesh.triangles) {
        const std::array<std::uint32_t, 3> corners{corner_of[t[0]], corner_of[t[1]], corner_of[t[2]]};
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
            edges.push_back({low, high});
        }
    }
    std::sort(edges.begin(), edges.end());
    OpenEdges open;
    constexpr std::size_t kMostNamed = 3;
    for (std::size_t begin = 0; begin < edges.size();) {
        std::size_t end = begin;
        while (end < edges.size() && edges[end] == edges[begin]) ++end;
        if (end - begin == 1) {
            ++open.count;
            const glm::vec3 middle =
                0.5f * (mesh.positions[edges[begin][0]] + mesh.positions[edges[begin][1]]);
            if (open.middles.size() < kMostNamed) open.middles.push_back(middle);
        }
        begin = end;
    }
    return open;
}

}  // namespace gh::load
