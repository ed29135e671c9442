#include "load/navmesh.h"

#include "load/walkways.h"

#include <recastnavigation/DetourAlloc.h>
#include <recastnavigation/DetourNavMesh.h>
#include <recastnavigation/DetourNavMeshBuilder.h>
#include <recastnavigation/Recast.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

namespace gh::load {
namespace {

constexpr float kRadius = 0.35f, kHeight = 1.8f, kClimb = 0.35f, kSlopeDeg = 50.0f;
constexpr float kCell = kRadius / 4.0f;  // fine enough for a door of one metre, radius taken off both sides
constexpr float kCellHeight = 0.05f;
constexpr float kMostCells = 4.0e6f;  // larger places get coarser cells

struct Free {
    void operator()(rcHeightfield* p) const { rcFreeHeightField(p); }
    void operator()(rcCompactHeightfield* p) const { rcFreeCompactHeightfield(p); }
    void operator()(rcContourSet* p) const { rcFreeContourSet(p); }
    void operator()(rcPolyMesh* p) const { rcFreePolyMesh(p); }
    void operator()(rcPolyMeshDetail* p) const { rcFreePolyMeshDetail(p); }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

const float* floats(const std::vector<glm::vec3>& v) {
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    return &v.data()->x;
}

int cells_up(float metres, float cell) {
    return static_cast<int>(std::ceil(metres / cell - 1.0e-3f));
}
int cells_down(float metres, float cell) {
    return static_cast<int>(std::floor(metres / cell + 1.0e-3f));
}

rcConfig configure(const Ground& ground) {
    rcConfig config{};
    rcCalcBounds(floats(ground.vertices), static_cast<int>(ground.vertices.size()), config.bmin, config.bmax);
    config.bmax[1] += 2.0f * kHeight;  // or the highest floor would lack headroom
    const float width = config.bmax[0] - config.bmin[0], depth = config.bmax[2] - config.bmin[2];
    const float height = config.bmax[1] - config.bmin[1];
    config.cs = std::max({kCell, std::sqrt(width * depth / kMostCells), std::max(width, depth) / 8192.0f});
    config.ch = std::max(kCellHeight, height / static_cast<float>(RC_SPAN_MAX_HEIGHT - 1));
    rcCalcGridSize(config.bmin, config.bmax, config.cs, &config.width, &config.height);
    config.walkableSlopeAngle = kSlopeDeg;
    config.walkableHeight = std::max(3, cells_up(kHeight, config.ch));
    config.walkableClimb = std::max(0, cells_down(kClimb, config.ch));
    config.walkableRadius = cells_up(kRadius, config.cs);
    config.maxEdgeLen = cells_down(12.0f, config.cs);
    config.maxSimplificationError = 1.1f;
    config.minRegionArea = 64;
    config.mergeRegionArea = 400;
    config.maxVertsPerPoly = DT_VERTS_PER_POLYGON;
    config.detailSampleDist = 6.0f * config.cs;
    config.detailSampleMaxError = config.ch;
    return config;
}

Owned<rcHeightfield> rasterize(rcContext& context, const rcConfig& config, const Ground& ground) {
    Owned<rcHeightfield> field(rcAllocHeightfield());
    if (!field || !rcCreateHeightfield(&context, *field, config.width, config.height, config.bmin,
                                       config.bmax, config.cs, config.ch)) {
        return nullptr;
    }
    const auto vertices = static_cast<int>(ground.vertices.size()),
               triangles = static_cast<int>(ground.triangles.size());
    const int* corners = &ground.triangles.data()->x;
    std::vector<unsigned char> areas(ground.triangles.size(), RC_NULL_AREA);
    rcMarkWalkableTriangles(&context, config.walkableSlopeAngle, floats(ground.vertices), vertices, corners,
                            triangles, areas.data());
    if (!rcRasterizeTriangles(&context, floats(ground.vertices), vertices, corners, areas.data(), triangles,
                              *field, config.walkableClimb)) {
        return nullptr;
    }
    rcFilterLowHangingWalkableObstacles(&context, config.walkableClimb, *field);
    rcFilterLedgeSpans(&context, config.walkableHeight, config.walkableClimb, *field);
    rcFilterWalkableLowHeightSpans(&context, config.walkableHeight, *field);
    return field;
}

Owned<rcCompactHeightfield> find_regions(rcContext& context, const rcConfig& config, rcHeightfield& field) {
    Owned<rcCompactHeightfield> compact(rcAllocCompactHeightfield());
    const bool is_built =
        compact &&
        rcBuildCompactHeightfield(&context, config.walkableHeight, config.walkableClimb, field, *compact) &&
        rcErodeWalkableArea(&context, config.walkableRadius, *compact) &&
        rcBuildDistanceField(&context, *compact) &&
        rcBuildRegions(&context, *compact, 0, config.minRegionArea, config.mergeRegionArea);
    return is_built ? std::move(compact) : nullptr;
}

struct Polygons {
    Owned<rcPolyMesh> mesh;
    Owned<rcPolyMeshDetail> detail;
};

std::optional<Polygons> make_polygons(rcContext& context, const rcConfig& config,
                                      rcCompactHeightfield& compact) {
    Owned<rcContourSet> contours(rcAllocContourSet());
    Polygons polygons{Owned<rcPolyMesh>(rcAllocPolyMesh()), Owned<rcPolyMeshDetail>(rcAllocPolyMeshDetail())};
    const bool is_built =
        contours && polygons.mesh && polygons.detail &&
        rcBuildContours(&context, compact, config.maxSimplificationError, config.maxEdgeLen, *contours) &&
        rcBuildPolyMesh(&context, *contours, config.maxVertsPerPoly, *polygons.mesh) &&
        rcBuildPolyMeshDetail(&context, *polygons.mesh, compact, config.detailSampleDist,
                              config.detailSampleMaxError, *polygons.detail);
    if (!is_built) return std::nullopt;
    return polygons;
}

// Empty when Detour refuses.
std::vector<std::byte> make_tile(const rcConfig& config, const Polygons& polygons,
                                 const std::vector<unsigned short>& flags) {
    const rcPolyMesh& mesh = *polygons.mesh;
    const rcPolyMeshDetail& detail = *polygons.detail;
    dtNavMeshCreateParams params{};
    params.verts = mesh.verts;
    params.vertCount = mesh.nverts;
    params.polys = mesh.polys;
    params.polyFlags = flags.data();
    params.polyAreas = mesh.areas;
    params.polyCount = mesh.npolys;
    params.nvp = mesh.nvp;
    params.detailMeshes = detail.meshes;
    params.detailVerts = detail.verts;
    params.detailVertsCount = detail.nverts;
    params.detailTris = detail.tris;
    params.detailTriCount = detail.ntris;
    std::memcpy(params.bmin, mesh.bmin, sizeof(params.bmin));
    std::memcpy(params.bmax, mesh.bmax, sizeof(params.bmax));
    params.walkableHeight = kHeight;
    params.walkableRadius = kRadius;
    params.walkableClimb = kClimb;
    params.cs = config.cs;
    params.ch = config.ch;
    params.buildBvTree = true;
    unsigned char* data = nullptr;
    int size = 0;
    if (!dtCreateNavMeshData(&params, &data, &size)) return {};
    std::vector<std::byte> tile(static_cast<std::size_t>(size));
    std::memcpy(tile.data(), data, tile.size());
    dtFree(data);
    return tile;
}

}  // namespace

Result<std::vector<std::byte>> bake_navmesh(const Ground& ground) {
    if (ground.triangles.empty()) return std::vector<std::byte>{};
    const Error refused{"no navmesh can be made of its ground: it is too large or too intricate"};
    const rcConfig config = configure(ground);
    rcContext context(false);
    const Owned<rcHeightfield> field = rasterize(context, config, ground);
    if (!field) return refused;
    const Owned<rcCompactHeightfield> compact = find_regions(context, config, *field);
    if (!compact) return refused;
    const std::optional<Polygons> polygons = make_polygons(context, config, *compact);
    if (!polygons) return refused;
    if (polygons->mesh->npolys == 0) return std::vector<std::byte>{};

    std::vector<unsigned short> flags(static_cast<std::size_t>(polygons->mesh->npolys), 1);
    const std::vector<std::byte> everything = make_tile(config, *polygons, flags);
    if (everything.empty()) return refused;
    const Walkways walkways(everything);
    const std::vector<bool> is_reached = walkways.reached_polygons(ground.places);
    // When no place lies on the ground at all, the islands may as well stay.
    if (std::find(is_reached.begin(), is_reached.end(), true) == is_reached.end()) return everything;
    for (std::size_t i = 0; i < flags.size(); ++i) flags[i] = is_reached[i] ? 1 : 0;
    return make_tile(config, *polygons, flags);
}

}  // namespace gh::load
