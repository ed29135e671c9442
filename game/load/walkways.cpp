#include "load/walkways.h"

#include <recastnavigation/DetourAlloc.h>
#include <recastnavigation/DetourNavMesh.h>
#include <recastnavigation/DetourNavMeshQuery.h>

#include <array>
#include <cstring>
#include <utility>

namespace gh::load {

struct Walkways::Detour {
    struct FreeMesh {
        void operator()(dtNavMesh* owned) const { dtFreeNavMesh(owned); }
    };
    struct FreeQuery {
        void operator()(dtNavMeshQuery* owned) const { dtFreeNavMeshQuery(owned); }
    };
    std::unique_ptr<dtNavMesh, FreeMesh> mesh;
    std::unique_ptr<dtNavMeshQuery, FreeQuery> query;
    dtQueryFilter filter;

    [[nodiscard]] const dtMeshTile& tile() const { return *std::as_const(*mesh).getTile(0); }

    // 0: none.
    [[nodiscard]] dtPolyRef polygon_at(const glm::vec3& place) const {
        constexpr std::array<float, 3> kStride{0.6f, 1.0f, 0.6f};
        dtPolyRef polygon = 0;
        query->findNearestPoly(&place.x, kStride.data(), &filter, &polygon, nullptr);
        return polygon;
    }
    [[nodiscard]] std::size_t number_of(dtPolyRef polygon) const { return mesh->decodePolyIdPoly(polygon); }
};

Walkways::Walkways(std::span<const std::byte> tile) {
    if (tile.empty()) return;
    auto* data = static_cast<unsigned char*>(dtAlloc(tile.size(), DT_ALLOC_PERM));
    if (data == nullptr) return;
    std::memcpy(data, tile.data(), tile.size());
    auto detour = std::make_unique<Detour>();
    detour->mesh.reset(dtAllocNavMesh());
    if (dtStatusFailed(detour->mesh->init(data, static_cast<int>(tile.size()), DT_TILE_FREE_DATA))) {
        dtFree(data);
        return;
    }
    detour->query.reset(dtAllocNavMeshQuery());
    if (dtStatusFailed(detour->query->init(detour->mesh.get(), 512))) return;
    detour_ = std::move(detour);
}

Walkways::~Walkways() = default;

std::size_t Walkways::polygon_count() const {
    return detour_ ? static_cast<std::size_t>(detour_->tile().header->polyCount) : 0;
}

std::vector<bool> Walkways::reached_polygons(std::span<const glm::vec3> places) const {
    std::vector<bool> is_reached(polygon_count(), false);
    if (!detour_) return is_reached;
    std::vector<std::size_t> open;
    for (const glm::vec3& place : places) {
        const dtPolyRef polygon = detour_->polygon_at(place);
        if (polygon != 0) open.push_back(detour_->number_of(polygon));
    }
    const dtMeshTile& tile = detour_->tile();
    while (!open.empty()) {
        const std::size_t at = open.back();
        open.pop_back();
        if (is_reached[at]) continue;
        is_reached[at] = true;
        for (unsigned link = tile.polys[at].firstLink; link != DT_NULL_LINK; link = tile.links[link].next) {
            if (tile.links[link].ref != 0) open.push_back(detour_->number_of(tile.links[link].ref));
        }
    }
    return is_reached;
}

bool Walkways::is_on_floor(const glm::vec3& place) const {
    return detour_ && detour_->polygon_at(place) != 0;
}

bool Walkways::is_reached(const glm::vec3& place, const std::vector<bool>& reached) const {
    if (!detour_) return false;
    const dtPolyRef polygon = detour_->polygon_at(place);
    return polygon != 0 && reached[detour_->number_of(polygon)];
}

bool Walkways::is_in_reach(const glm::vec3& thing, float reach, float up,
                           const std::vector<bool>& reached) const {
    if (!detour_) return false;
    const std::array<float, 3> half{reach, up, reach};
    std::array<dtPolyRef, 256> polygons{};
    int count = 0;
    detour_->query->queryPolygons(&thing.x, half.data(), &detour_->filter, polygons.data(), &count,
                                  static_cast<int>(polygons.size()));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (!reached[detour_->number_of(polygons[i])]) continue;
        glm::vec3 nearest{0.0f};
        bool is_over = false;
        if (dtStatusFailed(detour_->query->closestPointOnPoly(polygons[i], &thing.x, &nearest.x, &is_over)))
            continue;
        const float dx = nearest.x - thing.x, dz = nearest.z - thing.z, dy = nearest.y - thing.y;
        if (dx * dx + dz * dz <= reach * reach && dy * dy <= up * up) return true;
    }
    return false;
}

}  // namespace gh::load
