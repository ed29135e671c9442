// load/navmesh.h - where a guard can walk: a Recast navmesh, one Detour tile, kept beside its level.
//
// Agent     radius 0.35 m, height 1.8 m, climbs 0.35 m, slopes up to 50 degrees.
// Cost      about 100 ms for a museum of 30 x 40 m, in proportion to its ground.
// Same bits Recast calls the C library, so a bake may differ between machines: levels ship with theirs, and
//           replays carry its hash (Level::navmesh_hash).
// Bad input a navmesh file that is damaged, of another version, or baked from other geometry is not used.
#pragma once

#include "base/result.h"
#include "load/ground.h"
#include "world/level.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace gh::load {

// A tile for dtNavMesh::init. Polygons nobody can get to from one of the ground's places have no flags, so
// that the hollow inside of a column is not taken for a floor. Empty when there is nothing to walk on.
[[nodiscard]] Result<std::vector<std::byte>> bake_navmesh(const Ground& ground);

// levels/foyer.glb -> levels/foyer.navmesh
[[nodiscard]] std::filesystem::path navmesh_path(const std::filesystem::path& level_path);

// Nothing when there is no file, or one that does not fit this ground.
[[nodiscard]] std::optional<std::vector<std::byte>> read_navmesh_file(const std::filesystem::path& path,
                                                                      const Ground& ground);

// Loads the level, bakes, and writes the file beside it.
[[nodiscard]] Result<void> bake_navmesh_file(const std::filesystem::path& level_path);

}  // namespace gh::load
