#include "sim/navigation.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "sim/geometry.h"
#include "world/state.h"

#include <recastnavigation/DetourAlloc.h>
#include <recastnavigation/DetourNavMesh.h>
#include <recastnavigation/DetourNavMeshQuery.h>

namespace gh::sim {

namespace {

constexpr int kMaxNodes = 2048;
constexpr int kMaxPolygons = 512;
constexpr std::array<float, 3> kNearby = {1.5f, 2.0f, 1.5f};  // metres searched around a point

struct MeshDeleter {
    void operator()(dtNavMesh* mesh) const { dtFreeNavMesh(mesh); }
};
struct QueryDeleter {
    void operator()(dtNavMeshQuery* query) const { dtFreeNavMeshQuery(query); }
};

struct OnMesh {
    dtPolyRef polygon = 0;
    glm::vec3 point{0.0f};
};

}  // namespace

struct Navigation::Detour {
    std::unique_ptr<dtNavMesh, MeshDeleter> mesh;
    std::unique_ptr<dtNavMeshQuery, QueryDeleter> query;
    dtQueryFilter filter;

    [[nodiscard]] std::optional<OnMesh> place(const glm::vec3& p) const {
        OnMesh on;
        const dtStatus status = query->findNearestPoly(&p.x, kNearby.data(), &filter, &on.polygon, &on.point.x);
        if (dtStatusFailed(status) || on.polygon == 0) return std::nullopt;
        return on;
    }
};

Navigation::Navigation(const world::Level& level) {
    if (level.navmesh.empty()) return;
    // Detour links polygons inside the tile's bytes, so it gets its own copy, which it frees.
    const std::size_t size = level.navmesh.size();
    auto* tile = static_cast<unsigned char*>(dtAlloc(size, DT_ALLOC_PERM));
    if (tile == nullptr) return;
    std::memcpy(tile, level.navmesh.data(), size);

    auto detour = std::make_unique<Detour>();
    detour->mesh.reset(dtAllocNavMesh());
    if (dtStatusFailed(detour->mesh->init(tile, static_cast<int>(size), DT_TILE_FREE_DATA))) {
        dtFree(tile);  // a tile that was refused was not taken over
        return;
    }
    detour->query.reset(dtAllocNavMeshQuery());
    if (dtStatusFailed(detour->query->init(detour->mesh.get(), kMaxNodes))) return;
    detour_ = std::move(detour);
}

Navigation::~Navigation() = default;

bool Navigation::is_there() const { return detour_ != nullptr; }

std::optional<glm::vec3> Navigation::nearest(const glm::vec3& p) const {
    if (!is_there()) return std::nullopt;
    const std::optional<OnMesh> on = detour_->place(p);
    if (!on) return std::nullopt;
    return on->point;
}

Path Navigation::find_path(const glm::vec3& from, const glm::vec3& to, std::span<glm::vec3> out) const {
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float), "Detour writes corners as triples of floats");
    if (!is_there() || out.empty()) return {};
    const std::optional<OnMesh> start = detour_->place(from);
    const std::optional<OnMesh> goal = detour_->place(to);
    if (!start || !goal) return {};

    std::array<dtPolyRef, kMaxPolygons> polygons;
    int polygon_count = 0;
    detour_->query->findPath(start->polygon, goal->polygon, &start->point.x, &goal->point.x, &detour_->filter,
                             polygons.data(), &polygon_count, kMaxPolygons);
    if (polygon_count <= 0) return {};

    constexpr std::size_t kMaxCorners = world::kMaxPathCorners + 1;  // Detour counts the start as well
    std::array<glm::vec3, kMaxCorners> corners;
    int corner_count = 0;
    const int wanted = static_cast<int>(std::min(out.size() + 1, kMaxCorners));
    const dtStatus status = detour_->query->findStraightPath(&start->point.x, &goal->point.x, polygons.data(),
                                                             polygon_count, &corners[0].x, nullptr, nullptr,
                                                             &corner_count, wanted);
    if (dtStatusFailed(status) || corner_count < 1) return {};
    const auto first = corner_count > 1 ? corners.begin() + 1 : corners.begin();
    const auto last = corners.begin() + corner_count;
    std::copy(first, last, out.begin());
    const bool is_whole = !dtStatusDetail(status, DT_BUFFER_TOO_SMALL) &&
                          polygons[static_cast<std::size_t>(polygon_count - 1)] == goal->polygon;
    return {static_cast<std::size_t>(last - first), is_whole};
}

glm::vec3 Navigation::walk_along(const glm::vec3& from, const glm::vec3& to) const {
    if (!is_there()) return from;
    const std::optional<OnMesh> start = detour_->place(from);
    if (!start) return from;
    std::array<dtPolyRef, 16> visited;
    int visited_count = 0;
    glm::vec3 reached = from;
    const dtStatus status =
        detour_->query->moveAlongSurface(start->polygon, &start->point.x, &to.x, &detour_->filter, &reached.x,
                                         visited.data(), &visited_count, static_cast<int>(visited.size()));
    return dtStatusFailed(status) ? from : reached;
}

glm::vec3 Navigation::straight(const glm::vec3& from, const glm::vec3& to) const {
    if (!is_there()) return from;
    const std::optional<OnMesh> start = detour_->place(from);
    if (!start) return from;
    std::array<dtPolyRef, 64> visited;
    int visited_count = 0;
    float t = 0.0f;
    std::array<float, 3> normal{};
    const dtStatus status =
        detour_->query->raycast(start->polygon, &start->point.x, &to.x, &detour_->filter, &t, normal.data(),
                                visited.data(), &visited_count, static_cast<int>(visited.size()));
    if (dtStatusFailed(status)) return from;
    return start->point + (to - start->point) * std::min(t, 1.0f);
}

std::optional<float> Navigation::distance(const glm::vec3& from, const glm::vec3& to) const {
    std::array<glm::vec3, world::kMaxPathCorners> corners;
    const Path path = find_path(from, to, corners);
    if (!path.arrives) return std::nullopt;
    float metres = 0.0f;
    glm::vec3 at = from;
    for (std::size_t i = 0; i < path.corners; ++i) {
        metres += length_of(corners[i] - at);
        at = corners[i];
    }
    return metres;
}

}  // namespace gh::sim
