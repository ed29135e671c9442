#include "support/shapes.h"

#include <cmath>
#include <map>
#include <tuple>

namespace test {

namespace {

using Key = std::tuple<int, int, int>;

// The vertex at integer octahedron coordinates, made once.
std::uint32_t ball_vertex(Mesh& mesh, std::map<Key, std::uint32_t>& known, const Key& key,
                          const glm::vec3& centre, float radius) {
    const auto [found, is_new] = known.try_emplace(key, static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) {
        const auto [x, y, z] = key;
        const double dx = x, dy = y, dz = z, length = std::sqrt(dx * dx + dy * dy + dz * dz);
        const auto along = [&](double d) { return static_cast<float>(d / length * double(radius)); };
        mesh.positions.push_back(centre + glm::vec3(along(dx), along(dy), along(dz)));
    }
    return found->second;
}

}  // namespace

Mesh make_ball(const glm::vec3& centre, float radius, std::uint32_t n) {
    Mesh mesh;
    std::map<Key, std::uint32_t> known;
    const int m = static_cast<int>(n);
    for (int octant = 0; octant < 8; ++octant) {
        const int sx = octant & 1 ? -1 : 1, sy = octant & 2 ? -1 : 1, sz = octant & 4 ? -1 : 1;
        const bool turned = sx * sy * sz < 0;
        const auto vertex = [&](int i, int j) {
            return ball_vertex(mesh, known, {sx * i, sy * j, sz * (m - i - j)}, centre, radius);
        };
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            mesh.triangles.push_back(turned ? glm::uvec3(a, c, b) : glm::uvec3(a, b, c));
        };
        for (int i = 0; i < m; ++i) {
            for (int j = 0; i + j < m; ++j) {
                add(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
                if (i + j + 1 < m) add(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
            }
        }
    }
    return mesh;
}

Mesh make_sheet(float half, float height, std::uint32_t n) {
    Mesh mesh;
    const float step = 2.0f * half / static_cast<float>(n);
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i)
            mesh.positions.emplace_back(-half + step * static_cast<float>(i), height,
                                        -half + step * static_cast<float>(j));
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
            mesh.triangles.emplace_back(a, c, b);
            mesh.triangles.emplace_back(b, c, d);
        }
    }
    return mesh;
}

Mesh make_box(const glm::vec3& low, const glm::vec3& high) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.positions.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    const std::uint32_t quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& q : quads) {
        mesh.triangles.emplace_back(q[0], q[1], q[2]);
        mesh.triangles.emplace_back(q[0], q[2], q[3]);
    }
    return mesh;
}

Mesh make_soup(Random& random, std::uint32_t n, float half, float size) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < n; ++i) {
        const glm::vec3 centre = random.in_cube(half);
        for (int c = 0; c < 3; ++c) mesh.positions.push_back(centre + random.in_cube(size));
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return mesh;
}

Mesh parted(const Mesh& mesh) {
    Mesh out;
    for (const glm::uvec3& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(out.positions.size());
        out.triangles.emplace_back(first, first + 1, first + 2);
        for (glm::length_t c = 0; c < 3; ++c) out.positions.push_back(mesh.positions[t[c]]);
    }
    return out;
}

void append(Mesh& a, const Mesh& b) {
    const auto base = static_cast<std::uint32_t>(a.positions.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (const glm::uvec3& t : b.triangles) a.triangles.push_back(t + glm::uvec3(base));
}

}  // namespace test
