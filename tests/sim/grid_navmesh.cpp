#include "sim/grid_navmesh.h"

#include <cstring>

#include <recastnavigation/DetourAlloc.h>
#include <recastnavigation/DetourNavMesh.h>
#include <recastnavigation/DetourNavMeshBuilder.h>

namespace gh::test {

namespace {

constexpr int kCorners = 4;
constexpr unsigned short kNoNeighbour = 0xFFFF;

}  // namespace

std::vector<std::byte> grid_navmesh(const Grid& grid) {
    std::vector<unsigned short> verts, polys;
    const int stride = grid.columns + 1;
    for (int row = 0; row <= grid.rows; ++row) {
        for (int column = 0; column <= grid.columns; ++column) {
            verts.insert(verts.end(), {static_cast<unsigned short>(column), 0, static_cast<unsigned short>(row)});
        }
    }
    const std::size_t cells = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
    std::vector<unsigned short> id(cells, kNoNeighbour);
    const auto at = [&](int column, int row) -> unsigned short {
        if (column < 0 || row < 0 || column >= grid.columns || row >= grid.rows) return kNoNeighbour;
        return id[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(column)];
    };
    unsigned short count = 0;
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            if (!grid.is_free(column, row)) continue;
            id[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(column)] = count++;
        }
    }
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            if (at(column, row) == kNoNeighbour) continue;
            const auto corner = [&](int dc, int dr) {
                return static_cast<unsigned short>((row + dr) * stride + column + dc);
            };
            // Clockwise seen from above, as Detour wants them; then the neighbour across each edge.
            polys.insert(polys.end(), {corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0), at(column - 1, row),
                                       at(column, row + 1), at(column + 1, row), at(column, row - 1)});
        }
    }
    const std::vector<unsigned short> flags(count, 1);
    const std::vector<unsigned char> areas(count, 0);

    dtNavMeshCreateParams params;
    std::memset(&params, 0, sizeof(params));
    params.verts = verts.data();
    params.vertCount = static_cast<int>(verts.size() / 3);
    params.polys = polys.data();
    params.polyFlags = flags.data();
    params.polyAreas = areas.data();
    params.polyCount = count;
    params.nvp = kCorners;
    params.walkableHeight = 1.8f;
    params.walkableRadius = 0.3f;
    params.walkableClimb = 0.35f;
    params.bmin[0] = grid.min_x;
    params.bmin[2] = grid.min_z;
    params.bmax[0] = grid.min_x + grid.cell * static_cast<float>(grid.columns);
    params.bmax[1] = 2.0f;
    params.bmax[2] = grid.min_z + grid.cell * static_cast<float>(grid.rows);
    params.cs = grid.cell;
    params.ch = 0.1f;
    params.buildBvTree = true;

    unsigned char* data = nullptr;
    int size = 0;
    if (!dtCreateNavMeshData(&params, &data, &size)) return {};
    std::vector<std::byte> bytes(static_cast<std::size_t>(size));
    std::memcpy(bytes.data(), data, bytes.size());
    dtFree(data);
    return bytes;
}

}  // namespace gh::test
