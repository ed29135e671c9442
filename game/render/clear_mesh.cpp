#include "render/clear_mesh.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace gh::render {

namespace {

constexpr float kSamePlace = 4e-7f;  // of the mesh's extent: sin(2 pi) is not 0 where a seam was computed

// Along one axis: the number of the first value that lies no more than `reach` below each.
std::vector<std::uint32_t> steps_along(const std::vector<glm::vec3>& positions, glm::length_t axis,
                                       float reach) {
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(positions[a][axis], a) < std::tie(positions[b][axis], b);
    });
    std::vector<std::uint32_t> steps(positions.size());
    std::uint32_t first = 0;
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        if (positions[order[i]][axis] - positions[order[first]][axis] > reach) first = i;
        steps[order[i]] = first;
    }
    return steps;
}

// For every vertex the first of those at the same place.
std::vector<std::uint32_t> welded(const std::vector<glm::vec3>& positions) {
    glm::vec3 low(rc::kInfinity), high(-rc::kInfinity);
    for (const glm::vec3& p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::vec3 size = high - low;
    const float reach = kSamePlace * std::max({size.x, size.y, size.z});
    const std::array<std::vector<std::uint32_t>, 3> steps = {
        steps_along(positions, 0, reach), steps_along(positions, 1, reach), steps_along(positions, 2, reach)};
    const auto place = [&](std::uint32_t i) { return std::tie(steps[0][i], steps[1][i], steps[2][i]); };
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return place(a) != place(b) ? place(a) < place(b) : a < b;
    });
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_same = i > 0 && place(order[i]) == place(order[i - 1]);
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
