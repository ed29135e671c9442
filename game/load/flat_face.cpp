#include "load/flat_face.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace gh::load {
namespace {

struct Facet {
    std::size_t triangle;
    glm::dvec3 normal;  // unit
    glm::dvec3 corner;
    double area;
};

std::vector<Facet> facets_of(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles) {
    std::vector<Facet> facets;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const glm::dvec3 a(positions[triangles[t][0]]), b(positions[triangles[t][1]]),
            c(positions[triangles[t][2]]);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double length = glm::length(normal);
        if (length > 0.0) facets.push_back({t, normal / length, a, 0.5 * length});
    }
    return facets;
}

// Within half a degree and a thousandth of the face's own size, so that a modeller's rounding does no harm.
bool is_in_plane(const Facet& seed, const Facet& other) {
    constexpr double kCosHalfDegree = 0.99996;
    const double size = std::sqrt(seed.area);
    return glm::dot(seed.normal, other.normal) >= kCosHalfDegree &&
           std::abs(glm::dot(seed.normal, other.corner - seed.corner)) <= 1.0e-3 * size + 1.0e-6;
}

struct Cluster {
    std::vector<Facet> facets;  // the seed first: the largest
    double area = 0.0;
};

// Grows a face from the largest facet left until none is left that could make a larger one.
Cluster largest_cluster(std::vector<Facet> facets) {
    std::stable_sort(facets.begin(), facets.end(),
                     [](const Facet& a, const Facet& b) { return a.area > b.area; });
    constexpr int kMostFaces = 64;
    Cluster best;
    for (int face = 0; face < kMostFaces && !facets.empty(); ++face) {
        const Facet seed = facets.front();
        Cluster cluster;
        std::vector<Facet> rest;
        for (const Facet& facet : facets) {
            const bool is_in = is_in_plane(seed, facet);
            (is_in ? cluster.facets : rest).push_back(facet);
            if (is_in) cluster.area += facet.area;
        }
        if (cluster.area > best.area) best = std::move(cluster);
        facets = std::move(rest);
    }
    return best;
}

struct Box2 {
    double area = 0.0;
    double min_u = 0.0, max_u = 0.0, min_v = 0.0, max_v = 0.0;
};

Box2 box_along(const std::vector<glm::dvec3>& points, const glm::dvec3& u, const glm::dvec3& v) {
    Box2 box{0.0, 1e300, -1e300, 1e300, -1e300};
    for (const glm::dvec3& point : points) {
        box.min_u = std::min(box.min_u, glm::dot(point, u));
        box.max_u = std::max(box.max_u, glm::dot(point, u));
        box.min_v = std::min(box.min_v, glm::dot(point, v));
        box.max_v = std::max(box.max_v, glm::dot(point, v));
    }
    box.area = (box.max_u - box.min_u) * (box.max_v - box.min_v);
    return box;
}

}  // namespace

std::optional<FlatFace> largest_flat_face(std::span<const glm::vec3> positions,
                                          std::span<const glm::uvec3> triangles) {
    const std::vector<Facet> facets = facets_of(positions, triangles);
    if (facets.empty()) return std::nullopt;
    const Cluster cluster = largest_cluster(facets);
    const Facet& seed = cluster.facets.front();

    std::vector<glm::dvec3> points;  // relative to the seed, to keep their digits
    for (const Facet& facet : cluster.facets) {
        for (glm::length_t c = 0; c < 3; ++c)
            points.push_back(glm::dvec3(positions[triangles[facet.triangle][c]]) - seed.corner);
    }
    constexpr std::size_t kMostEdges = 96;  // tried as a side; a face of more is round and any will do
    Box2 best;
    glm::dvec3 best_u(0.0), best_v(0.0);
    for (std::size_t i = 0; i < points.size() && i < kMostEdges; ++i) {
        const glm::dvec3 edge = points[i / 3 * 3 + (i + 1) % 3] - points[i];
        const glm::dvec3 across = edge - seed.normal * glm::dot(seed.normal, edge);
        if (!(glm::length(across) > 0.0)) continue;
        const glm::dvec3 u = glm::normalize(across), v = glm::cross(seed.normal, u);
        const Box2 box = box_along(points, u, v);
        if (best_u != glm::dvec3(0.0) && !(box.area < best.area * (1.0 - 1.0e-9))) continue;
        best = box;
        best_u = u;
        best_v = v;
    }
    FlatFace face;
    const glm::dvec3 in_plane =
        best_u * (0.5 * (best.min_u + best.max_u)) + best_v * (0.5 * (best.min_v + best.max_v));
    face.centre = glm::vec3(seed.corner + in_plane);
    face.half_u = glm::vec3(best_u * (0.5 * (best.max_u - best.min_u)));
    face.half_v = glm::vec3(best_v * (0.5 * (best.max_v - best.min_v)));
    face.normal = glm::vec3(seed.normal);
    face.area = static_cast<float>(cluster.area);
    face.whole_area = static_cast<float>(std::accumulate(
        facets.begin(), facets.end(), 0.0, [](double sum, const Facet& f) { return sum + f.area; }));
    face.triangle = seed.triangle;
    return face;
}

}  // namespace gh::load
